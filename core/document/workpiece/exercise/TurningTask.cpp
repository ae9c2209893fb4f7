// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/TurningTask.h"

#include "base/JsonText.h"
#include "base/NumberText.h"
#include "document/container/UnknownPart.h"
#include "document/workpiece/exercise/TargetJson.h"
#include "document/workpiece/target/TargetPosition.h"
#include "machining/force/WorkMaterials.h"
#include "machining/lathe/LatheJson.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using Json = nlohmann::json;

// A number of a task: its key in files, which is the id of its property, and its limits.
struct TaskNumber {
  const char* id;
  const char* group;
  const char* label;
  double least, largest;
  Quantity quantity;
  double& (*at)(TurningTask& task);
};

std::span<const TaskNumber> taskNumbers() {
  static const char* const kStock = QT_TRANSLATE_NOOP("Property", "Stock");
  static const char* const kLathe = QT_TRANSLATE_NOOP("Property", "Lathe");
  static const std::array<TaskNumber, 8> kNumbers = {{
      {"diameter", kStock, QT_TRANSLATE_NOOP("Property", "Diameter"), 0.1, 2000.0, Quantity::Length,
       [](TurningTask& t) -> double& { return t.stock.diameter; }},
      {"length", kStock, QT_TRANSLATE_NOOP("Property", "Length"), 0.1, 5000.0, Quantity::Length,
       [](TurningTask& t) -> double& { return t.stock.length; }},
      {"spindle_speed", kLathe, QT_TRANSLATE_NOOP("Property", "Spindle speed (r/min)"), 0.0, TurningTask::kLargestSpeed,
       Quantity::Number, [](TurningTask& t) -> double& { return t.lathe.spindleSpeed; }},
      {"chuck_height", kLathe, QT_TRANSLATE_NOOP("Property", "Held by the chuck"), 0.0, 5000.0, Quantity::Length,
       [](TurningTask& t) -> double& { return t.lathe.chuckHeight; }},
      {"chuck_diameter", kLathe, QT_TRANSLATE_NOOP("Property", "Diameter of the chuck"), 0.0, 5000.0, Quantity::Length,
       [](TurningTask& t) -> double& { return t.lathe.chuckDiameter; }},
      {"largest_feed", kLathe, QT_TRANSLATE_NOOP("Property", "Largest feed (mm per revolution)"), 1e-3,
       TurningTask::kLargestFeed, Quantity::Number, [](TurningTask& t) -> double& { return t.lathe.largestFeed; }},
      {"force_limit", kLathe, QT_TRANSLATE_NOOP("Property", "Largest resultant force (N)"), 0.0, 1e6, Quantity::Number,
       [](TurningTask& t) -> double& { return t.forceLimit; }},
      {"power_limit", kLathe, QT_TRANSLATE_NOOP("Property", "Motor power (kW)"), 0.0, 1e4, Quantity::Number,
       [](TurningTask& t) -> double& { return t.powerLimit; }},
  }};
  return kNumbers;
}

double valueOf(const TaskNumber& number, const TurningTask& task) {
  return number.at(const_cast<TurningTask&>(task));  // the task is only read
}

const WorkMaterials& materials() {
  const WorkMaterials& kMaterials = WorkMaterials::standard();
  return kMaterials;
}

constexpr std::string_view kToolPrefix = "tool.";

// A switch of a task: its key in files, which is the id of its property. Its default value is not written, so that
// tasks without it keep their key.
struct TaskSwitch {
  const char* id;
  const char* label;
  bool TurningTask::*at;
};
constexpr std::array<TaskSwitch, 2> kSwitches = {
    {{"programs", QT_TRANSLATE_NOOP("Property", "Programs allowed"), &TurningTask::areProgramsAllowed},
     {"commands", QT_TRANSLATE_NOOP("Property", "Commands that cut, such as Thread, allowed"),
      &TurningTask::areCommandsAllowed}}};

std::string nameOf(const LatheTool& tool) {
  return std::string(titleOf(tool.kind)) + " " + tool.designation;
}

bool isAllowedIn(const TurningTask& task, const std::string& id) {
  return std::any_of(task.tools.begin(), task.tools.end(), [&](const AllowedTool& each) { return each.tool == id; });
}

