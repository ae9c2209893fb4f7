// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Property.h"
#include "robot/program/RobotPath.h"

#include <optional>

namespace handwheel {

// Returns the properties of a waypoint, by its index from 0. They are the motion to it, its speed, and the blend radius
// at the waypoint. Ids are "path.NAME.NUMBER.motion" and so on, with numbers from 1. Empty for the first waypoint, at
// which the path begins.
std::vector<Property> waypointProperties(const RobotPath& path, std::size_t index);

// A property of a waypoint, by its id. Nothing if there is no such property or waypoint.
struct WaypointField {
  std::string path;
  std::size_t index;  // From 0
  std::string field;
};
std::optional<WaypointField> waypointOfProperty(const CellPlans& plans, std::string_view id);

// Returns the plans with one of these properties changed. Error: ValueOutOfRange, ElementMalformed.
Result<CellPlans> changedWaypoint(const CellPlans& plans, const WaypointField& field, const PropertyValue& value);

// Returns the clearance that a path keeps, as a property with the id "path.NAME.clearance".
Property clearanceProperty(const RobotPath& path, const CellPlans& plans);
// Returns the path whose clearance has this id; null for other ids.
const RobotPath* pathOfClearance(const CellPlans& plans, std::string_view id);
// Returns the plans with another clearance of the path. A path along a curve is also planned with it. Error:
// ValueOutOfRange, ElementMalformed.
Result<CellPlans> changedClearance(const CellPlans& plans, const RobotPath& path, const PropertyValue& value);

// Sets the kind of the motion to a waypoint, with the speed that the path has elsewhere for that kind.
void setMotion(RobotPath& path, std::size_t index, ProgramMotion::Kind kind);

}  // namespace handwheel
