// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <functional>

namespace handwheel {

// A part with sharp edges that is known exactly. Lengths are in mm.
struct ExactPart {
  Box box;
  std::function<double(const Vec3&)> distance;          // distance from the surface; below zero inside
  std::function<double(const Vec3&)> distanceToCrease;  // distance from the nearest sharp edge
  double volume = 0.0;                                  // mm³
};

// Returns a prism: a block with a step, a slanted side and a chamfer. It has flat faces, edges between them, and
// corners.
ExactPart milledPart();

// Returns a shaft around z with a shoulder, two chamfers and a flange. Its edges are circles, one of them concave.
ExactPart turnedPart();

}  // namespace handwheel
