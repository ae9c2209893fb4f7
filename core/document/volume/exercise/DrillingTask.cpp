// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/exercise/DrillingTask.h"

#include "base/JsonText.h"
#include "base/NumberText.h"
#include "document/volume/exercise/DrillingStock.h"
#include "volume/drilling/DrillBits.h"
#include "volume/drilling/Skull.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

using Json = nlohmann::json;

constexpr const char *kStock = "stock", *kSkull = "skull", *kForbidden = "forbidden", *kDrill = "drill",
                     *kMaterial = "material", *kEntry = "entry", *kDirection = "direction",
                     *kFailedTries = "failed_tries";
// In the order of FailedTries.
constexpr std::array kFailedTriesWords = {"cost_the_mark", "fail_the_work", "are_listed"};
constexpr double kFarthestPosition = 1e5;  // mm, largest coordinate

// A number of a task: its key in files, which is the id of its property, and its limits.
struct TaskNumber {
  const char* id;
  const char* label;
  double least, largest;
  Quantity quantity;
  double& (*at)(DrillingTask& task);
};

const char* drillGroup() {
  return QT_TRANSLATE_NOOP("Property", "Drill");
}
const char* planGroup() {
  return QT_TRANSLATE_NOOP("Property", "Planned path");
}

constexpr std::array<TaskNumber, 3> kNumbers = {{
    {"tolerance", QT_TRANSLATE_NOOP("Property", "Tolerance of the path"), 0.01, 1000.0, Quantity::Length,
     [](DrillingTask& t) -> double& { return t.plan.tolerance; }},
    {"spindle_speed", QT_TRANSLATE_NOOP("Property", "Spindle speed (r/min)"), 1.0, 100'000.0, Quantity::Number,
     [](DrillingTask& t) -> double& { return t.spindle; }},
    {"feed", QT_TRANSLATE_NOOP("Property", "Feed by the mouse (mm/s)"), 0.05, 50.0, Quantity::Number,
     [](DrillingTask& t) -> double& { return t.feed; }},
}};

double valueOf(const TaskNumber& number, const DrillingTask& task) {
  return number.at(const_cast<DrillingTask&>(task));  // only read
}

Json numbersOf(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

// A saw moves across its axis, which a planned path does not describe.
std::optional<DrillBit> drillIn(const std::string& word) {
  const std::optional<DrillBit> tool = drillBitOf(word);
  return tool && tool->shape != DrillShape::Saw ? tool : std::nullopt;
}

std::optional<Vec3> positionIn(const std::vector<double>& numbers) {
  if (numbers.size() != 3) return std::nullopt;
  const Vec3 p(numbers[0], numbers[1], numbers[2]);
  return p.allFinite() && p.cwiseAbs().maxCoeff() <= kFarthestPosition ? std::optional(p) : std::nullopt;
}

std::optional<Vec3> directionIn(const std::vector<double>& numbers) {
  const std::optional<Vec3> v = positionIn(numbers);
  return v && v->norm() > 1e-6 ? std::optional<Vec3>(v->normalized()) : std::nullopt;
}

std::optional<SolidBall> ballIn(const std::vector<double>& numbers) {
  if (numbers.size() != 4 || !(numbers[3] > 0.0 && numbers[3] <= kFarthestPosition)) return std::nullopt;
  const std::optional<Vec3> centre = positionIn({numbers[0], numbers[1], numbers[2]});
  return centre ? std::optional(SolidBall{*centre, numbers[3]}) : std::nullopt;
}

// "0; 0; 0; 56 | 0; 26; 0; 50": numbers in the C locale, as all texts of numbers in exercises.
std::vector<std::vector<double>> rowsIn(const std::string& text, bool& isSound) {
  std::vector<std::vector<double>> rows;
  isSound = true;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('|', begin), text.size());
    std::vector<double> row;
    for (std::size_t at = begin; at < end;) {
      const std::size_t stop = std::min(text.find(';', at), end);
      std::string word = text.substr(at, stop - at);
      word.erase(0, word.find_first_not_of(' '));
      word.erase(word.find_last_not_of(' ') + 1);
      double number = 0.0;
      ErrorCode why{};
      isSound = isSound && parseDecimal(word, number, why);
      row.push_back(number);
      at = stop + 1;
    }
    if (!row.empty()) rows.push_back(std::move(row));
    begin = end + 1;
  }
  return rows;
}

