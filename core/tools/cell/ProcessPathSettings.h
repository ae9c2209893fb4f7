// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// Settings of the operation "process", which plans a path along a curve. The tool that plans the path shows them as its
// settings; the settings of a planned path can still be edited. Lengths are in mm, angles in rad.

// Returns the names of the configurations at which the path may start or end.
std::vector<std::string> processEnds(const CellRobot& robot, const CellPlans& plans);

// Returns all settings of the operation. ends: the result of processEnds().
std::vector<Property> processPathSettings(const OperationValues& values, const std::vector<std::string>& ends);
// Returns the settings of a path whose curve is already chosen. Settings that choose the curve are omitted.
std::vector<Property> settingsOfStoredPath(const OperationValues& values, const std::vector<std::string>& ends);

// Sets a value from one of the settings. Nothing happens for an unknown id or a value of another type.
void takeProcessSetting(OperationValues& values, const std::vector<std::string>& ends, std::string_view id,
                        const PropertyValue& value);

}  // namespace handwheel
