// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Property.h"
#include "robot/program/RobotPath.h"

#include <optional>

namespace handwheel {

// The properties of a place of a path, by its number from 0. They are how the robot gets there, how fast, and how far
// it may round the place off. Ids are "path.NAME.NUMBER.motion" and so on, with numbers from 1. None of the first
// place, where the path begins.
std::vector<Property> waypointProperties(const RobotPath& path, std::size_t place);

// A property of a place, by its id; none: it is no such property, or there is no such place.
struct WaypointField {
  std::string path;
  std::size_t place;  // from 0
  std::string field;
};
std::optional<WaypointField> waypointOfProperty(const CellPlans& plans, std::string_view id);

// Plans with one of these properties changed. Error: ValueOutOfRange, ElementMalformed.
Result<CellPlans> changedWaypoint(const CellPlans& plans, const WaypointField& field, const PropertyValue& value);

// The clearance that a path keeps, with the id "path.NAME.clearance".
Property clearanceProperty(const RobotPath& path, const CellPlans& plans);
// The path whose clearance this id stands for; null: it stands for none.
const RobotPath* pathOfClearance(const CellPlans& plans, std::string_view id);
// Plans in which the path keeps this clearance. One along a curve is planned with it, too. Error: ValueOutOfRange,
// ElementMalformed.
Result<CellPlans> changedClearance(const CellPlans& plans, const RobotPath& path, const PropertyValue& value);

// The motion to a place becomes another, with the speed that the path has elsewhere for that kind.
void setMotion(RobotPath& path, std::size_t place, ProgramMotion::Kind kind);

}  // namespace handwheel
