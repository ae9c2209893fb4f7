// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "mesh/structure/TriangleSoup.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

// Content of the model parts of a 3MF file, before it is assembled. The format is that of the 3MF Core Specification
// 1.3 and the production extension 1.1. Lengths are converted to millimetres.
namespace handwheel {

using ThreeMfTransform = Eigen::Transform<double, 3, Eigen::AffineCompact>;

// A build item, or a component of an object.
struct ThreeMfReference {
  std::string part;  // path of the part in the file; empty: the same part
  std::uint32_t object = 0;
  ThreeMfTransform transform = ThreeMfTransform::Identity();
  InputPosition position;
};

// An object of a 3MF file: a mesh and components.
struct ThreeMfObject {
  TriangleSoup mesh;  // every point is finite, every index in range
  std::vector<ThreeMfReference> components;
  bool isOther = false;  // objects of its type must not be built
};

// A model part of a 3MF file.
struct ThreeMfPart {
  std::map<std::uint32_t, ThreeMfObject> objects;
  std::vector<ThreeMfReference> items;
};

}  // namespace handwheel
