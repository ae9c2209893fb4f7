// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "scene/BodyGeometry.h"

#include <nlohmann/json_fwd.hpp>
#include <span>

namespace handwheel {

// The storage format of a kind of shape. The formats of the shapes in core/scene are known; a kind of document can add
// its own.
struct GeometryFormat {
  std::string_view kind;  // BodyGeometry::kind()
  // Writes the arrays of a shape to blobs below the folder. Returns the JSON of the shape, to which its kind is added.
  nlohmann::json (*write)(const BodyGeometry& geometry, const std::string& folder, Container& container);
  // Reads a shape; the input may be arbitrary. Returns an error if nothing of the shape can be used.
  Result<GeometryPointer> (*read)(const nlohmann::json& described, const std::string& folder,
                                  const Container& container, std::vector<Error>& damage);
};

// Writes the shape of a body. Its arrays are written to blobs below the folder. Returns the JSON of the shape, {"kind",
// …}. A shape without a format is written as the mesh of its surface.
nlohmann::json writeGeometry(const BodyGeometry& geometry, const std::string& folder, Container& container,
                             std::span<const GeometryFormat> own = {});

// Returns the stored shape of a body as an UnknownGeometry, which keeps all its data.
GeometryPointer keptAsItIs(const nlohmann::json& described, const std::string& folder, const Container& container,
                           bool isDamaged);

// Reads the shape of a body from its JSON and the blobs below its folder. The input may be arbitrary; the result is
// never null. A shape that cannot be read, or whose kind is unknown to this program, is kept unchanged; an unknown kind
// is no damage. damage: receives EntryDamaged {folder}, Unsupported, and the errors of the shapes.
GeometryPointer readGeometry(const nlohmann::json& described, const std::string& folder, const Container& container,
                             std::vector<Error>& damage, std::span<const GeometryFormat> own = {});

}  // namespace handwheel
