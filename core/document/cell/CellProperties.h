// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Property.h"
#include "robot/RobotModel.h"

namespace handwheel {

// One property for each degree of freedom ("joint.<name>", labelled with the joint's name), with its limits and what is
// not known of it; then, to read only, the robot's name and where its tool stands ("tool.x", …; mm, in the frame of the
// robot's foot).
std::vector<Property> cellProperties(const RobotModel& robot, const JointValues& joints);

// kNone when the property is no joint's.
std::uint32_t dofOfProperty(const RobotModel& robot, std::string_view id);

// A value for a joint. Errors: ElementMalformed, ValueOutOfRange {name, value, least, largest; degrees or mm}.
Result<double> jointValueFrom(const RobotModel& robot, std::uint32_t dof, const PropertyValue& value);

}  // namespace handwheel
