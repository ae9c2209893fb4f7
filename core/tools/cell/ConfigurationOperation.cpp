// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/ConfigurationOperation.h"

#include "base/NumberText.h"
#include "document/cell/CellArms.h"
#include "document/cell/CellErrors.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyDisplay.h"
#include "document/scene/BodyErrors.h"
#include "robot/program/PathFile.h"
#include "tools/cell/ConfigurationPoses.h"
#include "tools/cell/path/PairNames.h"
#include "tools/scene/BodyOperation.h"

#include <QtGlobal>
#include <algorithm>
#include <numbers>

namespace handwheel {

namespace {

constexpr const char* kConfigurationVerbs[] = {"add",        "remove",        "go",        "remove-path",
                                               "add-target", "remove-target", "add-frame", "remove-frame"};

Parameter nameParameter(const char* id, std::string meaning, const char* word = "NAME") {
  return {.property = {.id = id, .group = {}, .label = {}, .value = ""},
          .meaning = std::move(meaning),
          .word = word,
          .hasDefault = false};
}

Parameter positionParameter() {
  return {.property = {.id = "at", .group = {}, .label = {}, .value = "", .least = -1e7, .largest = 1e7},
          .meaning =
              "Place of the tool's centre point, in mm from the base; the robot moves there, or --add-target "
              "or --add-frame stores it",
          .word = "X,Y,Z",
          .parts = {{"x"}, {"y"}, {"z"}},
          .hasDefault = false};
}

Parameter turnParameter() {
  return {.property = {.id = "turn",
                       .group = {},
                       .label = {},
                       .value = "",
                       .quantity = Quantity::Angle,
                       .least = -2.0 * std::numbers::pi,
                       .largest = 2.0 * std::numbers::pi},
          .meaning = "Rotation of the tool there about x, y and z in degrees; default: unchanged",
          .word = "A,B,C",
          .parts = {{"x"}, {"y"}, {"z"}},
          .hasDefault = false};
}

// Joint values under names: "joint_1=0.5,joint_2=-1", in rad and mm.
Result<JointValues> jointsFromText(const std::string& text, const RobotModel& robot, const JointValues& others) {
  JointValues joints = others;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const auto dof = std::find_if(robot.dofs.begin(), robot.dofs.end(),
                                  [&](std::uint32_t joint) { return robot.joints[joint].name == name; });
    ErrorCode why{};
    double value = 0.0;
    if (dof == robot.dofs.end()) return Error{ErrorCode::ReferenceMissing, {"joint", name, {}}, {}, {}};
    if (equals == word.npos || !parseDecimal(word.substr(equals + 1), value, why))
      return Error{ErrorCode::NumberMalformed, {word}, {}, {}};
    joints[dof - robot.dofs.begin()] = value;
  }
  return valuesWithinLimits(robot, std::move(joints));
}

// Two links, or a link and a body, with a comma between their names.
Result<PairNames> pairFrom(const std::string& text, const RobotCellSnapshot& cell) {
  const auto named = [&](const std::string& name) -> Result<std::string> {
    if (linkNamed(cell.robot->model, name) != kNone) return name;
    const Result<BodyPointer> body = bodyCalled(cell.bodies, name);
    return body ? Result<std::string>(partOfBody((*body)->id)) : body.error();
  };
  const std::size_t comma = std::min(text.find(','), text.size());
  Result<std::string> first = named(text.substr(0, comma));
  if (!first) return first.error();
  Result<std::string> second = named(text.substr(std::min(comma + 1, text.size())));
  if (!second) return second.error();
  return PairNames{std::move(first).value(), std::move(second).value()};
}

Status changePairs(const OperationValues& values, const RobotCellSnapshot& cell, CellPlans& plans) {
  for (const char* const id : {"allow", "forbid"}) {
    if (!values.isSet(id)) continue;
    const Result<PairNames> pair = pairFrom(values.text(id), cell);
    if (!pair) return pair.error();
    setAllowed(plans, *pair, id == std::string_view("allow"));
  }
  return Done{};
}

std::optional<Error> problemOfName(const std::string& name) {
  if (isBodyName(name)) return std::nullopt;
  return Error{BodyError::NameUnusable, {name, std::to_string(kLongestBodyName)}, {}, {}};
}

}  // namespace

