// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/PlansBlobs.h"

#include "base/JsonText.h"
#include "document/cell/path/RateProperties.h"
#include "robot/program/PathFile.h"
#include "scene/RigidPose.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

namespace handwheel {

namespace {

using nlohmann::json;

const std::string kPlans = "cell/plans.json";

class PlansReading {
 public:
  PlansReading(const RobotModel& robot, const JointValues& others, std::vector<Error>& damage)
      : m_robot(robot), m_others(others), m_damage(damage) {}

  CellPlans read(const json& stored) {
    readConfigurations(listAt(stored, "configurations"));
    for (const json& entry : listAt(stored, "frames", CellPlans::kMostFrames)) readFrame(entry);
    for (const json& entry : listAt(stored, "targets")) readTarget(entry);
    for (const json& entry : listAt(stored, "paths")) readOnePath(entry);
    for (const json& pair : listAt(stored, "allowed")) {
      if (pair.is_array() && pair.size() == 2 && pair[0].is_string() && pair[1].is_string())
        m_plans.allowed.insert({pair[0].get<std::string>(), pair[1].get<std::string>()});
    }
    const auto missing = stored.find("missing_as");
    if (missing != stored.end() && missing->is_object() && missing->size() <= CellPlans::kMost) {
      for (const auto& [part, by] : missing->items()) {
        if (by.is_string()) m_plans.missingAs[part] = by.get<std::string>();
      }
    }
    m_plans.workFrame = knownFrame(stored, "work_frame").value_or(std::string());
    m_plans.arm = stringAt(stored, "arm");
    m_plans.tool = toolFrom(stored, "tool");
    const auto tools = stored.find("other_tools");
    if (tools != stored.end() && tools->is_object() && tools->size() <= CellPlans::kMost) {
      for (const auto& [arm, pose] : tools->items()) m_plans.otherTools[arm] = toolFrom(*tools, arm.c_str());
    }
    const auto clearance = stored.find("clearance_mm");
    if (clearance != stored.end() && clearance->is_number())
      m_plans.clearance = std::clamp(clearance->get<double>(), 0.0, 1e4);
    readRates(stored);
    return std::move(m_plans);
  }

 private:
  // Sets rates that are missing, or beyond what can be set, to those of a new cell.
  void readRates(const json& stored) {
    const auto rates = stored.find("rates");
    if (rates == stored.end() || !rates->is_object()) return;
    for (const RateField& field : rateFields()) {
      const auto value = rates->find(field.key);
      if (value == rates->end() || !value->is_number()) continue;
      const double number = value->get<double>();
      if (number >= field.least && number <= field.largest) m_plans.rates.*field.value = number;
    }
  }

  // No more than a cell can hold; that others are left out is noted.
  std::span<const json> listAt(const json& object, const char* key, std::size_t most = CellPlans::kMost) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_array()) return {};
    const std::span<const json> all = found->get_ref<const json::array_t&>();
    if (all.size() <= most) return all;
    note({ErrorCode::FileTooLarge, {key, std::to_string(all.size()), std::to_string(most)}, {}, {}});
    return all.first(most);
  }

  Pose toolFrom(const json& object, const char* key) {
    const std::vector<double> numbers = numbersAt(object, key, 12);
    return numbers.size() == 12 ? poseFrom(numbers, "tool").value_or(Pose::Identity()) : Pose::Identity();
  }

  void note(Error error) {
    error.subject = {};
    m_damage.push_back(std::move(error));
  }

  void readConfigurations(std::span<const json> list) {
    for (const json& entry : list) {
      const std::string name = stringAt(entry, "name", "configuration");
      const auto stored = entry.is_object() ? entry.find("joints") : entry.end();
      if (stored == entry.end()) {
        note({ErrorCode::ElementMalformed, {"configurations", "its joints are missing"}, {}, {}});
        continue;
      }
      Result<JointValues> joints = jointsFrom(*stored, m_robot, m_others);
      if (!joints) {
        note(joints.error());
        continue;
      }
      m_plans.configurations.push_back({m_waypointNames.take(name), std::move(joints).value(), stringAt(entry, "arm")});
    }
  }

  void readOnePath(const json& entry) {
    Result<RobotPath> path = pathFrom(entry, m_robot, m_others);
    if (!path) return note(path.error());
    path->name = m_pathNames.take(path->name.empty() ? "path" : path->name);
    m_plans.paths.push_back(std::move(path).value());
  }

  void readFrame(const json& entry) {
    const auto pose = poseIn(entry, "frames");
    if (!pose) return;
    const std::uint32_t body = bodyIn(entry);
    const std::string link = body == 0 ? stringAt(entry, "link") : std::string();
    const std::string name = stringAt(entry, "name");
    m_plans.frames.push_back({m_frameNames.take(name.empty() ? "frame" : name), *pose, body, link});
  }

