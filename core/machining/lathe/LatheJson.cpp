// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/LatheJson.h"

#include "machining/lathe/LatheResources.h"

#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using nlohmann::json;

constexpr double kLargestPlace = 1e4;  // mm, of a corner of a tool

Error wrong(std::string element, const char* what) {
  return {ErrorCode::ElementMalformed, {std::move(element), what}, {}, {}};
}

const json& memberOf(const json& object, const char* key) {
  static const json kNothing;
  if (!object.is_object()) return kNothing;
  const auto found = object.find(key);
  return found == object.end() ? kNothing : *found;
}

// Takes what is there and of the right type.
void takeIf(const json& object, const char* key, double& value) {
  if (const json& found = memberOf(object, key); found.is_number()) value = found.get<double>();
}
void takeIf(const json& object, const char* key, int& value) {
  const json& found = memberOf(object, key);
  if (found.is_number_integer() && std::abs(found.get<double>()) < 1e9) value = found.get<int>();
}
void takeIf(const json& object, const char* key, bool& value) {
  if (const json& found = memberOf(object, key); found.is_boolean()) value = found.get<bool>();
}
void takeIf(const json& object, const char* key, std::string& value) {
  if (const json& found = memberOf(object, key); found.is_string()) value = found.get<std::string>();
}
void takeIf(const json& object, const char* key, ProfilePoint& value) {
  const json& found = memberOf(object, key);
  if (found.is_array() && found.size() == 2 && found[0].is_number() && found[1].is_number())
    value = {found[0].get<double>(), found[1].get<double>()};
}

json pointJson(const ProfilePoint& p) {
  return json::array({p.x(), p.y()});
}

json sectionsJson(const std::vector<RoundedSection>& sections) {
  json list = json::array();
  for (const RoundedSection& section : sections) {
    json corners = json::array();
    for (const ProfilePoint& p : section.corners()) corners.push_back(pointJson(p));
    list.push_back({{"corners", std::move(corners)}, {"radius", section.radius()}});
  }
  return list;
}

Status takeSections(const json& list, const std::string& tool, std::vector<RoundedSection>& sections) {
  if (!list.is_array() || list.size() > LatheTool::kMostSections) return wrong(tool, "too many sections, or no list");
  for (const json& entry : list) {
    const json& corners = memberOf(entry, "corners");
    std::vector<ProfilePoint> points;
    const double nan = std::nan("");
    for (std::size_t i = 0; corners.is_array() && i < std::min(corners.size(), RoundedSection::kMostCorners + 1); ++i) {
      points.emplace_back(nan, nan);
      takeIf(json{{"at", corners[i]}}, "at", points.back());
    }
    double radius = 0.0;
    takeIf(entry, "radius", radius);
    const bool isNear = std::all_of(points.begin(), points.end(), [](const ProfilePoint& p) {
      return std::abs(p.x()) <= kLargestPlace && std::abs(p.y()) <= kLargestPlace;
    });
    if (!isNear || !(radius <= kLargestPlace) || !RoundedSection::isSound(points, radius))
      return wrong(tool, "a section has no corners, too many, or impossible ones");
    sections.emplace_back(points, radius);
  }
  return Done{};
}

constexpr const char* kAxisNames[kLatheAxes] = {"carriage", "cross", "compound", "quill"};
constexpr const char* kFittingNames[] = {"none", "centre", "drill"};

json dialJson(const LatheDial& dial) {
  return {{"divisions", dial.divisions},
          {"per_division", dial.perDivision},
          {"backlash", dial.backlash},
          {"least", dial.least},
          {"largest", dial.largest}};
}

void takeDial(const json& value, LatheDial& dial) {
  takeIf(value, "divisions", dial.divisions);
  takeIf(value, "per_division", dial.perDivision);
  takeIf(value, "backlash", dial.backlash);
  takeIf(value, "least", dial.least);
  takeIf(value, "largest", dial.largest);
}

