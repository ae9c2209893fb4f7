// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/DefaultClearance.h"

#include "document/cell/CellArms.h"
#include "robot/dh/DhTable.h"

#include <algorithm>

namespace handwheel {

double defaultClearance(const CellRobot& robot, const CellPlans& plans) {
  if (plans.clearance > 0.0) return plans.clearance;
  const std::size_t arm = activeArmNumber(robot, plans);
  const bool isPlain = libraryRobot(robot.arms[arm].title) && hasPlainShapes(robot.model, robot.arms, arm);
  return isPlain ? kPlainShapesClearance : plans.clearance;
}

double defaultClearance(const CellRobot& robot, const CellPlans& plans, double standoff) {
  if (plans.clearance > 0.0) return plans.clearance;
  return std::clamp(0.5 * standoff, 0.0, defaultClearance(robot, plans));
}

}  // namespace handwheel
