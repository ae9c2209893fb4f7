// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HoleFilling.h"
#include "mesh/TriangleSoup.h"

#include <functional>
#include <memory>
#include <vector>

namespace handwheel {

using DistanceToTruth = std::function<double(const Vec3&)>;  // of a point to the surface that was there (mm)

// A surface with pieces cut out, and what was there.
struct CutSurface {
  struct Hole {
    BoundaryLoop loop;
    DistanceToTruth distance;
  };
  std::unique_ptr<HoleFiller> filler;
  std::vector<Hole> holes;
};

struct CutOptions {
  std::size_t holes = 4;
  double radius = 0.12;  // share of the part's diagonal
  // Where given, the first hole and every other one after it is at most half its radius from a sharp edge.
  DistanceToTruth distanceToCrease = nullptr;
};

// Cuts round holes where the seed says, apart from each other. truth: the surface in closed form; without one, what is
// cut out stands for it. O(n log n).
CutSurface cutHoles(const TriangleSoup& soup, std::uint64_t seed, const DistanceToTruth& truth,
                    const CutOptions& options = {});

}  // namespace handwheel