  void readTarget(const json& entry) {
    const auto pose = poseIn(entry, "targets");
    const auto frame = pose ? knownFrame(entry, "frame") : std::nullopt;
    if (!frame) return;
    const std::uint32_t body = frame->empty() ? bodyIn(entry) : 0;
    m_plans.targets.push_back({m_waypointNames.take(stringAt(entry, "name", "target")), *pose, body, *frame});
  }

  // The name of a frame of the cell; empty: none is named; none: it has no such frame, which is noted.
  std::optional<std::string> knownFrame(const json& entry, const char* key) {
    std::string name = stringAt(entry, key);
    if (name.empty() || m_plans.frame(name)) return name;
    note({ErrorCode::ReferenceMissing, {"the frame", std::move(name)}, {}, {}});
    return std::nullopt;
  }

  static std::uint32_t bodyIn(const json& entry) {
    const auto body = entry.find("body");
    return body != entry.end() && body->is_number_unsigned() ? body->get<std::uint32_t>() : 0;
  }

  std::optional<Pose> poseIn(const json& entry, const char* element) {
    const std::vector<double> numbers = numbersAt(entry, "pose", 12);
    if (numbers.size() == 12) return poseFrom(numbers, element);
    note({ErrorCode::ElementMalformed, {element, "its pose cannot be used"}, {}, {}});
    return std::nullopt;
  }

  // A pose that was written in few digits.
  std::optional<Pose> poseFrom(const std::vector<double>& numbers, const char* element) {
    Pose pose = Pose::Identity();
    for (Eigen::Index i = 0; i < 12; ++i) pose.matrix()(i / 4, i % 4) = numbers[static_cast<std::size_t>(i)];
    const auto rigid = isRigid(pose) ? std::optional(pose) : nearestRigid(pose);
    if (!rigid) note({ErrorCode::ElementMalformed, {element, "its pose cannot be used"}, {}, {}});
    return rigid;
  }

  const RobotModel& m_robot;
  const JointValues& m_others;
  std::vector<Error>& m_damage;
  CellPlans m_plans;
  FreeNames m_waypointNames, m_pathNames, m_frameNames;
};

}  // namespace

void writePlans(const CellPlans& plans, const RobotModel& robot, Container& container) {
  if (plans == CellPlans()) return;
  json stored = {{"clearance_mm", plans.clearance}, {"tool", numbersOfPose(plans.tool)},
                 {"configurations", json::array()}, {"targets", json::array()},
                 {"paths", json::array()},          {"allowed", json::array()}};
  if (!plans.arm.empty()) stored["arm"] = plans.arm;
  for (const auto& [arm, tool] : plans.otherTools) stored["other_tools"][arm] = numbersOfPose(tool);
  for (const NamedConfiguration& each : plans.configurations) {
    stored["configurations"].push_back({{"name", each.name}, {"joints", toJson(robot, each.joints)}});
    if (!each.arm.empty()) stored["configurations"].back()["arm"] = each.arm;
  }
  for (const NamedTarget& each : plans.targets) {
    stored["targets"].push_back({{"name", each.name}, {"pose", numbersOfPose(each.pose)}, {"body", each.body}});
    if (!each.frame.empty()) stored["targets"].back()["frame"] = each.frame;
  }
  for (const NamedFrame& each : plans.frames) {
    json frame = {{"name", each.name}, {"pose", numbersOfPose(each.pose)}};
    if (each.body != 0) frame["body"] = each.body;
    if (!each.link.empty()) frame["link"] = each.link;
    stored["frames"].push_back(std::move(frame));
  }
  if (!plans.workFrame.empty()) stored["work_frame"] = plans.workFrame;
  for (const RobotPath& path : plans.paths) stored["paths"].push_back(toJson(robot, path));
  for (const auto& [first, second] : plans.allowed) stored["allowed"].push_back({first, second});
  if (!plans.missingAs.empty()) stored["missing_as"] = plans.missingAs;
  for (const RateField& field : rateFields()) {
    if (plans.rates.*field.value != AssumedRates().*field.value) stored["rates"][field.key] = plans.rates.*field.value;
  }
  container.blobs[kPlans] = stored.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::shared_ptr<const CellPlans> readPlans(const Container& container, const RobotModel& robot,
                                           const JointValues& others, std::vector<Error>& damage) {
  const auto bytes = container.blobs.find(kPlans);
  if (bytes == container.blobs.end()) return std::make_shared<const CellPlans>();
  const Result<json> stored = parseJson(bytes->second, "plans");
  if (!stored || !stored->is_object()) {
    damage.push_back(stored ? Error{ErrorCode::ElementMalformed, {"plans", "an object was expected"}, {}, {}}
                            : stored.error());
    return std::make_shared<const CellPlans>();
  }
  return std::make_shared<const CellPlans>(PlansReading(robot, others, damage).read(*stored));
}

}  // namespace handwheel