const Operation& configurationOperation() {
  static const Operation kOperation = {
      .id = "configuration",
      .title = QT_TRANSLATE_NOOP("Tool", "Configuration"),
      .meaning = "Stores named joint values in a cell, moves the robot there, and sets clearance and tool of planning",
      .parameters = {
          nameParameter("add", "Stores the current joint values; a configuration of that name is replaced"),
          nameParameter("joints", "Joint values to store instead, in rad and mm; the other joints keep theirs",
                        "JOINT=VALUE,..."),
          nameParameter("go",
                        "Moves the robot to this configuration, or to this target in the nearest free configuration"),
          nameParameter("remove", "Removes this configuration"),
          nameParameter("remove-path", "Removes this path"),
          nameParameter("add-target",
                        "Stores the current pose of the tool as a target; a target of that name is replaced"),
          nameParameter("on", "The body that the new target or frame is on and moves with", "BODY"),
          nameParameter("in", "The frame that the new target belongs to and moves with", "FRAME"),
          nameParameter("remove-target", "Removes this target"),
          nameParameter("add-frame",
                        "Stores the current pose of the tool as a frame; one of that name is replaced, and its targets "
                        "move with it"),
          nameParameter("link", "The link of a robot that carries the new frame", "LINK"),
          nameParameter("remove-frame", "Removes this frame; its targets stay where they are"),
          positionParameter(),
          turnParameter(),
          {.property = {.id = "solution", .group = {}, .label = {}, .value = 1.0, .least = 1.0, .largest = 100.0},
           .meaning = "Number in the list of --solutions; default: the nearest free one",
           .word = "N",
           .isWhole = true,
           .hasDefault = false},
          {.property = {.id = "solutions", .group = {}, .label = {}, .value = false},
           .meaning = "Lists all configurations in which the arm brings its tool there, with numbers those within the "
                      "limits, and changes nothing"},
          {.property = {.id = "clearance",
                        .group = {},
                        .label = QT_TRANSLATE_NOOP("Property", "Clearance"),
                        .value = 0.0,
                        .quantity = Quantity::Length,
                        .least = 0.0,
                        .largest = 1e4},
           .meaning = "Clearance of paths that are planned from now on",
           .word = "MM",
           .hasDefault = false},
          nameParameter("allow", "Lets a link and a link or body touch from now on", "NAME,NAME"),
          nameParameter("forbid", "Lets these two touch no longer", "NAME,NAME"),
          {.property = {.id = "tool", .group = {}, .label = {}, .value = "", .least = -1e5, .largest = 1e5},
           .meaning = "The tool's centre point in the flange, mm",
           .word = "X,Y,Z",
           .parts = {{"x"}, {"y"}, {"z"}},
           .hasDefault = false}}};
  return kOperation;
}

std::string problemOfConfigurationValues(const OperationValues& values) {
  const auto isSet = [&](const char* id) { return values.isSet(id); };
  if (std::count_if(std::begin(kConfigurationVerbs), std::end(kConfigurationVerbs), isSet) > 1)
    return "only one of add, remove, go, remove-path, add-target, remove-target, add-frame and remove-frame can be "
           "done "
           "at a time";
  if (isSet("go") && (isSet("at") || isSet("turn"))) return "go moves to a stored place, at and turn to another one";
  const bool addsPose = isSet("add-target") || isSet("add-frame");
  if (isSet("on") && !addsPose) return "on needs add-target or add-frame";
  if (isSet("in") && !isSet("add-target")) return "in needs add-target";
  if (isSet("link") && !isSet("add-frame")) return "link needs add-frame";
  if (isSet("on") && (isSet("in") || isSet("link"))) return "only one of on, in and link can be given";
  if (isSet("solution") && addsPose) return "solution chooses joint values, which targets and frames have none of";
  for (const char* const id : {"allow", "forbid"}) {
    if (isSet(id) && values.text(id).find(',') == std::string::npos)
      return std::string(id) + " takes two names with a comma between them";
  }
  if (isSet("joints") && !isSet("add") && !isSet("go")) return "joints needs add or go";
  return {};
}

