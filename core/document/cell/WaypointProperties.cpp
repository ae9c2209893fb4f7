// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/WaypointProperties.h"

#include "base/NumberText.h"

#include <QtGlobal>
#include <algorithm>
#include <charconv>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kPercent = 100.0;
constexpr double kLeastPercent = 0.1;
constexpr double kLeastSpeed = 0.01, kLargestSpeed = 1e4;  // mm/s
constexpr double kLargestBlend = 1e3;                      // mm
const std::string kPathPrefix = "path.", kClearance = ".clearance";

bool isLine(const Waypoint& waypoint) {
  return waypoint.motion == ProgramMotion::Kind::Linear;
}

}  // namespace

std::vector<Property> waypointProperties(const RobotPath& path, std::size_t index) {
  if (index >= path.waypoints.size()) return {};
  const Waypoint& at = path.waypoints[index];
  const std::string prefix = "path." + path.name + "." + std::to_string(index + 1) + ".";
  const char* const kGroup = QT_TRANSLATE_NOOP("Property", "Place of the path");
  Property motion{.id = prefix + "motion",
                  .group = kGroup,
                  .label = QT_TRANSLATE_NOOP("Property", "Motion to it"),
                  .value = isLine(at) ? 1.0 : 0.0};
  motion.choices = {QT_TRANSLATE_NOOP("Property", "joints"), QT_TRANSLATE_NOOP("Property", "straight line")};
  const Property speed{
      .id = prefix + "speed",
      .group = kGroup,
      .label = isLine(at) ? QT_TRANSLATE_NOOP("Property", "Speed (mm/s)") : QT_TRANSLATE_NOOP("Property", "Speed (%)"),
      .value = isLine(at) ? at.speed : kPercent * at.speed,
      .least = isLine(at) ? kLeastSpeed : kLeastPercent,
      .largest = isLine(at) ? kLargestSpeed : kPercent};
  const Property blend{.id = prefix + "blend",
                       .group = kGroup,
                       .label = QT_TRANSLATE_NOOP("Property", "Blend"),
                       .value = at.blend,
                       .quantity = Quantity::Length,
                       .least = 0.0,
                       .largest = kLargestBlend};
  const Property seconds{.id = prefix + "seconds",
                         .group = kGroup,
                         .label = QT_TRANSLATE_NOOP("Property", "Duration (s), 0: by the speed"),
                         .value = at.seconds,
                         .least = 0.0,
                         .largest = ProgramMotion::kLongest};
  const Property corner{.id = prefix + "corner",
                        .group = kGroup,
                        .label = QT_TRANSLATE_NOOP("Property", "Rounding (CNT, %)"),
                        .value = at.corner,
                        .least = 0.0,
                        .largest = ProgramMotion::kLargestCorner};
  const Property carried{.id = prefix + "carried",
                         .group = kGroup,
                         .label = QT_TRANSLATE_NOOP("Property", "Carries the same after its lines"),
                         .value = at.keepsCarried};
  const bool isFirst = index == 0;  // no motion leads to it
  std::vector<Property> all;
  if (!isFirst) all = {motion, speed, blend};
  // Properties of paths of programs are shown only where a program has set them.
  if (at.seconds > 0.0 && !isFirst) all.push_back(seconds);
  if (at.corner > 0.0) all.push_back(corner);
  const bool mayGripBefore = isFirst && std::ranges::any_of(path.head, &ProgramLine::mayGrip);
  if (mayGripBefore || std::ranges::any_of(at.lines, &ProgramLine::mayGrip)) all.push_back(carried);
  return all;
}

std::optional<WaypointField> waypointOfProperty(const CellPlans& plans, std::string_view id) {
  if (!id.starts_with(kPathPrefix)) return std::nullopt;
  id.remove_prefix(kPathPrefix.size());
  const std::size_t last = id.rfind('.');
  const std::size_t before = last == id.npos || last == 0 ? id.npos : id.rfind('.', last - 1);
  if (before == id.npos) return std::nullopt;
  std::size_t number = 0;
  const std::string_view digits = id.substr(before + 1, last - before - 1);
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const RobotPath* const path = plans.path(id.substr(0, before));
  const bool isWaypoint = read.ec == std::errc() && read.ptr == digits.data() + digits.size() && path && number > 0 &&
                          number <= path->waypoints.size();
  if (!isWaypoint) return std::nullopt;
  const std::vector<Property> fields = waypointProperties(*path, number - 1);
  const bool isThere = number > 1 || std::ranges::any_of(fields, [&](const Property& each) {
                         return std::string_view(each.id).ends_with(id.substr(last));
                       });
  if (!isThere) return std::nullopt;
  return WaypointField{path->name, number - 1, std::string(id.substr(last + 1))};
}

