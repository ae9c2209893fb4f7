// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// Settings of the operation "process", which plans a path along a curve. They belong to the tool that plans it, and are
// fields of the path afterwards. Lengths in mm, angles in rad.

// Returns the names of the configurations that such a path may start or end at.
std::vector<std::string> processEnds(const CellRobot& robot, const CellPlans& plans);

// Returns all settings of the operation. ends: as from processEnds().
std::vector<Property> processPathSettings(const OperationValues& values, const std::vector<std::string>& ends);
// Returns the settings of a path whose curve is chosen: without those that choose the curve.
std::vector<Property> settingsOfStoredPath(const OperationValues& values, const std::vector<std::string>& ends);

// Sets a value from one of these settings; nothing happens for an unknown id or a value of another type.
void takeProcessSetting(OperationValues& values, const std::vector<std::string>& ends, std::string_view id,
                        const PropertyValue& value);

}  // namespace handwheel