Result<ChangedCell> changedCell(const OperationValues& values, const RobotCellSnapshot& cell) {
  ChangedCell changed{*cell.plans, cell.joints};
  CellPlans& plans = changed.plans;
  JointValues stored = cell.joints;
  if (values.isSet("joints")) {
    Result<JointValues> joints = jointsFromText(values.text("joints"), cell.robot->model, cell.joints);
    if (!joints) return joints.error();
    stored = std::move(joints).value();
  }
  if (const Status targets = changeTargets(values, cell, plans); !targets) return targets.error();
  if (const Status frames = changeFrames(values, cell, plans); !frames) return frames.error();
  if (movesTool(values, *cell.plans)) {
    Result<JointValues> joints = jointsThere(values, cell);
    if (!joints) return joints.error();
    changed.joints = stored = std::move(joints).value();
  }
  const auto find = [&](const std::string& name) {
    return std::find_if(plans.configurations.begin(), plans.configurations.end(),
                        [&](const NamedConfiguration& each) { return each.name == name; });
  };
  if (values.isSet("add")) {
    const std::string name = values.text("add");
    if (const auto problem = problemOfName(name)) return *problem;
    if (plans.target(name)) return Error{CellError::WaypointNameTaken, {name}, {}, {}};
    const NamedConfiguration made{name, stored, plans.arm};
    if (const auto found = find(name); found != plans.configurations.end())
      *found = made;
    else
      plans.configurations.push_back(made);
  }
  for (const char* const verb : {"go", "remove"}) {
    const bool isToTarget = verb == std::string_view("go") && goesToTarget(values, *cell.plans);
    if (!values.isSet(verb) || isToTarget) continue;
    const auto found = find(values.text(verb));
    if (found == plans.configurations.end()) return Error{CellError::WaypointMissing, {values.text(verb)}, {}, {}};
    if (verb == std::string_view("go"))
      changed.joints = jointsSetBy(*cell.robot, found->arm, found->joints, cell.joints);
    else
      plans.configurations.erase(found);
  }
  if (values.isSet("remove-path")) {
    const std::string name = values.text("remove-path");
    if (!plans.path(name)) return Error{CellError::PathMissing, {name}, {}, {}};
    std::erase_if(plans.paths, [&](const RobotPath& path) { return path.name == name; });
  }
  if (const Status pairs = changePairs(values, cell, plans); !pairs) return pairs.error();
  if (const auto clearance = values.given("clearance")) plans.clearance = *clearance;
  if (values.isSet("tool")) {
    const std::vector<double> at = values.numbers("tool");
    plans.tool.translation() = Vec3(at[0], at[1], at[2]);
  }
  return changed;
}

Result<CellPlans> withSemantics(CellPlans plans, const RobotSemantics& semantics, const RobotCellSnapshot& cell) {
  const RobotModel& robot = cell.robot->model;
  const std::vector<std::uint32_t> owners = armsOfDofs(robot, cell.robot->arms);
  for (const auto& [a, b] : semantics.allowed) plans.allowed.insert({robot.links[a].name, robot.links[b].name});
  FreeNames names = plans.poseNames();
  for (const RobotSemantics::State& state : semantics.states) {
    JointValues joints = cell.joints;
    for (const auto& [dof, value] : state.values) joints[dof] = value;
    Result<JointValues> within = valuesWithinLimits(robot, std::move(joints));
    if (!within) return within.error();
    const std::uint32_t owner = state.values.empty() ? kNone : owners[state.values.begin()->first];
    const std::string arm = owner == kNone || cell.robot->arms.size() == 1 ? plans.arm : cell.robot->arms[owner].name;
    plans.configurations.push_back({names.take(state.name), std::move(within).value(), arm});
  }
  return plans;
}

}  // namespace handwheel
