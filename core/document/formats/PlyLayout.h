// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "document/formats/MeshFormat.h"
#include "document/formats/PlyHeader.h"

namespace handwheel {

// What one property of a row means to a mesh.
struct PlyField {
  enum class Role { X, Y, Z, Corners, Skipped };
  Role role = Role::Skipped;
  PlyType type = PlyType::Float32;
  std::optional<PlyType> countType;
};

// What the rows of an element mean to a mesh.
struct PlyLayout {
  enum class Kind { Vertices, Faces, Strips, Other };
  Kind kind = Kind::Other;
  const char* rowsName = "rows";  // for messages
  std::vector<PlyField> fields;
  std::vector<LostAttribute> lost;
  std::string missing;  // a property without which the rows cannot be understood
};

PlyLayout layoutOf(const PlyElement& element);

// Of the vertices' coordinates: single precision only when all are.
NumberType coordinateType(const PlyHeader& header);

}  // namespace handwheel
