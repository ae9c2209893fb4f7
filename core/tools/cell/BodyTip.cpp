// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/BodyTip.h"

namespace handwheel {

std::optional<Vec3> tipOf(const Body& body) {
  constexpr double kFlat = 1e-6;  // Share of its size within which points count as equally far
  const auto surface = body.geometry->surface();
  if (!surface || surface->points.empty()) return std::nullopt;
  Box all;
  for (const Vec3& point : surface->points) all.extend(body.pose * point);
  const double farthest = all.max().z() - kFlat * all.sizes().maxCoeff();
  Box tip;
  for (const Vec3& point : surface->points) {
    const Vec3 at = body.pose * point;
    if (at.z() >= farthest) tip.extend(at);
  }
  return tip.isEmpty() ? std::nullopt : std::optional<Vec3>(tip.center());
}

}  // namespace handwheel