std::string rowText(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : "; ") + shownText(number);
  return text;
}

std::string forbiddenText(const DrillingTask& task) {
  std::string text;
  for (const SolidBall& ball : task.plan.forbidden)
    text += (text.empty() ? "" : " | ") + rowText({ball.centre.x(), ball.centre.y(), ball.centre.z(), ball.radius});
  return text;
}

Property textProperty(const char* id, const char* group, const char* label, std::string text) {
  Property p;
  p.id = id;
  p.group = group;
  p.label = label;
  p.value = std::move(text);
  return p;
}

Error malformedTask(const std::string& id, const char* what) {
  return {ErrorCode::ElementMalformed, {id, what}, {}, {}};
}

Error outOfRange(const TaskNumber& number, double value) {
  return {ErrorCode::ValueOutOfRange,
          {number.id, shownText(value), shownText(number.least), shownText(number.largest)},
          {},
          {}};
}

Result<DrillingTask> withText(DrillingTask task, const std::string& id, const std::string& text) {
  if (id == kDrill) {
    const std::optional<DrillBit> tool = drillIn(text);
    if (!tool) return malformedTask(id, "a drill was expected, such as ball:6, burr:4 or twist:3");
    task.tool = *tool;
    return task;
  }
  bool isSound = true;
  const std::vector<std::vector<double>> rows = rowsIn(text, isSound);
  const std::vector<double> first = rows.size() == 1 ? rows.front() : std::vector<double>();
  if (id == kEntry) {
    const std::optional<Vec3> position = positionIn(first);
    if (!isSound || !position) return malformedTask(id, "three lengths were expected, with “;” between them");
    task.plan.entry = *position;
  } else if (id == kDirection) {
    const std::optional<Vec3> direction = directionIn(first);
    if (!isSound || !direction) return malformedTask(id, "three numbers were expected, with “;” between them");
    task.plan.direction = *direction;
  } else {
    task.plan.forbidden.clear();
    for (const std::vector<double>& row : rows) {
      const std::optional<SolidBall> ball = ballIn(row);
      if (!isSound || !ball || task.plan.forbidden.size() == DrillingTask::kMostForbidden)
        return malformedTask(id, "balls were expected: x; y; z; radius, with “|” between them");
      task.plan.forbidden.push_back(*ball);
    }
  }
  return task;
}

std::shared_ptr<const DrillingStock> stockIn(const Json& json, std::vector<Error>& damage) {
  const auto found = json.find(kStock);
  if (found == json.end() || *found == kSkull) return nullptr;
  Result<DrillingStock> stock = stockFrom(*found);
  if (stock) return std::make_shared<const DrillingStock>(std::move(*stock));
  damage.push_back(stock.error());
  return nullptr;
}

void readPlan(DrillingTask& task, const Json& json, std::vector<Error>& damage) {
  const auto fail = [&](const char* key) { damage.push_back(malformedTask(key, "it is impossible")); };
  if (json.contains(kEntry)) {
    const auto entry = positionIn(numbersAt(json, kEntry, 4));
    entry ? void(task.plan.entry = *entry) : fail(kEntry);
  }
  if (json.contains(kDirection)) {
    const auto direction = directionIn(numbersAt(json, kDirection, 4));
    direction ? void(task.plan.direction = *direction) : fail(kDirection);
  }
  const auto balls = json.find(kForbidden);
  if (balls == json.end() || !balls->is_array()) return;
  task.plan.forbidden.clear();
  for (const Json& each : *balls) {
    const auto ball = ballIn(numbersAt(Json{{kForbidden, each}}, kForbidden, 5));
    if (ball && task.plan.forbidden.size() < DrillingTask::kMostForbidden) {
      task.plan.forbidden.push_back(*ball);
    } else {
      fail(kForbidden);
    }
  }
}

}  // namespace

