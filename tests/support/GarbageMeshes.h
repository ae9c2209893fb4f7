// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "MeshShapes.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace handwheel::test {

// Returns a sphere with random damage, as in a damaged file. Some points are moved within its box, far out, or to the
// position of another point; some triangles are missing, or have one corner replaced. The result has holes, hundreds of
// crossings and long slivers.
inline TriangleSoup damagedSphere(std::mt19937& random, int levels, std::size_t damages) {
  TriangleSoup soup = icosphere(levels);
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
  for (std::size_t i = 0; i < damages; ++i) {
    Vec3& point = soup.points[below(soup.points.size())];
    switch (below(5)) {
      case 0:
        point = Vec3(anywhere(random), anywhere(random), anywhere(random));
        break;
      case 1:
        point[static_cast<Eigen::Index>(below(3))] *= std::ldexp(1.0, static_cast<int>(below(40)) - 20);
        break;
      case 2:
        point = soup.points[below(soup.points.size())];
        break;
      case 3:
        soup.triangles[below(soup.triangles.size())][below(3)] = static_cast<std::uint32_t>(below(soup.points.size()));
        break;
      default:
        soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(below(soup.triangles.size())));
    }
  }
  return soup;
}

}  // namespace handwheel::test
