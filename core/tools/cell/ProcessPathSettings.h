// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// The settings of the operation "process", which plans a path along a curve. They are in the tool that plans it, and
// fields of the path afterwards. Lengths in mm, angles in rad.

// Names of the configurations that such a path may come from or go to.
std::vector<std::string> processEnds(const CellRobot& robot, const CellPlans& plans);

// All settings of the operation. ends: of processEnds().
std::vector<Property> processPathSettings(const OperationValues& values, const std::vector<std::string>& ends);
// Those of a path whose curve is chosen: without what the tool follows.
std::vector<Property> settingsOfStoredPath(const OperationValues& values, const std::vector<std::string>& ends);

// Sets a value from one of these; nothing happens for an unknown id or a value of another type.
void takeProcessSetting(OperationValues& values, const std::vector<std::string>& ends, std::string_view id,
                        const PropertyValue& value);

}  // namespace handwheel
