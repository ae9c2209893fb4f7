// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "scene/BodyGeometry.h"

#include <nlohmann/json_fwd.hpp>
#include <span>

namespace handwheel {

// The storage format of a kind of shape. Those of core/scene are known; a kind of document can add its own.
struct GeometryFormat {
  std::string_view kind;  // BodyGeometry::kind()
  // Writes the arrays of a shape to blobs below this folder. Returns its JSON, to which the kind is added.
  nlohmann::json (*write)(const BodyGeometry& geometry, const std::string& folder, Container& container);
  // Reads a shape; accepts any input. An error: nothing of it can be used.
  Result<GeometryPointer> (*read)(const nlohmann::json& described, const std::string& folder,
                                  const Container& container, std::vector<Error>& damage);
};

// Writes the shape of a body: its arrays to blobs below this folder. Returns its JSON, {"kind", …}. A shape without a
// format is written as a mesh, its surface.
nlohmann::json writeGeometry(const BodyGeometry& geometry, const std::string& folder, Container& container,
                             std::span<const GeometryFormat> own = {});

// Returns the shape of a body as an UnknownGeometry, which keeps all of it.
GeometryPointer keptAsItIs(const nlohmann::json& described, const std::string& folder, const Container& container,
                           bool isDamaged);

// Reads the shape of a body from its JSON and the blobs below its folder; accepts any input, and never returns null. A
// shape that cannot be read, or is of a kind unknown to this program, is kept unchanged; the latter is no damage.
// damage: EntryDamaged {folder}, Unsupported, and the errors of the shapes.
GeometryPointer readGeometry(const nlohmann::json& described, const std::string& folder, const Container& container,
                             std::vector<Error>& damage, std::span<const GeometryFormat> own = {});

}  // namespace handwheel