json slotJson(const LatheSlot& slot) {
  return {{"tool", slot.tool},
          {"place", pointJson(slot.place)},
          {"offset", pointJson(slot.offset)},
          {"has_radius_offset", slot.hasOffset[0]},
          {"has_z_offset", slot.hasOffset[1]}};
}

LatheSlot slotFrom(const json& value) {
  LatheSlot slot;
  takeIf(value, "tool", slot.tool);
  takeIf(value, "place", slot.place);
  takeIf(value, "offset", slot.offset);
  takeIf(value, "has_radius_offset", slot.hasOffset[0]);
  takeIf(value, "has_z_offset", slot.hasOffset[1]);
  return slot;
}

void takeChuck(const json& value, LatheChuck& chuck) {
  takeIf(value, "diameter", chuck.diameter);
  takeIf(value, "length", chuck.length);
  takeIf(value, "jaw_length", chuck.jawLength);
  takeIf(value, "jaw_height", chuck.jawHeight);
  takeIf(value, "jaw_width", chuck.jawWidth);
  takeIf(value, "grip", chuck.grip);
  takeIf(value, "grips_inside", chuck.gripsInside);
}

void takeTailstock(const json& value, LatheTailstock& tailstock) {
  std::string fitting;
  takeIf(value, "fitting", fitting);
  for (std::size_t i = 0; i < std::size(kFittingNames); ++i) {
    if (fitting == kFittingNames[i]) tailstock.fitting = static_cast<LatheFitting>(i);
  }
  takeIf(value, "drill", tailstock.drill);
  takeIf(value, "place", tailstock.place);
  takeIf(value, "quill_diameter", tailstock.quillDiameter);
  takeIf(value, "body_radius", tailstock.bodyRadius);
}

void takeSpindle(const json& value, LatheSpindle& spindle) {
  takeIf(value, "least_speed", spindle.leastSpeed);
  takeIf(value, "largest_speed", spindle.largestSpeed);
  takeIf(value, "speed", spindle.speed);
  takeIf(value, "acceleration", spindle.acceleration);
  takeIf(value, "power", spindle.power);
  takeIf(value, "torque", spindle.torque);
}

}  // namespace

json toJson(const LatheTool& tool) {
  return {{"id", tool.id},
          {"kind", idOf(tool.kind)},
          {"designation", tool.designation},
          {"side", tool.side == TurningSide::Bore ? "inside" : "outside"},
          {"nose_radius", tool.noseRadius},
          {"orientation", tool.orientation},
          {"entering_angle", tool.enteringAngle},
          {"rake", tool.rake},
          {"depth_per_turn", tool.depthPerTurn},
          {"least_roughness", tool.leastRoughness},
          {"cutting", sectionsJson(tool.cutting)},
          {"holder", sectionsJson(tool.holder)}};
}

Result<LatheTool> latheToolFrom(const json& value) {
  LatheTool tool;
  std::string kind, side;
  takeIf(value, "id", tool.id);
  takeIf(value, "kind", kind);
  takeIf(value, "designation", tool.designation);
  takeIf(value, "side", side);
  takeIf(value, "nose_radius", tool.noseRadius);
  takeIf(value, "orientation", tool.orientation);
  takeIf(value, "entering_angle", tool.enteringAngle);
  takeIf(value, "rake", tool.rake);
  takeIf(value, "depth_per_turn", tool.depthPerTurn);
  takeIf(value, "least_roughness", tool.leastRoughness);
  const std::string name = "tool " + tool.id;
  const auto found = latheToolKindNamed(kind);
  if (tool.id.empty()) return wrong("tool", "it has no id");
  if (!found) return wrong(name, "its kind is unknown");
  const bool isPossible = tool.noseRadius >= 0.0 && tool.noseRadius <= kLargestPlace && tool.orientation >= 1 &&
                          tool.orientation <= 9 && tool.enteringAngle > 0.0 && tool.enteringAngle < 180.0 &&
                          std::abs(tool.rake) < 90.0 && tool.depthPerTurn >= 0.0 && tool.depthPerTurn <= 10.0 &&
                          tool.leastRoughness >= 0.0 && tool.leastRoughness <= 1e3;
  if (!isPossible) return wrong(name, "one of its numbers is impossible");
  tool.kind = *found;
  tool.side = side == "inside" ? TurningSide::Bore : TurningSide::Outside;
  for (const auto& [key, sections] : {std::pair{"cutting", &tool.cutting}, std::pair{"holder", &tool.holder}}) {
    const Status taken = takeSections(memberOf(value, key), name, *sections);
    if (!taken) return taken.error();
  }
  if (tool.cutting.empty()) return wrong(name, "it has no cutting part");
  return tool;
}

