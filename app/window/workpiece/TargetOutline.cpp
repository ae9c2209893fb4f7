// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/TargetOutline.h"

#include <cmath>

namespace handwheel {

namespace {

constexpr int kHalfTurn = 12;  // steps
constexpr double kOutlineStep = M_PI / kHalfTurn;

}  // namespace

int outlineStep(const CameraState& camera) {
  constexpr double kAlong = 1e-3;  // sine of the angle between axis and line of sight
  const Vec3 across = Vec3::UnitZ().cross(camera.towardsViewer());
  if (across.norm() < kAlong) return 0;
  const int step = static_cast<int>(std::lround(std::atan2(across.y(), across.x()) / kOutlineStep));
  return ((step % kHalfTurn) + kHalfTurn) % kHalfTurn;
}

PathLayer::Lines targetOutline(const TargetProfile& target, int step) {
  constexpr int kOfArc = 16, kOfRing = 96;
  constexpr std::size_t kMostRings = 60;
  const Vec3 out(std::cos(kOutlineStep * step), std::sin(kOutlineStep * step), 0.0);
  auto lines = std::make_shared<std::vector<PathLine>>();
  for (const double side : {-1.0, 1.0}) {
    for (const ProfileSegment& s : target.segments()) {
      PathLine line;
      const int pieces = s.isArc() ? kOfArc : 1;
      for (int k = 0; k <= pieces; ++k) {
        const ProfilePoint p = s.at(static_cast<double>(k) / pieces);
        line.points.emplace_back(side * p.x() * out + p.y() * Vec3::UnitZ());
      }
      lines->push_back(std::move(line));
    }
  }
  const std::size_t stride = (target.segments().size() + kMostRings - 1) / kMostRings;
  for (std::size_t i = 0; i < target.segments().size(); i += stride) {
    const ProfilePoint& from = target.segments()[i].from;
    PathLine ring;
    for (int k = 0; from.x() > 0.0 && k <= kOfRing; ++k) {
      const double angle = 2.0 * M_PI * k / kOfRing;
      ring.points.emplace_back(from.x() * std::cos(angle), from.x() * std::sin(angle), from.y());
    }
    if (!ring.points.empty()) lines->push_back(std::move(ring));
  }
  return lines;
}

}  // namespace handwheel
