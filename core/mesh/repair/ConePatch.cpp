// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/ConePatch.h"

#include <algorithm>
#include <limits>

namespace handwheel {

Patch conePatch(const HalfEdgeMesh& mesh, const BoundaryLoop& loop, double height, NumberType numbers) {
  Patch patch;
  patch.method = FillMethod::Cone;
  patch.points = loopPoints(mesh, loop);
  const auto n = static_cast<std::uint32_t>(patch.points.size());
  patch.loopSize = n;
  Vec3 middle = Vec3::Zero(), area = Vec3::Zero();
  double shortest = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < n; ++i) {
    const Vec3 &a = patch.points[i], &b = patch.points[(i + 1) % n];
    middle += a / n;
    area += (b - loop.centre).cross(a - loop.centre);  // the patch runs against the loop
    shortest = std::min(shortest, (b - a).norm());
    patch.triangles.push_back({(i + 1) % n, i, n});
  }
  patch.points.push_back(rounded(Vec3(middle + height * shortest * area.stableNormalized()), numbers));
  return patch;
}

}  // namespace handwheel
