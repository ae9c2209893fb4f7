// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "document/formats/MeshFormat.h"
#include "document/formats/ply/PlyHeader.h"

namespace handwheel {

// The role of one property of a row in a mesh.
struct PlyField {
  enum class Role { X, Y, Z, Corners, Skipped };
  Role role = Role::Skipped;
  PlyType type = PlyType::Float32;
  std::optional<PlyType> countType;
};

// The role of the rows of an element in a mesh.
struct PlyLayout {
  enum class Kind { Vertices, Faces, Strips, Other };
  Kind kind = Kind::Other;
  const char* rowsName = "rows";  // for messages
  std::vector<PlyField> fields;
  std::vector<std::pair<LostAttribute, std::string>> lost;  // lost attributes, with their names in the file
  std::string missing;  // name of a missing property that the rows need; empty: none is missing
};

// Returns the layout of the rows of an element.
PlyLayout layoutOf(const PlyElement& element);

// Returns the number type of the vertices' coordinates: single precision only if all coordinates have it.
NumberType coordinateType(const PlyHeader& header);

}  // namespace handwheel
