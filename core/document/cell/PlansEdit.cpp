// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/PlansEdit.h"

#include "document/cell/CellErrors.h"
#include "document/cell/RobotCellDocument.h"

#include <algorithm>

namespace handwheel {

void PlansEdit::exchange(Document& document) {
  auto& cell = static_cast<RobotCellDocument&>(document);
  std::swap(cell.m_plans, m_plans);
  cell.wasChanged();
}

Status checkCounts(const CellPlans& plans) {
  std::size_t waypoints = 0;
  for (const RobotPath& path : plans.paths) waypoints = std::max(waypoints, path.waypoints.size());
  const auto full = [](const char* what, std::size_t count, std::size_t most) {
    return Error{CellError::PlansFull, {what, std::to_string(count), std::to_string(most)}, {}, {}};
  };
  constexpr std::size_t kMost = CellPlans::kMost;
  if (plans.configurations.size() > kMost) return full("configurations", plans.configurations.size(), kMost);
  if (plans.targets.size() > kMost) return full("targets", plans.targets.size(), kMost);
  if (plans.paths.size() > kMost) return full("paths", plans.paths.size(), kMost);
  if (plans.frames.size() > CellPlans::kMostFrames) return full("frames", plans.frames.size(), CellPlans::kMostFrames);
  if (plans.allowed.size() > kMost) return full("allowed pairs", plans.allowed.size(), kMost);
  if (waypoints > RobotPath::kMostWaypoints) return full("places of a path", waypoints, RobotPath::kMostWaypoints);
  return Done{};
}

}  // namespace handwheel
