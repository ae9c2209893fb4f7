// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/program/PathFile.h"

#include "base/JsonText.h"
#include "base/NumberText.h"
#include "base/Utf8.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using Json = nlohmann::json;

constexpr double kSlack = 1e-6;  // rad, mm: excess over a limit caused by printed digits

Error malformedPath(std::string element, const char* reason) {
  return {ErrorCode::ElementMalformed, {std::move(element), reason}, {}, {}};
}

std::uint32_t dofNamed(const RobotModel& robot, std::string_view name) {
  for (std::uint32_t dof = 0; dof < robot.dofs.size(); ++dof) {
    if (robot.jointOfDof(dof).name == name) return dof;
  }
  return kNone;
}

// Returns the degrees of freedom for the columns of waypoints. Errors: ReferenceMissing.
Result<std::vector<std::uint32_t>> columnsOf(const Json& json, const RobotModel& robot,
                                             std::vector<std::uint32_t> usual) {
  std::vector<std::uint32_t> columns;
  const auto joints = json.find("joints");
  if (joints == json.end() && !usual.empty()) return usual;
  if (joints == json.end()) {
    for (std::uint32_t dof = 0; dof < robot.dofs.size(); ++dof) columns.push_back(dof);
    return columns;
  }
  if (!joints->is_array()) return malformedPath("joints", "a list of names was expected");
  for (const Json& name : *joints) {
    const std::uint32_t dof = name.is_string() ? dofNamed(robot, name.get<std::string>()) : kNone;
    if (dof == kNone)
      return Error{ErrorCode::ReferenceMissing, {"joint", name.is_string() ? name.get<std::string>() : "", {}}, {}, {}};
    columns.push_back(dof);
  }
  return columns;
}

Result<JointValues> valuesFrom(const Json& row, const std::string& element, const std::vector<std::uint32_t>& columns,
                               const RobotModel& robot, const JointValues& others) {
  if (!row.is_array() || row.size() != columns.size())
    return malformedPath(element, "a number for each joint was expected");
  JointValues values = others;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!row[i].is_number()) return malformedPath(element, "a number for each joint was expected");
    values[columns[i]] = row[i].get<double>();
  }
  return valuesWithinLimits(robot, std::move(values));
}

double numberAt(const Json& json, const char* key, double otherwise, double least, double largest) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number()) return otherwise;
  const double value = found->get<double>();
  return std::isfinite(value) ? std::clamp(value, least, largest) : otherwise;
}

