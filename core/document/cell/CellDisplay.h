// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "document/cell/CellSnapshot.h"

#include <string_view>

namespace handwheel {

// The robot with its joints like this: one part for each visual shape, or each collision shape of a robot that has no
// visual ones. Parts keep their names and surfaces while the joints move.
DisplayModel displayOf(const CellRobot& robot, const JointValues& joints);

// The link that a part shows; kNone for a name that is none of its parts.
std::uint32_t linkOfPart(const CellRobot& robot, std::string_view part);

}  // namespace handwheel
