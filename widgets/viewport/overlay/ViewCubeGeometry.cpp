// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/overlay/ViewCubeGeometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handwheel {

namespace {

constexpr double kMiddleShare = 0.66;  // share of a side that is the side's own
constexpr double kOnBorder = 1e-6;     // square pixels
constexpr double kFacing = 1e-3;       // sides that face the viewer less are not drawn

std::array<CubeRegion, 6> sides() {
  std::array<CubeRegion, 6> all;
  for (int k = 0; k < 6; ++k) all[k] = CubeRegion::Unit(k / 2) * (k % 2 ? 1 : -1);
  return all;
}

// Returns true if the point is inside or on the border: no position of the cube lies between two cells.
bool isInside(const Vec2& p, const std::array<Vec2, 4>& outline) {
  double least = 0.0, most = 0.0;
  for (int i = 0; i < 4; ++i) {
    const Vec2 along = outline[(i + 1) % 4] - outline[i], to = p - outline[i];
    const double side = along.x() * to.y() - along.y() * to.x();
    least = std::min(least, side);
    most = std::max(most, side);
  }
  return least > -kOnBorder || most < kOnBorder;
}

}  // namespace

ViewCubeGeometry::ViewCubeGeometry(const Eigen::Quaterniond& orientation, const Vec2& middle, double half)
    : m_toView(orientation.conjugate()), m_middle(middle), m_half(half) {}

Vec2 ViewCubeGeometry::toScreen(const Vec3& p) const {
  const Vec3 v = m_toView * p;
  return m_middle + m_half * Vec2(v.x(), -v.y());
}

std::vector<CubeCell> ViewCubeGeometry::cells() const {
  constexpr std::array<double, 4> cuts{-1.0, -kMiddleShare, kMiddleShare, 1.0};
  std::vector<CubeCell> cells;
  for (const CubeRegion& side : sides()) {
    const Vec3 out = side.cast<double>();
    if ((m_toView * out).z() < kFacing) continue;
    const auto [right, up] = axesOn(side);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const auto at = [&](int a, int b) { return toScreen(out + cuts[a] * right + cuts[b] * up); };
        const CubeRegion region = side + ((i - 1) * right + (j - 1) * up).array().round().matrix().cast<int>();
        cells.push_back({region, side, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}});
      }
    }
  }
  return cells;
}

std::optional<CubeRegion> ViewCubeGeometry::regionAt(const Vec2& position) const {
  for (const CubeCell& cell : cells()) {
    if (isInside(position, cell.outline)) return cell.region;
  }
  return std::nullopt;
}

std::pair<Vec3, Vec3> axesOn(const CubeRegion& side) {
  const Eigen::Quaterniond facing = uprightTowards(side.cast<double>());
  return {facing * Vec3::UnitX(), facing * Vec3::UnitY()};
}

CubeRegion regionFacing(const Eigen::Quaterniond& orientation) {
  const Vec3 towards = orientation * Vec3::UnitZ();
  CubeRegion best = CubeRegion::UnitZ();
  double most = -2.0;
  for (int i = 0; i < 27; ++i) {
    const CubeRegion region(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (region.isZero()) continue;
    const double cosine = region.cast<double>().normalized().dot(towards);
    if (cosine <= most) continue;
    most = cosine;
    best = region;
  }
  return best;
}

CubeRegion steppedFrom(const CubeRegion& region, int aroundSteps, int upSteps) {
  constexpr double eighth = std::numbers::pi / 4;
  const CubeRegion level(region.x(), region.y(), 0);
  const bool isPole = level.isZero();
  // From straight above, a step down leads to the front.
  const Vec3 front = isPole ? Vec3(-Vec3::UnitY()) : Vec3(level.cast<double>());
  const double around = std::atan2(front.y(), front.x()) + aroundSteps * eighth;
  const int elevation = std::clamp((isPole ? 2 : 1) * region.z() + upSteps, -2, 2);
  if (std::abs(elevation) == 2) return {0, 0, elevation / 2};
  const auto sign = [](double v) { return v > 0.3 ? 1 : v < -0.3 ? -1 : 0; };
  return {sign(std::cos(around)), sign(std::sin(around)), elevation};
}

}  // namespace handwheel