DrillingTask DrillingTask::ofSkull() {
  DrillingTask task;
  const SkullSite site = skullSite();
  task.plan = {site.entry, site.direction, 1.0, skullBrain()};
  return task;
}

const SparseVolume& DrillingTask::volume() const {
  return stock ? stock->volume() : shippedSkull();
}

DrillSetup DrillingTask::setup() const {
  return {tool, *drillMaterial(material), spindle * 2.0 * M_PI / 60.0};
}

Json toJson(const DrillingTask& task) {
  Json json = Json::object();
  for (const TaskNumber& number : kNumbers) json[number.id] = valueOf(number, task);
  json[kStock] = task.stock ? *task.stock->json() : Json(kSkull);
  json[kEntry] = numbersOf(task.plan.entry);
  json[kDirection] = numbersOf(task.plan.direction);
  json[kForbidden] = Json::array();
  for (const SolidBall& ball : task.plan.forbidden)
    json[kForbidden].push_back({ball.centre.x(), ball.centre.y(), ball.centre.z(), ball.radius});
  json[kDrill] = wordOf(task.tool);
  json[kMaterial] = task.material;
  // The default is not written, as the keys of descriptions without it depend on their tasks.
  if (task.failedTries != FailedTries::CostTheMark)
    json[kFailedTries] = kFailedTriesWords[static_cast<std::size_t>(task.failedTries)];
  return json;
}

DrillingTask drillingTaskFrom(const Json& json, std::vector<Error>& damage) {
  DrillingTask task = DrillingTask::ofSkull();
  if (!json.is_object()) {
    damage.push_back(malformedTask("task", "it is missing"));
    return task;
  }
  for (const TaskNumber& number : kNumbers) {
    const auto found = json.find(number.id);
    if (found == json.end()) continue;
    const double value = found->is_number() ? found->get<double>() : std::nan("");
    if (value >= number.least && value <= number.largest) {
      number.at(task) = value;
    } else {
      damage.push_back(outOfRange(number, value));
    }
  }
  task.stock = stockIn(json, damage);
  readPlan(task, json, damage);
  if (const std::string id = stringAt(json, kMaterial, task.material); drillMaterial(id)) {
    task.material = id;
  } else {
    damage.push_back(malformedTask(kMaterial, "it is not known"));
  }
  if (const auto tool = drillIn(stringAt(json, kDrill, wordOf(task.tool)))) {
    task.tool = *tool;
  } else {
    damage.push_back(malformedTask(kDrill, "it is no drill"));
  }
  const std::string rule = stringAt(json, kFailedTries, kFailedTriesWords.front());
  const auto* const known = std::find(kFailedTriesWords.begin(), kFailedTriesWords.end(), rule);
  if (known != kFailedTriesWords.end()) {
    task.failedTries = static_cast<FailedTries>(known - kFailedTriesWords.begin());
  } else {
    damage.push_back(malformedTask(kFailedTries, "it is not known"));
  }
  return task;
}

