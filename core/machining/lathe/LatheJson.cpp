// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/LatheJson.h"

#include "base/JsonFields.h"
#include "machining/lathe/LatheResources.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <concepts>
#include <type_traits>

namespace handwheel {

namespace {

using nlohmann::json;

constexpr double kLargestCornerCoordinate = 1e4;  // mm, limit for the corners of a tool
constexpr const char *kCornersKey = "corners", *kRadiusKey = "radius", *kToolKindKey = "kind", *kDialsKey = "dials",
                     *kSlotsKey = "slots", *kAllowedKey = "allowed";
// These names are in the order of their enumerations.
constexpr const char* kAxisNames[kLatheAxes] = {"carriage", "cross", "compound", "quill"};
constexpr std::array kFittingNames{"none", "centre", "drill"};
constexpr std::array kLatheSideNames{"outside", "inside"};

Error wrong(std::string element, const char* what) {
  return {ErrorCode::ElementMalformed, {std::move(element), what}, {}, {}};
}

const json& memberOf(const json& object, const char* key) {
  return JsonFieldReader(object).member(key);
}

// Writes the types of a lathe besides the plain ones.
struct LatheFieldWriter : JsonFieldWriter {
  using JsonFieldWriter::JsonFieldWriter;
  using JsonFieldWriter::operator();
  void operator()(const char* key, const ProfilePoint& p) const { (*this)(key, json::array({p.x(), p.y()})); }
  void operator()(const char* key, const TurningSide& side) const {
    (*this)(key, kLatheSideNames[static_cast<std::size_t>(side)]);
  }
  void operator()(const char* key, const LatheFitting& fitting) const {
    (*this)(key, kFittingNames[static_cast<std::size_t>(fitting)]);
  }
};

struct LatheFieldReader : JsonFieldReader {
  using JsonFieldReader::JsonFieldReader;
  using JsonFieldReader::operator();
  void operator()(const char* key, ProfilePoint& value) const {
    const json& found = member(key);
    if (found.is_array() && found.size() == 2 && found[0].is_number() && found[1].is_number())
      value = {found[0].get<double>(), found[1].get<double>()};
  }
  void operator()(const char* key, TurningSide& side) const { takeNamed(key, kLatheSideNames, side); }
  void operator()(const char* key, LatheFitting& fitting) const { takeNamed(key, kFittingNames, fitting); }

