// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "scene/BodyGeometry.h"

#include <nlohmann/json_fwd.hpp>
#include <span>

namespace handwheel {

// How a kind of shapes is stored. Those of core/scene are known; a kind of document brings those of its own.
struct GeometryFormat {
  std::string_view kind;  // BodyGeometry::kind()
  // Writes the arrays of a shape to blobs below this folder. Returns its JSON, to which the kind is added.
  nlohmann::json (*write)(const BodyGeometry& geometry, const std::string& folder, Container& container);
  // Reads it; accepts any input. An error: nothing of it can be used.
  Result<GeometryPointer> (*read)(const nlohmann::json& described, const std::string& folder,
                                  const Container& container, std::vector<Error>& damage);
};

// Writes the shape of a body: its arrays to blobs below this folder. Returns its JSON, {"kind", …}. A shape that has no
// format becomes a mesh, its surface.
nlohmann::json writeGeometry(const BodyGeometry& geometry, const std::string& folder, Container& container,
                             std::span<const GeometryFormat> own = {});

// The shape of a body as an UnknownGeometry, which keeps all of it.
GeometryPointer keptAsItIs(const nlohmann::json& described, const std::string& folder, const Container& container,
                           bool isDamaged);

// Reads the shape of a body from its JSON and the blobs below its folder; accepts any input, and never returns null.
// What cannot be read, or is of a kind that this program does not know, is kept as it is; the latter is no damage.
// damage: EntryDamaged {folder}, Unsupported, and the errors of the shapes.
GeometryPointer readGeometry(const nlohmann::json& described, const std::string& folder, const Container& container,
                             std::vector<Error>& damage, std::span<const GeometryFormat> own = {});

}  // namespace handwheel
