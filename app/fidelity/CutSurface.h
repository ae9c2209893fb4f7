// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"
#include "mesh/structure/TriangleSoup.h"

#include <functional>
#include <memory>
#include <vector>

namespace handwheel {

using DistanceToTruth =
    std::function<double(const Vec3&)>;  // returns the distance of a point from the original surface (mm)

// A surface with holes cut into it, and the distance to the original surface.
struct CutSurface {
  struct Hole {
    BoundaryLoop loop;
    DistanceToTruth distance;
  };
  std::unique_ptr<HoleFiller> filler;
  std::vector<Hole> holes;
};

// The number, size and position of the holes.
struct CutOptions {
  std::size_t holes = 4;
  double radius = 0.12;  // fraction of the part's diagonal
  // If set, the first hole and every second one after it is at most half its radius from a sharp edge.
  DistanceToTruth distanceToCrease = nullptr;
};

// Cuts round holes at separate positions that the seed determines. truth: the distance to the surface in closed form;
// if it is empty, the distance to the pieces that are cut out is used. O(n log n).
CutSurface cutHoles(const TriangleSoup& soup, std::uint64_t seed, const DistanceToTruth& truth,
                    const CutOptions& options = {});

}  // namespace handwheel
