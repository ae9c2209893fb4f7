// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "document/Container.h"
#include "robot/program/RobotPath.h"

#include <memory>
#include <vector>

namespace handwheel {

// Write the plans of a cell to its container, and read them. Reading returns null if the container has no plans; parts
// that cannot be read are omitted and added to damage.
void writePlans(const CellPlans& plans, const RobotModel& robot, Container& container);
std::shared_ptr<const CellPlans> readPlans(const Container& container, const RobotModel& robot,
                                           const JointValues& others, std::vector<Error>& damage);

}  // namespace handwheel