bool isAt(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

// Reads the format of numbersOfPose(); none if it is no rigid pose.
std::optional<Pose> poseAt(const Json& json, const char* key) {
  const std::vector<double> numbers = numbersAt(json, key, 12);
  if (numbers.size() != 12) return std::nullopt;
  Pose pose = Pose::Identity();
  for (Eigen::Index i = 0; i < 12; ++i) pose.matrix()(i / 4, i % 4) = numbers[static_cast<std::size_t>(i)];
  const Eigen::Matrix3d turn = pose.linear();
  constexpr double kSkew = 1e-6;
  const bool isTurn =
      (turn.transpose() * turn - Eigen::Matrix3d::Identity()).norm() < kSkew && turn.determinant() > 0.0;
  return isTurn ? std::optional(pose) : std::nullopt;
}

Json waypointTargetJson(const WaypointTarget& target) {
  return {{"name", target.name}, {"in_tool", numbersOfPose(target.inTool)}};
}

// Returns none if it cannot be used: the waypoint is valid without it.
std::optional<WaypointTarget> waypointTargetFrom(const Json& json) {
  const std::string name = json.is_object() ? stringAt(json, "name") : std::string();
  const auto inTool = name.empty() ? std::nullopt : poseAt(json, "in_tool");
  return inTool ? std::optional(WaypointTarget{name, *inTool}) : std::nullopt;
}

constexpr std::array kLineKinds = {"statement", "comment", "declaration", "axes"};  // in the order of ProgramLine::Kind

Json linesJson(const std::vector<ProgramLine>& lines) {
  Json list = Json::array();
  for (const ProgramLine& each : lines) {
    list.push_back(
        {{"text", each.text}, {"kind", kLineKinds[static_cast<std::size_t>(each.kind)]}, {"line", each.line}});
    if (each.mayGrip) list.back()["may_grip"] = true;
  }
  return list;
}

// Reads lines of a program. Errors: ElementMalformed, as a line that is left out may be one that grips.
Result<std::vector<ProgramLine>> linesFrom(const Json& json, const char* key, const std::string& element) {
  std::vector<ProgramLine> lines;
  const auto list = json.find(key);
  if (list == json.end()) return lines;
  const auto malformed = [&] { return malformedPath(element + "." + key, "a list of lines was expected"); };
  if (!list->is_array() || list->size() > ProgramLine::kMost) return malformed();
  for (const Json& each : *list) {
    if (!each.is_object()) return malformed();
    const auto kind = std::ranges::find(kLineKinds, stringAt(each, "kind", kLineKinds[0]));
    if (kind == kLineKinds.end()) return malformed();
    std::string text = stringAt(each, "text");
    std::ranges::replace_if(text, isControl, ' ');
    lines.push_back({static_cast<ProgramLine::Kind>(kind - kLineKinds.begin()), text, countAt(each, "line"),
                     isAt(each, "may_grip")});
  }
  return lines;
}

Result<Waypoint> waypointFrom(const Json& json, const std::string& element, const RobotModel& robot,
                              const JointValues& others) {
  if (!json.is_object()) return malformedPath(element, "an object was expected");
  Waypoint waypoint;
  const auto joints = json.find("joints");
  if (joints == json.end()) return malformedPath(element, "its joints are missing");
  Result<JointValues> values = jointsFrom(*joints, robot, others);
  if (!values) return values.error();
  waypoint.joints = std::move(values).value();
  waypoint.name = stringAt(json, "name");
  const auto critical = json.find("critical");
  if (critical != json.end() && critical->is_boolean()) waypoint.isCritical = critical->get<bool>();
  const std::string motion = stringAt(json, "motion", "joint");
  if (motion != "joint" && motion != "linear")
    return malformedPath(element + ".motion", "joint or linear was expected");
  const bool isLinear = motion == "linear";
  waypoint.motion = isLinear ? ProgramMotion::Kind::Linear : ProgramMotion::Kind::Joint;
  waypoint.speed = numberAt(json, "speed", isLinear ? 250.0 : 0.25, 1e-3, isLinear ? 1e5 : 1.0);
  waypoint.blend = numberAt(json, "blend_mm", 0.0, 0.0, 1e4);
  if (const auto target = json.find("target"); target != json.end()) waypoint.target = waypointTargetFrom(*target);
  if (const auto frame = json.find("frame"); frame != json.end()) waypoint.frame = waypointTargetFrom(*frame);
  waypoint.configuration = stringAt(json, "configuration");
  waypoint.corner = numberAt(json, "corner_percent", 0.0, 0.0, ProgramMotion::kLargestCorner);
  waypoint.seconds = numberAt(json, "seconds", 0.0, 0.0, ProgramMotion::kLongest);
  waypoint.keepsCarried = isAt(json, "keeps_carried");
  Result<std::vector<ProgramLine>> lines = linesFrom(json, "lines", element);
  if (!lines) return lines.error();
  waypoint.lines = std::move(lines).value();
  return waypoint;
}

Json processJson(const PathProcess& process) {
  Json values = Json::object();
  for (const auto& [name, value] : process.values)
    std::visit([&, &key = name](const auto& known) { values[key] = known; }, value);
  Json json = {{"values", values}, {"part", numbersOfPose(process.part)}, {"planned", numbersOfPose(process.planned)}};
  if (process.tool) json["tool"] = numbersOfPose(*process.tool);
  if (process.base) json["base"] = numbersOfPose(*process.base);
  return json;
}

// Returns none if it cannot be used: the path is valid without it.
std::optional<PathProcess> processFrom(const Json& json) {
  constexpr std::size_t kMostValues = 100;
  const auto values = json.is_object() ? json.find("values") : json.end();
  if (!json.is_object() || values == json.end() || !values->is_object() || values->size() > kMostValues)
    return std::nullopt;
  const auto part = poseAt(json, "part");
  if (!part) return std::nullopt;
  PathProcess process;
  process.part = *part;
  process.planned = poseAt(json, "planned").value_or(*part);
  process.tool = poseAt(json, "tool");
  process.base = poseAt(json, "base");
  for (const auto& [name, value] : values->items()) {
    if (value.is_boolean()) process.values[name] = value.get<bool>();
    if (value.is_number()) process.values[name] = value.get<double>();
    if (value.is_string()) process.values[name] = value.get<std::string>();
  }
  return process;
}

}  // namespace

