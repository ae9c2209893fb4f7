// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "mesh/structure/TriangleSoup.h"
#include "robot/RobotModel.h"

#include <algorithm>

namespace handwheel {

// Limit on the number of triangles and points of a robot. A short description may use a large mesh a thousand times.
class SurfaceBudget {
 public:
  explicit SurfaceBudget(const RobotModel& robot) : m_placements(robot.shapes.size()) {
    for (const Link& link : robot.links) {
      for (const PlacedShape& placed : link.visuals) ++m_placements[placed.shape];
      for (const PlacedShape& placed : link.collisions) ++m_placements[placed.shape];
    }
  }

  // Reserves the surface of a shape for all of its placements. Returns false, and reserves nothing, if the surface
  // would exceed the limit.
  bool take(std::size_t shape, const TriangleSoup& surface) {
    const std::size_t wanted = m_placements[shape] * std::max(surface.triangles.size(), surface.points.size());
    if (wanted > kMost - m_taken) return false;
    m_taken += wanted;
    return true;
  }
  static Error exceeded() { return {ErrorCode::FileTooLarge, {"triangles", "", std::to_string(kMost)}, {}, {}}; }

 private:
  static constexpr std::size_t kMost = 20'000'000;

  std::vector<std::size_t> m_placements;  // Number of placements per shape
  std::size_t m_taken = 0;
};

}  // namespace handwheel