// The tools of the lathe, to be checked.
std::vector<Property> toolProperties(const TurningTask& task) {
  std::vector<Property> all;
  for (const auto& tool : shippedLatheTools()) {
    Property p;
    p.id = std::string(kToolPrefix) + tool->id;
    p.group = QT_TRANSLATE_NOOP("Property", "Tools that students may mount; none checked: all");
    p.label = QCoreApplication::translate("LatheTool", titleOf(tool->kind)).toStdString() + " " + tool->designation;
    p.translated = false;
    p.value = isAllowedIn(task, tool->id);
    all.push_back(std::move(p));
  }
  return all;
}

Result<TurningTask> withTool(TurningTask task, const std::string& property, const PropertyValue& value) {
  const auto* isOn = std::get_if<bool>(&value);
  if (!isOn) return Error{ErrorCode::ElementMalformed, {property, "a switch was expected"}, {}, {}};
  const auto tool = toolNamed(shippedLatheTools(), property.substr(kToolPrefix.size()));
  if (!tool) return Error{ErrorCode::ReferenceMissing, {"property", property, {}}, {}, {}};
  if (*isOn && !isAllowedIn(task, tool->id)) {
    if (task.tools.size() >= TurningTask::kMostTools)
      return Error{ErrorCode::ElementMalformed, {property, "there are too many tools"}, {}, {}};
    const double nose = std::clamp(tool->noseRadius, TurningPass::kLeastNose, TurningPass::kLargestNose);
    task.tools.push_back({nameOf(*tool), nose, tool->id});
  }
  if (!*isOn) std::erase_if(task.tools, [&](const AllowedTool& each) { return each.tool == tool->id; });
  return task;
}

Json toolJson(const AllowedTool& tool) {
  Json json = {{"name", tool.name}, {"nose_radius", tool.noseRadius}};
  if (!tool.tool.empty()) json["tool"] = tool.tool;
  return json;
}

Error outOfRange(const TaskNumber& number, double value) {
  return {ErrorCode::ValueOutOfRange,
          {number.id, shownText(value), shownText(number.least), shownText(number.largest)},
          {},
          {}};
}

}  // namespace

Json toJson(const TurningTask& task) {
  Json json = Json::object();
  for (const TaskNumber& number : taskNumbers()) json[number.id] = valueOf(number, task);
  json["material"] = task.material;
  for (const TaskSwitch& each : kSwitches)
    if (task.*each.at != TurningTask().*each.at) json[each.id] = task.*each.at;
  json["tools"] = Json::array();
  for (const AllowedTool& tool : task.tools) {
    const Json beyond = tool.others.empty() ? Json::object() : Json::parse(tool.others, nullptr, false);
    json["tools"].push_back(withUnknown(beyond, toolJson(tool)));
  }
  json["target"] = nullptr;
  if (task.target) json["target"] = toJson(*task.target);
  return json;
}

