// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <functional>

namespace handwheel {

// A part with sharp edges, known exactly. Lengths in mm.
struct ExactPart {
  Box box;
  std::function<double(const Vec3&)> distance;          // from the surface; below zero inside
  std::function<double(const Vec3&)> distanceToCrease;  // from the nearest sharp edge
  double volume = 0.0;                                  // mm³
};

// A block with a step, a slanted side and a chamfer. All of one height: flat faces, edges between them, corners.
ExactPart milledPart();

// A shaft around z with a shoulder, two chamfers and a flange. Edges are circles, one of them concave.
ExactPart turnedPart();

}  // namespace handwheel