Json numbersOfPose(const Pose& pose) {
  Json numbers = Json::array();
  for (Eigen::Index i = 0; i < 12; ++i) numbers.push_back(pose.matrix()(i / 4, i % 4));
  return numbers;
}

Result<JointValues> valuesWithinLimits(const RobotModel& robot, JointValues joints) {
  for (std::size_t dof = 0; dof < robot.dofs.size(); ++dof) {
    const Joint& joint = robot.jointOfDof(dof);
    double& value = joints[static_cast<Eigen::Index>(dof)];
    const double most = joint.kind == JointKind::Prismatic ? kFarthestTravel : kMostTurn;
    const bool isFree = joint.kind == JointKind::Continuous;
    const double least = isFree ? -most : std::max(joint.limits.lower, -most),
                 largest = isFree ? most : std::min(joint.limits.upper, most);
    if (!(value >= least - kSlack && value <= largest + kSlack) || least > largest) {
      return Error{
          ErrorCode::ValueOutOfRange, {joint.name, shownText(value), shownText(least), shownText(largest)}, {}, {}};
    }
    value = std::clamp(value, least, largest);
  }
  return joints;
}

Json toJson(const RobotModel& robot, const JointValues& joints) {
  Json json = Json::object();
  for (std::size_t dof = 0; dof < robot.dofs.size(); ++dof)
    json[robot.jointOfDof(dof).name] = joints[static_cast<Eigen::Index>(dof)];
  return json;
}

Result<JointValues> jointsFrom(const Json& json, const RobotModel& robot, const JointValues& others) {
  if (!json.is_object()) return malformedPath("joints", "an object was expected");
  JointValues values = others;
  for (const auto& [name, value] : json.items()) {
    const std::uint32_t dof = dofNamed(robot, name);
    if (dof == kNone) return Error{ErrorCode::ReferenceMissing, {"joint", name, {}}, {}, {}};
    if (!value.is_number()) return malformedPath("joints." + name, "a number was expected");
    values[dof] = value.get<double>();
  }
  return valuesWithinLimits(robot, std::move(values));
}

Json toJson(const RobotModel& robot, const RobotPath& path) {
  Json list = Json::array();
  const Waypoint* begin = nullptr;  // begin of the leg
  for (const Waypoint& waypoint : path.waypoints) {
    list.push_back({{"joints", toJson(robot, waypoint.joints)},
                    {"name", waypoint.name},
                    {"critical", waypoint.isCritical},
                    {"motion", waypoint.motion == ProgramMotion::Kind::Linear ? "linear" : "joint"},
                    {"speed", waypoint.speed},
                    {"blend_mm", waypoint.blend}});
    if (begin && waypoint.isPlannedFrom(*begin)) list.back()["planned"] = true;
    if (waypoint.target) list.back()["target"] = waypointTargetJson(*waypoint.target);
    if (waypoint.frame) list.back()["frame"] = waypointTargetJson(*waypoint.frame);
    if (!waypoint.configuration.empty()) list.back()["configuration"] = waypoint.configuration;
    if (waypoint.corner > 0.0) list.back()["corner_percent"] = waypoint.corner;
    if (waypoint.seconds > 0.0) list.back()["seconds"] = waypoint.seconds;
    if (!waypoint.lines.empty()) list.back()["lines"] = linesJson(waypoint.lines);
    if (waypoint.keepsCarried) list.back()["keeps_carried"] = true;
    if (!begin || waypoint.isCritical) begin = &waypoint;
  }
  Json json = {{"name", path.name}, {"places", list}};
  if (!path.arm.empty()) json["arm"] = path.arm;
  if (path.process) json["process"] = processJson(*path.process);
  if (path.clearance) json["clearance_mm"] = *path.clearance;
  if (!path.language.empty()) json["language"] = path.language;
  if (!path.head.empty()) json["head"] = linesJson(path.head);
  for (const auto& [name, base] : path.bases) json["bases"][name] = numbersOfPose(base);
  return json;
}