 private:
  template <std::size_t N, class Value>
  void takeNamed(const char* key, const std::array<const char*, N>& names, Value& value) const {
    const json& found = member(key);
    for (std::size_t i = 0; i < N; ++i) {
      if (found == names[i]) value = static_cast<Value>(i);
    }
  }
};

// Each key is listed once: for reader and writer, and for const and non-const values.
template <class Dial>
requires std::same_as<std::remove_const_t<Dial>, LatheDial>
void visitFields(Dial& dial, const auto& visit) {
  visit("divisions", dial.divisions);
  visit("per_division", dial.perDivision);
  visit("backlash", dial.backlash);
  visit("least", dial.least);
  visit("largest", dial.largest);
}

template <class Slot>
requires std::same_as<std::remove_const_t<Slot>, LatheSlot>
void visitFields(Slot& slot, const auto& visit) {
  visit("tool", slot.tool);
  visit("place", slot.position);
  visit("offset", slot.offset);
  visit("has_radius_offset", slot.hasOffset[0]);
  visit("has_z_offset", slot.hasOffset[1]);
}

template <class Chuck>
requires std::same_as<std::remove_const_t<Chuck>, LatheChuck>
void visitFields(Chuck& chuck, const auto& visit) {
  visit("diameter", chuck.diameter);
  visit("length", chuck.length);
  visit("jaw_length", chuck.jawLength);
  visit("jaw_height", chuck.jawHeight);
  visit("jaw_width", chuck.jawWidth);
  visit("grip", chuck.grip);
  visit("grips_inside", chuck.gripsInside);
}

template <class Tailstock>
requires std::same_as<std::remove_const_t<Tailstock>, LatheTailstock>
void visitFields(Tailstock& tailstock, const auto& visit) {
  visit("fitting", tailstock.fitting);
  visit("drill", tailstock.drill);
  visit("place", tailstock.position);
  visit("quill_diameter", tailstock.quillDiameter);
  visit("body_radius", tailstock.bodyRadius);
}

template <class Spindle>
requires std::same_as<std::remove_const_t<Spindle>, LatheSpindle>
void visitFields(Spindle& spindle, const auto& visit) {
  visit("least_speed", spindle.leastSpeed);
  visit("largest_speed", spindle.largestSpeed);
  visit("speed", spindle.speed);
  visit("acceleration", spindle.acceleration);
  visit("power", spindle.power);
  visit("torque", spindle.torque);
}

// Visits the plain numbers of a setup; groups: those that are objects.
template <class Setup>
requires std::same_as<std::remove_const_t<Setup>, LatheSetup>
void visitFields(Setup& setup, const auto& visit) {
  visit("compound_angle", setup.compoundAngle);
  visit("lead_screw_pitch", setup.leadScrewPitch);
  visit("rapid_speed", setup.rapidSpeed);
  visit("hand_speed", setup.handSpeed);
  visit("hand_feed", setup.handFeed);
  visit("depth_limit", setup.depthLimit);
  visit("wear", setup.wear);
  visit("shows_diameter", setup.showsDiameter);
}
template <class Setup>
void visitGroups(Setup& setup, const auto& visit) {
  visit("chuck", setup.chuck);
  visit("tailstock", setup.tailstock);
  visit("spindle", setup.spindle);
}

template <class Tool>
requires std::same_as<std::remove_const_t<Tool>, LatheTool>
void visitFields(Tool& tool, const auto& visit) {
  visit("id", tool.id);
  visit("designation", tool.designation);
  visit("side", tool.side);
  visit("nose_radius", tool.noseRadius);
  visit("orientation", tool.orientation);
  visit("entering_angle", tool.enteringAngle);
  visit("rake", tool.rake);
  visit("depth_per_turn", tool.depthPerTurn);
  visit("least_roughness", tool.leastRoughness);
}
template <class Tool>
void visitSections(Tool& tool, const auto& visit) {
  visit("cutting", tool.cutting);
  visit("holder", tool.holder);
}

template <class Value>
json objectOf(const Value& value) {
  json object = json::object();
  visitFields(value, LatheFieldWriter(object));
  return object;
}

template <class Value>
void takeFields(const json& object, Value& value) {
  visitFields(value, LatheFieldReader(object));
}

json sectionsJson(const std::vector<RoundedPolygon>& sections) {
  json list = json::array();
  for (const RoundedPolygon& section : sections) {
    json corners = json::array();
    for (const ProfilePoint& p : section.corners()) corners.push_back({p.x(), p.y()});
    list.push_back({{kCornersKey, std::move(corners)}, {kRadiusKey, section.radius()}});
  }
  return list;
}

Status takeSections(const json& list, const std::string& tool, std::vector<RoundedPolygon>& sections) {
  if (!list.is_array() || list.size() > LatheTool::kMostSections) return wrong(tool, "too many sections, or no list");
  for (const json& entry : list) {
    const json& corners = memberOf(entry, kCornersKey);
    std::vector<ProfilePoint> points;
    const double nan = std::nan("");
    for (std::size_t i = 0; corners.is_array() && i < std::min(corners.size(), RoundedPolygon::kMostCorners + 1); ++i) {
      points.emplace_back(nan, nan);
      LatheFieldReader{json{{kCornersKey, corners[i]}}}(kCornersKey, points.back());
    }
    double radius = 0.0;
    LatheFieldReader{entry}(kRadiusKey, radius);
    const bool isNear = std::all_of(points.begin(), points.end(), [](const ProfilePoint& p) {
      return std::abs(p.x()) <= kLargestCornerCoordinate && std::abs(p.y()) <= kLargestCornerCoordinate;
    });
    if (!isNear || !(radius <= kLargestCornerCoordinate) || !RoundedPolygon::isSound(points, radius))
      return wrong(tool, "a section has no corners, too many, or impossible ones");
    sections.emplace_back(points, radius);
  }
  return Done{};
}

}  // namespace

json toJson(const LatheTool& tool) {
  json object = objectOf(tool);
  object[kToolKindKey] = idOf(tool.kind);
  visitSections(tool, [&](const char* key, const auto& sections) { object[key] = sectionsJson(sections); });
  return object;
}

Result<LatheTool> latheToolFrom(const json& value) {
  LatheTool tool;
  std::string kind;
  takeFields(value, tool);
  LatheFieldReader{value}(kToolKindKey, kind);
  const std::string name = "tool " + tool.id;
  const auto found = latheToolKindNamed(kind);
  if (tool.id.empty()) return wrong("tool", "it has no id");
  if (!found) return wrong(name, "its kind is unknown");
  const bool isPossible = tool.noseRadius >= 0.0 && tool.noseRadius <= kLargestCornerCoordinate &&
                          tool.orientation >= 1 && tool.orientation <= 9 && tool.enteringAngle > 0.0 &&
                          tool.enteringAngle < 180.0 && std::abs(tool.rake) < 90.0 && tool.depthPerTurn >= 0.0 &&
                          tool.depthPerTurn <= 10.0 && tool.leastRoughness >= 0.0 && tool.leastRoughness <= 1e3;
  if (!isPossible) return wrong(name, "one of its numbers is impossible");
  tool.kind = *found;
  Status taken = Done{};
  visitSections(tool, [&](const char* key, auto& sections) {
    if (taken) taken = takeSections(memberOf(value, key), name, sections);
  });
  if (!taken) return taken.error();
  if (tool.cutting.empty()) return wrong(name, "it has no cutting part");
  return tool;
}

json toJson(const LatheSetup& setup) {
  json object = objectOf(setup);
  visitGroups(setup, [&](const char* key, const auto& group) { object[key] = objectOf(group); });
  for (std::size_t i = 0; i < kLatheAxes; ++i) object[kDialsKey][kAxisNames[i]] = objectOf(setup.dials[i]);
  object[kSlotsKey] = json::array();
  for (const LatheSlot& slot : setup.stations) object[kSlotsKey].push_back(objectOf(slot));
  if (!setup.allowed.empty()) object[kAllowedKey] = setup.allowed;
  return object;
}

Result<LatheSetup> latheSetupFrom(const json& value) {
  if (!value.is_object()) return wrong("lathe", "it is not an object");
  LatheSetup setup;
  takeFields(value, setup);
  visitGroups(setup, [&](const char* key, auto& group) { takeFields(memberOf(value, key), group); });
  for (std::size_t i = 0; i < kLatheAxes; ++i)
    takeFields(memberOf(memberOf(value, kDialsKey), kAxisNames[i]), setup.dials[i]);
  if (const json& slots = memberOf(value, kSlotsKey); slots.is_array()) {
    for (std::size_t i = 0; i < std::min(slots.size(), LatheSetup::kMostSlots); ++i)
      takeFields(slots[i], setup.stations.emplace_back());
  }
  if (const json& allowed = memberOf(value, kAllowedKey); allowed.is_array()) {
    for (const json& id : allowed)
      if (id.is_string()) setup.allowed.push_back(id.get<std::string>());
  }
  if (!setup.isSound()) return wrong("lathe", "it has no tool, or one of its numbers is impossible");
  return setup;
}

LatheTools shippedLatheTools() {
  LatheTools tools;
  const json file = json::parse(latheToolsResource());
  for (const json& entry : file.at("tools")) {
    Result<LatheTool> tool = latheToolFrom(entry);
    assert(tool);  // a test reads the file
    if (tool) tools.push_back(std::make_shared<const LatheTool>(std::move(*tool)));
  }
  return tools;
}

}  // namespace handwheel