Property clearanceProperty(const RobotPath& path, const CellPlans& plans) {
  return {.id = kPathPrefix + path.name + kClearance,
          .group = QT_TRANSLATE_NOOP("Property", "Path"),
          .label = QT_TRANSLATE_NOOP("Property", "Clearance to keep"),
          .value = plans.clearanceOf(path),
          .quantity = Quantity::Length,
          .least = 0.0,
          .largest = RobotPath::kLargestClearance};
}

const RobotPath* pathOfClearance(const CellPlans& plans, std::string_view id) {
  if (!id.starts_with(kPathPrefix) || !id.ends_with(kClearance) || id.size() < kPathPrefix.size() + kClearance.size())
    return nullptr;
  return plans.path(id.substr(kPathPrefix.size(), id.size() - kPathPrefix.size() - kClearance.size()));
}

Result<CellPlans> changedClearance(const CellPlans& plans, const RobotPath& path, const PropertyValue& value) {
  const Property field = clearanceProperty(path, plans);
  const auto* const number = std::get_if<double>(&value);
  if (!number || !std::isfinite(*number))
    return Error{ErrorCode::ElementMalformed, {field.id, "a number was expected"}, {}, {}};
  const auto kept = withinShownLimits(*number, field.least, field.largest);
  if (!kept)
    return Error{ErrorCode::ValueOutOfRange,
                 {field.id, shownText(*number), shownText(field.least), shownText(field.largest)},
                 {},
                 {}};
  CellPlans changed = plans;
  RobotPath& of = *std::ranges::find(changed.paths, path.name, &RobotPath::name);
  of.clearance = plans.ownClearance(*kept);
  if (of.process) of.process->values["clearance"] = *kept;
  return changed;
}

void setMotion(RobotPath& path, std::size_t index, ProgramMotion::Kind kind) {
  Waypoint& at = path.waypoints[index];
  if (at.motion == kind) return;
  at.motion = kind;
  at.speed = kind == ProgramMotion::Kind::Linear ? 250.0 : 0.25;
  for (std::size_t i = 1; i < path.waypoints.size(); ++i) {
    if (i != index && path.waypoints[i].motion == kind) at.speed = path.waypoints[i].speed;
    if (i > index && path.waypoints[i].motion == kind) break;
  }
}

Result<CellPlans> changedWaypoint(const CellPlans& plans, const WaypointField& field, const PropertyValue& value) {
  CellPlans changed = plans;
  const auto found = std::ranges::find(changed.paths, field.path, &RobotPath::name);
  const std::string id = field.path + "." + std::to_string(field.index + 1) + "." + field.field;
  const auto* const flag = std::get_if<bool>(&value);
  const double asNumber = flag && *flag ? 1.0 : 0.0;
  const auto* const number = flag ? &asNumber : std::get_if<double>(&value);
  if (found == changed.paths.end() || field.index >= found->waypoints.size() || !number || !std::isfinite(*number))
    return Error{ErrorCode::ElementMalformed, {id, "a number was expected"}, {}, {}};
  Waypoint& waypoint = found->waypoints[field.index];
  for (const Property& each : waypointProperties(*found, field.index)) {
    if (!each.id.ends_with("." + field.field)) continue;
    if (std::holds_alternative<bool>(each.value)) {
      waypoint.keepsCarried = *number != 0.0;
    } else if (!each.choices.empty()) {
      setMotion(*found, field.index, *number >= 0.5 ? ProgramMotion::Kind::Linear : ProgramMotion::Kind::Joint);
    } else {
      const auto kept = withinShownLimits(*number, each.least, each.largest);
      if (!kept)
        return Error{ErrorCode::ValueOutOfRange,
                     {id, shownText(*number), shownText(each.least), shownText(each.largest)},
                     {},
                     {}};
      if (field.field == "blend") waypoint.blend = *kept;
      if (field.field == "seconds") waypoint.seconds = *kept;
      if (field.field == "corner") waypoint.corner = *kept;
      if (field.field == "speed") waypoint.speed = isLine(waypoint) ? *kept : *kept / kPercent;
    }
    // Planning along the curve again would bring the former values back.
    if (!(waypoint == plans.path(field.path)->waypoints[field.index])) found->process.reset();
    return changed;
  }
  return Error{ErrorCode::ElementMalformed, {id, "a number was expected"}, {}, {}};
}

}  // namespace handwheel
