// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/proof/MissingShapes.h"

#include "document/cell/BodyCarriers.h"
#include "document/scene/BodyDisplay.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

const std::string kMissing = "missing.";

// Returns the files and elements of a link that could not be read; empty: all of it was read.
std::string unreadOf(const Link& link, const CellRobot& robot, bool isByVisuals) {
  std::string all;
  const auto add = [&](const std::string& what) { all += (all.empty() ? "" : ", ") + what; };
  for (const PlacedShape& placed : isByVisuals ? link.visuals : link.collisions) {
    const auto* const mesh = std::get_if<MeshShape>(&robot.model.shapes[placed.shape]);
    if (mesh && !robot.surfaces[placed.shape]) add(mesh->file);
  }
  for (const std::string& element : isByVisuals ? link.unreadVisuals : link.unreadCollisions)
    add(element.empty() ? "no shape" : element);
  return all;
}

// The bodies that can replace the shape of a part: those that the link carries.
std::vector<BodyPointer> replacements(const std::string& part, const RobotModel& robot, const BodySet& bodies) {
  std::vector<BodyPointer> all;
  const std::uint32_t link = linkNamed(robot, part);
  for (const BodyPointer& body : bodies) {
    if (link != kNone && carrierOf(*body, robot) == link && body->geometry->isKnown()) all.push_back(body);
  }
  return all;
}

// The state by what the plans say. A body that was removed, or that the link does not carry any more, replaces nothing.
void decide(MissingShape& missing, const CellRobot& robot, const BodySet& bodies, const CellPlans& plans) {
  const auto decided = plans.missingAs.find(missing.part);
  if (decided == plans.missingAs.end()) return;
  if (decided->second.empty()) {
    missing.state = MissingShape::State::LeftOut;
    return;
  }
  for (const BodyPointer& body : replacements(missing.part, robot.model, bodies)) {
    if (partOfBody(body->id) != decided->second) continue;
    missing.state = MissingShape::State::Replaced;
    missing.by = body->name;
  }
}

}  // namespace

bool collidesWithVisuals(const RobotModel& robot) {
  return std::ranges::none_of(robot.links, &Link::isSolid);
}

std::vector<MissingShape> missingShapes(const CellRobot& robot, const BodySet& bodies, const CellPlans& plans) {
  const bool isByVisuals = collidesWithVisuals(robot.model);
  std::vector<MissingShape> all;
  for (const Link& link : robot.model.links) {
    if (std::string what = unreadOf(link, robot, isByVisuals); !what.empty())
      all.push_back({.part = link.name, .name = link.name, .what = std::move(what)});
  }
  for (const BodyPointer& body : bodies) {
    if (!body->geometry->isKnown())
      all.push_back({.part = partOfBody(body->id), .name = body->name, .what = std::string(body->geometry->kind())});
  }
  for (MissingShape& each : all) decide(each, robot, bodies, plans);
  return all;
}

std::string sentenceOn(const MissingShape& missing) {
  const std::string unread = missing.name + ": its shape (" + missing.what + ") could not be read";
  switch (missing.state) {
    case MissingShape::State::LeftOut:
      return unread + ", and is left out of the proof";
    case MissingShape::State::Replaced:
      return unread + ", and " + missing.by + " replaces it";
    case MissingShape::State::Open:
      break;
  }
  return unread + ", so nothing is proven free";
}

nlohmann::json describeMissing(const std::vector<MissingShape>& missing) {
  constexpr std::array<const char*, 3> kStates = {"missing", "left out", "replaced"};
  nlohmann::json list = nlohmann::json::array();
  for (const MissingShape& each : missing) {
    list.push_back(
        {{"part", each.name}, {"shape", each.what}, {"state", kStates[static_cast<std::size_t>(each.state)]}});
    if (!each.by.empty()) list.back()["by"] = each.by;
  }
  return list;
}

std::vector<Property> missingProperties(const CellRobot& robot, const BodySet& bodies, const CellPlans& plans) {
  std::vector<Property> all;
  for (const MissingShape& missing : missingShapes(robot, bodies, plans)) {
    Property property;
    property.id = kMissing + missing.part;
    property.group = QT_TRANSLATE_NOOP("Property", "Shapes that could not be read");
    property.label = missing.name + " (" + missing.what + ")";
    property.translated = false;
    property.choices = {QT_TRANSLATE_NOOP("Property", "missing"), QT_TRANSLATE_NOOP("Property", "left out")};
    double chosen = missing.state == MissingShape::State::LeftOut ? 1.0 : 0.0;
    for (const BodyPointer& body : replacements(missing.part, robot.model, bodies)) {
      if (missing.state == MissingShape::State::Replaced && body->name == missing.by)
        chosen = static_cast<double>(property.choices.size());
      property.choices.push_back(body->name);
    }
    property.value = chosen;
    property.least = 0.0;
    property.largest = static_cast<double>(property.choices.size() - 1);
    if (missing.state == MissingShape::State::Open)
      property.problem = QT_TRANSLATE_NOOP("Property", "nothing is proven free until it is left out or replaced");
    all.push_back(std::move(property));
  }
  return all;
}

Result<CellPlans> changedMissing(const std::string& id, const PropertyValue& value, const CellRobot& robot,
                                 const BodySet& bodies, const CellPlans& plans) {
  const auto malformed = [&](const char* reason) { return Error{ErrorCode::ElementMalformed, {id, reason}, {}, {}}; };
  const std::string part = id.substr(kMissing.size());
  const std::vector<MissingShape> all = missingShapes(robot, bodies, plans);
  if (std::ranges::find(all, part, &MissingShape::part) == all.end()) return malformed("its shape is not missing");
  const std::vector<BodyPointer> by = replacements(part, robot.model, bodies);
  const auto* const number = std::get_if<double>(&value);
  if (!number || !(*number >= 0.0 && *number < 2.0 + static_cast<double>(by.size())))
    return malformed("a number was expected");
  CellPlans changed = plans;
  const auto choice = static_cast<std::size_t>(*number);
  if (choice == 0)
    changed.missingAs.erase(part);
  else
    changed.missingAs[part] = choice == 1 ? std::string() : partOfBody(by[choice - 2]->id);
  return changed;
}

bool isMissingProperty(const std::string& id) {
  return id.starts_with(kMissing);
}

}  // namespace handwheel
