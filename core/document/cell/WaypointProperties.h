// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Property.h"
#include "robot/program/RobotPath.h"

#include <optional>

namespace handwheel {

// Returns the properties of a waypoint, given by its index from 0. They are the motion to the waypoint, its speed, and
// the blend radius. Ids are "path.NAME.NUMBER.motion" and so on, with numbers from 1. The result is empty for the first
// waypoint, at which the path begins.
std::vector<Property> waypointProperties(const RobotPath& path, std::size_t index);

// A property of a waypoint.
struct WaypointField {
  std::string path;
  std::size_t index;  // Index from 0
  std::string field;
};
std::optional<WaypointField> waypointOfProperty(const CellPlans& plans, std::string_view id);

// Returns the plans with a property of a waypoint changed. Errors: ValueOutOfRange, ElementMalformed.
Result<CellPlans> changedWaypoint(const CellPlans& plans, const WaypointField& field, const PropertyValue& value);

// Returns the clearance that a path keeps as a property with the id "path.NAME.clearance".
Property clearanceProperty(const RobotPath& path, const CellPlans& plans);
// Returns the path to which the clearance property with this id belongs; null for other ids.
const RobotPath* pathOfClearance(const CellPlans& plans, std::string_view id);
// Returns the plans with another clearance of the path. A path along a curve is planned with this clearance from then
// on. Errors: ValueOutOfRange, ElementMalformed.
Result<CellPlans> changedClearance(const CellPlans& plans, const RobotPath& path, const PropertyValue& value);

// Sets the kind of the motion to a waypoint. Its speed becomes that of other motions of this kind in the path, or else
// the default speed.
void setMotion(RobotPath& path, std::size_t index, ProgramMotion::Kind kind);

}  // namespace handwheel