TurningTask turningTaskFrom(const Json& json, std::vector<Error>& damage) {
  TurningTask task;
  if (!json.is_object()) {
    damage.push_back({ErrorCode::ElementMalformed, {"task", "it is missing"}, {}, {}});
    return task;
  }
  for (const TaskNumber& number : taskNumbers()) {
    const auto found = json.find(number.id);
    if (found == json.end()) continue;
    const double value = found->is_number() ? found->get<double>() : std::nan("");
    if (value >= number.least && value <= number.largest) {
      number.at(task) = value;
    } else {
      damage.push_back(outOfRange(number, value));
    }
  }
  if (const std::string id = stringAt(json, "material", TurningTask().material); materials().find(id)) {
    task.material = id;
  } else {
    task.material = TurningTask().material;
    damage.push_back({ErrorCode::ElementMalformed, {"material", "it is not known"}, {}, {}});
  }
  for (const TaskSwitch& each : kSwitches) {
    const auto found = json.find(each.id);
    if (found == json.end()) continue;
    if (found->is_boolean())
      task.*each.at = found->get<bool>();
    else
      damage.push_back({ErrorCode::ElementMalformed, {each.id, "a switch was expected"}, {}, {}});
  }
  if (const auto tools = json.find("tools"); tools != json.end() && tools->is_array()) {
    for (const Json& each : *tools) {
      const auto nose = each.is_object() ? each.find("nose_radius") : each.end();
      const double radius = nose != each.end() && nose->is_number() ? nose->get<double>() : AllowedTool().noseRadius;
      AllowedTool tool{stringAt(each, "name"), radius, stringAt(each, "tool")};
      const bool isSound = radius >= TurningPass::kLeastNose && radius <= TurningPass::kLargestNose &&
                           tool.name.size() <= Exercise::kLongestText && task.tools.size() < TurningTask::kMostTools &&
                           (tool.tool.empty() || toolNamed(shippedLatheTools(), tool.tool));
      if (const Json beyond = each.is_object() ? keysBeyond(each, toolJson(tool)) : Json(); !beyond.empty())
        tool.others = beyond.dump();
      if (isSound) {
        task.tools.push_back(std::move(tool));
      } else {
        damage.push_back({ErrorCode::ElementMalformed, {"tools", "a tool is impossible or not known"}, {}, {}});
      }
    }
  }
  task.target = targetFrom(json.value("target", Json()), damage);
  return task;
}

std::vector<Property> propertiesOf(const TurningTask& task) {
  std::vector<Property> all;
  for (const TaskNumber& number : taskNumbers()) {
    Property p;
    p.id = number.id;
    p.group = number.group;
    p.label = number.label;
    p.value = valueOf(number, task);
    p.quantity = number.quantity;
    p.least = number.least;
    p.largest = number.largest;
    if (p.id.ends_with("diameter")) p.prefix = "⌀";
    all.push_back(std::move(p));
  }
  for (const TaskSwitch& each : kSwitches) {
    Property allowed;
    allowed.id = each.id;
    allowed.group = all.back().group;
    allowed.label = each.label;
    allowed.value = task.*each.at;
    all.push_back(std::move(allowed));
  }
  Property material;
  material.id = "material";
  material.group = all.front().group;
  material.label = QT_TRANSLATE_NOOP("Property", "Material");
  material.value = 0.0;
  for (std::size_t i = 0; i < materials().all().size(); ++i) {
    material.choices.push_back(materials().all()[i].name);
    if (materials().all()[i].id == task.material) material.value = static_cast<double>(i);
  }
  all.insert(all.begin() + 2, std::move(material));
  if (task.target)
    for (Property& each : positionProperties(*task.target, task.stock)) all.push_back(std::move(each));
  for (Property& tool : toolProperties(task)) all.push_back(std::move(tool));
  return all;
}

Result<TurningTask> withTaskProperty(TurningTask task, const std::string& id, const PropertyValue& value) {
  const auto* number = std::get_if<double>(&value);
  const auto malformed = [&](const char* what) { return Error{ErrorCode::ElementMalformed, {id, what}, {}, {}}; };
  if (id == "material") {
    if (!number || !(*number >= 0.0 && *number < static_cast<double>(materials().all().size())))
      return malformed("there is no such choice");
    task.material = materials().all()[static_cast<std::size_t>(*number)].id;
    return task;
  }
  for (const TaskSwitch& each : kSwitches) {
    if (id != each.id) continue;
    const auto* isOn = std::get_if<bool>(&value);
    if (!isOn) return malformed("a switch was expected");
    task.*each.at = *isOn;
    return task;
  }
  if (id == kAllowanceId && task.target) {
    Result<TargetProfile> placed = withPosition(*task.target, task.stock, value);
    if (!placed) return placed.error();
    task.target = std::move(*placed);
    return task;
  }
  if (id.starts_with(kToolPrefix)) return withTool(std::move(task), id, value);
  for (const TaskNumber& each : taskNumbers()) {
    if (id != each.id) continue;
    if (!number) return malformed("a number was expected");
    if (!(*number >= each.least && *number <= each.largest)) return outOfRange(each, *number);
    each.at(task) = *number;
    return task;
  }
  return Error{ErrorCode::ReferenceMissing, {"property", id, {}}, {}, {}};
}

}  // namespace handwheel