Result<RobotPath> pathFrom(const Json& json, const RobotModel& robot, const JointValues& others,
                           std::vector<std::uint32_t> usual) {
  if (!json.is_object()) return malformedPath("path", "an object was expected");
  RobotPath path;
  path.name = stringAt(json, "name", "path");
  path.arm = stringAt(json, "arm");
  path.language = stringAt(json, "language");
  Result<std::vector<ProgramLine>> head = linesFrom(json, "head", "path");
  if (!head) return head.error();
  path.head = std::move(head).value();
  if (const auto process = json.find("process"); process != json.end()) path.process = processFrom(*process);
  if (const auto kept = json.find("clearance_mm"); kept != json.end() && kept->is_number())
    path.clearance = numberAt(json, "clearance_mm", 0.0, 0.0, RobotPath::kLargestClearance);
  if (const auto bases = json.find("bases"); bases != json.end() && bases->is_object()) {
    for (const auto& [name, numbers] : bases->items()) {
      if (const auto base = poseAt(*bases, name.c_str())) path.bases[name] = *base;
    }
  }
  const auto detailed = json.find("places"), waypoints = json.find("waypoints");
  const bool isDetailed = detailed != json.end();
  const auto& list = isDetailed ? detailed : waypoints;
  const std::string element = isDetailed ? "places" : "waypoints";
  if (list == json.end() || !list->is_array()) return malformedPath(element, "a list was expected");
  if (list->size() > RobotPath::kMostWaypoints) {
    return Error{ErrorCode::FileTooLarge,
                 {"places", std::to_string(list->size()), std::to_string(RobotPath::kMostWaypoints)},
                 {},
                 {}};
  }
  Result<std::vector<std::uint32_t>> columns = std::vector<std::uint32_t>();
  if (!isDetailed) columns = columnsOf(json, robot, std::move(usual));
  if (!columns) return columns.error();
  std::size_t begin = 0;  // begin of the leg
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string at = element + "[" + std::to_string(i) + "]";
    if (isDetailed) {
      Result<Waypoint> waypoint = waypointFrom((*list)[i], at, robot, others);
      if (!waypoint) return waypoint.error();
      if (i > 0 && isAt((*list)[i], "planned"))
        waypoint->plannedBetween = std::make_shared<const std::array<JointValues, 2>>(
            std::array<JointValues, 2>{path.waypoints[begin].joints, waypoint->joints});
      if (waypoint->isCritical) begin = i;
      path.waypoints.push_back(std::move(waypoint).value());
      continue;
    }
    Result<JointValues> values = valuesFrom((*list)[i], at, *columns, robot, others);
    if (!values) return values.error();
    path.waypoints.push_back({.joints = std::move(values).value()});
  }
  return path;
}

Result<RobotPath> readPath(std::string_view text, const RobotModel& robot, const JointValues& others,
                           std::vector<std::uint32_t> columns) {
  const Result<Json> json = parseJson(text, "path");
  if (!json) return json.error();
  return pathFrom(*json, robot, others, std::move(columns));
}

}  // namespace handwheel