json toJson(const LatheSetup& setup) {
  json dials, slots = json::array();
  for (std::size_t i = 0; i < kLatheAxes; ++i) dials[kAxisNames[i]] = dialJson(setup.dials[i]);
  for (const LatheSlot& slot : setup.stations) slots.push_back(slotJson(slot));
  const LatheChuck& chuck = setup.chuck;
  return {{"chuck",
           {{"diameter", chuck.diameter},
            {"length", chuck.length},
            {"jaw_length", chuck.jawLength},
            {"jaw_height", chuck.jawHeight},
            {"jaw_width", chuck.jawWidth},
            {"grip", chuck.grip},
            {"grips_inside", chuck.gripsInside}}},
          {"tailstock",
           {{"fitting", kFittingNames[static_cast<std::size_t>(setup.tailstock.fitting)]},
            {"drill", setup.tailstock.drill},
            {"place", setup.tailstock.place},
            {"quill_diameter", setup.tailstock.quillDiameter},
            {"body_radius", setup.tailstock.bodyRadius}}},
          {"spindle",
           {{"least_speed", setup.spindle.leastSpeed},
            {"largest_speed", setup.spindle.largestSpeed},
            {"speed", setup.spindle.speed},
            {"acceleration", setup.spindle.acceleration},
            {"power", setup.spindle.power},
            {"torque", setup.spindle.torque}}},
          {"dials", std::move(dials)},
          {"slots", std::move(slots)},
          {"compound_angle", setup.compoundAngle},
          {"lead_screw_pitch", setup.leadScrewPitch},
          {"rapid_speed", setup.rapidSpeed},
          {"hand_speed", setup.handSpeed},
          {"hand_feed", setup.handFeed},
          {"depth_limit", setup.depthLimit},
          {"shows_diameter", setup.showsDiameter}};
}

Result<LatheSetup> latheSetupFrom(const json& value) {
  if (!value.is_object()) return wrong("lathe", "it is no object");
  LatheSetup setup;
  takeChuck(memberOf(value, "chuck"), setup.chuck);
  takeTailstock(memberOf(value, "tailstock"), setup.tailstock);
  takeSpindle(memberOf(value, "spindle"), setup.spindle);
  for (std::size_t i = 0; i < kLatheAxes; ++i)
    takeDial(memberOf(memberOf(value, "dials"), kAxisNames[i]), setup.dials[i]);
  if (const json& slots = memberOf(value, "slots"); slots.is_array()) {
    for (std::size_t i = 0; i < std::min(slots.size(), LatheSetup::kMostSlots); ++i)
      setup.stations.push_back(slotFrom(slots[i]));
  }
  takeIf(value, "compound_angle", setup.compoundAngle);
  takeIf(value, "lead_screw_pitch", setup.leadScrewPitch);
  takeIf(value, "rapid_speed", setup.rapidSpeed);
  takeIf(value, "hand_speed", setup.handSpeed);
  takeIf(value, "hand_feed", setup.handFeed);
  takeIf(value, "depth_limit", setup.depthLimit);
  takeIf(value, "shows_diameter", setup.showsDiameter);
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