std::vector<Property> propertiesOf(const DrillingTask& task) {
  const Vec3 &entry = task.plan.entry, &direction = task.plan.direction;
  std::vector<Property> all = {
      textProperty(kEntry, planGroup(), QT_TRANSLATE_NOOP("Property", "Entry (mm): x; y; z"),
                   rowText({entry.x(), entry.y(), entry.z()})),
      textProperty(kDirection, planGroup(), QT_TRANSLATE_NOOP("Property", "Direction: x; y; z"),
                   rowText({direction.x(), direction.y(), direction.z()}))};
  for (const TaskNumber& number : kNumbers) {
    Property p;
    p.id = number.id;
    p.group = number.at == kNumbers[0].at ? planGroup() : drillGroup();
    p.label = number.label;
    p.value = valueOf(number, task);
    p.quantity = number.quantity;
    p.least = number.least;
    p.largest = number.largest;
    all.push_back(std::move(p));
  }
  all.insert(all.begin() + 3,
             textProperty(kForbidden, planGroup(),
                          QT_TRANSLATE_NOOP("Property", "Forbidden balls (mm): x; y; z; radius, with | between"),
                          forbiddenText(task)));
  all.push_back(textProperty(kDrill, drillGroup(), QT_TRANSLATE_NOOP("Property", "Drill: ball:6, burr:4 or twist:3"),
                             wordOf(task.tool)));
  Property material;
  material.id = kMaterial;
  material.group = drillGroup();
  material.label = QT_TRANSLATE_NOOP("Property", "Material");
  material.value = 0.0;
  for (std::size_t i = 0; i < drillMaterials().size(); ++i) {
    material.choices.push_back(drillMaterials()[i].name);
    if (drillMaterials()[i].id == task.material) material.value = static_cast<double>(i);
  }
  all.push_back(std::move(material));
  Property failedTries;
  failedTries.id = kFailedTries;
  failedTries.group = planGroup();
  failedTries.label = QT_TRANSLATE_NOOP("Property", "Failed tries that were undone");
  failedTries.value = static_cast<double>(task.failedTries);
  failedTries.choices = {QT_TRANSLATE_NOOP("Property", "cost the mark of the forbidden region"),
                         QT_TRANSLATE_NOOP("Property", "fail the work"),
                         QT_TRANSLATE_NOOP("Property", "are listed only")};  // in the order of FailedTries
  all.insert(all.begin() + 4, std::move(failedTries));                       // behind the forbidden balls
  return all;
}

Result<DrillingTask> withTaskProperty(DrillingTask task, const std::string& id, const PropertyValue& value) {
  if (id == kEntry || id == kDirection || id == kForbidden || id == kDrill) {
    const auto* const text = std::get_if<std::string>(&value);
    return text ? withText(std::move(task), id, *text) : Result<DrillingTask>(malformedTask(id, "a text was expected"));
  }
  const auto* const number = std::get_if<double>(&value);
  if (id == kMaterial) {
    if (!number || !(*number >= 0.0 && *number < static_cast<double>(drillMaterials().size())))
      return malformedTask(id, "there is no such choice");
    task.material = drillMaterials()[static_cast<std::size_t>(*number)].id;
    return task;
  }
  if (id == kFailedTries) {
    if (!number || !(*number >= 0.0 && *number < static_cast<double>(kFailedTriesWords.size())))
      return malformedTask(id, "there is no such choice");
    task.failedTries = static_cast<FailedTries>(static_cast<int>(*number));
    return task;
  }
  for (const TaskNumber& each : kNumbers) {
    if (id != each.id) continue;
    if (!number) return malformedTask(id, "a number was expected");
    if (!(*number >= each.least && *number <= each.largest)) return outOfRange(each, *number);
    each.at(task) = *number;
    return task;
  }
  return Error{ErrorCode::ReferenceMissing, {"property", id, {}}, {}, {}};
}

std::shared_ptr<const DrillingTask> assignedDrilling(const AssignedExercise& assigned) {
  if (!assigned || !assigned.description->is_object()) return nullptr;
  const auto task = assigned.description->find("task");
  if (task == assigned.description->end() || stringAt(*assigned.description, "subject") != "drilling") return nullptr;
  Json plan = Json::object();
  for (const auto& [key, value] : task->items())
    if (key != kStock) plan[key] = value;  // the stock may be large
  std::vector<Error> damage;               // reported by the reader of the exercise
  return std::make_shared<const DrillingTask>(drillingTaskFrom(plan, damage));
}

}  // namespace handwheel
