// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "document/Container.h"
#include "robot/program/RobotPath.h"

#include <memory>
#include <vector>

namespace handwheel {

// Write the plans of a cell into its container, and read them. Null if the container has none. Parts that cannot be
// read are left out and listed as damage.
void writePlans(const CellPlans& plans, const RobotModel& robot, Container& container);
std::shared_ptr<const CellPlans> readPlans(const Container& container, const RobotModel& robot,
                                           const JointValues& others, std::vector<Error>& damage);

}  // namespace handwheel
