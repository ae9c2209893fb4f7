// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/PlanOperation.h"

#include "base/NumberText.h"
#include "base/ShownDistance.h"
#include "document/cell/CellErrors.h"
#include "document/cell/CellFrames.h"
#include "document/cell/CellReach.h"
#include "document/cell/path/OutdatedReasons.h"
#include "planning/PlanningFidelity.h"
#include "planning/ToolTrack.h"
#include "planning/planners/Planners.h"
#include "robot/program/PathFile.h"

#include <QtGlobal>
#include <algorithm>
#include <chrono>

namespace handwheel {

namespace {

Parameter waypointParameter(const char* id, const char* word, std::string meaning) {
  return {.property = {.id = id, .group = {}, .label = {}, .value = ""},
          .meaning = std::move(meaning),
          .word = word,
          .hasDefault = false};
}

Parameter plannerParameter() {
  Parameter parameter = {
      .property = {.id = "planner", .group = {}, .label = QT_TRANSLATE_NOOP("Property", "Planner"), .value = 0.0},
      .meaning = "Planner used where the straight path is blocked",
      .word = "PLANNER"};
  for (const PlannerName& planner : planners()) {
    parameter.property.choices.emplace_back(planner.title);
    parameter.words.emplace_back(planner.id);
  }
  return parameter;
}

// The words between these separators; empty ones are left out.
std::vector<std::string> wordsOf(const std::string& text, std::string_view separators) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; (begin = text.find_first_not_of(separators, begin)) != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return words;
}

std::optional<ArmValues> numbersOf(const std::string& text, Eigen::Index count) {
  const std::vector<std::string> words = wordsOf(text, " ,\t");
  if (static_cast<Eigen::Index>(words.size()) != count) return std::nullopt;
  ArmValues values(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    ErrorCode why{};
    if (!parseDecimal(words[static_cast<std::size_t>(i)], values[i], why) || !std::isfinite(values[i]))
      return std::nullopt;
  }
  return values;
}

std::shared_ptr<const std::array<JointValues, 2>> planEnds(const JointValues& from, const JointValues& to) {
  return std::make_shared<const std::array<JointValues, 2>>(std::array<JointValues, 2>{from, to});
}

// Brings a waypoint to a target, by the nearest free solution.
Status bringTo(const NamedTarget& target, const CellScene& scene, const CellPlacement& cell, Waypoint& waypoint) {
  const Result<Pose> pose = poseOfTarget(target, cell);
  if (!pose) return pose.error();
  const Result<ArmValues> values = nearestFree(scene, cell.plans, *pose, scene.planned(waypoint.joints));
  if (!values) return values.error();
  waypoint.joints = scene.whole(*values);
  const auto inTool = targetInTool(*scene.robot, cell, cell.plans.arm, waypoint.joints, target.name);
  waypoint.target.reset();
  if (inTool) waypoint.target = WaypointTarget{target.name, *inTool};
  return Done{};
}

// Brings a waypoint of a program to where its frame takes it, if that has moved for the tool.
Status bringWithFrame(const CellScene& scene, const CellPlacement& cell, Waypoint& waypoint) {
  if (!waypoint.frame) return Done{};
  const auto now = frameInTool(*scene.robot, cell, cell.plans.arm, waypoint.joints, waypoint.frame->name);
  const Result<Pose> frame = poseOfFrame(waypoint.frame->name, cell);
  if (!now || !frame || isSamePose(*now, waypoint.frame->inTool)) return Done{};
  const Pose tool = *frame * waypoint.frame->inTool.inverse(Eigen::Isometry);
  const Result<JointValues> joints = jointsReaching(*scene.robot, cell.plans, tool, waypoint.joints);
  if (!joints) return joints.error();
  waypoint.joints = *joints;
  const auto inTool = frameInTool(*scene.robot, cell, cell.plans.arm, waypoint.joints, waypoint.frame->name);
  if (inTool) waypoint.frame->inTool = *inTool;
  return Done{};
}

// Returns the waypoints at the present poses of their targets and frames, if the tool is no longer there, and at the
// present values of their configurations. If one of these is missing the waypoint does not change.
Result<std::vector<Waypoint>> atTargets(std::span<const Waypoint> waypoints, const CellScene& scene,
                                        const CellPlans& plans) {
  const CellPlacement cell{plans, scene.bodies, scene.robot->model, scene.others};
  std::vector<Waypoint> all(waypoints.begin(), waypoints.end());
  for (Waypoint& waypoint : all) {
    if (const NamedConfiguration* const changed = changedConfiguration(*scene.robot, plans, plans.arm, waypoint))
      waypoint.joints = withJointsOf(*scene.robot, scene.armNumber, waypoint.joints, changed->joints);
    const NamedTarget* const target = waypoint.target ? plans.target(waypoint.target->name) : nullptr;
    const auto inTool =
        target ? targetInTool(*scene.robot, cell, plans.arm, waypoint.joints, target->name) : std::nullopt;
    if (inTool && !isSamePose(*inTool, waypoint.target->inTool)) {
      if (const Status brought = bringTo(*target, scene, cell, waypoint); !brought) return brought.error();
    }
    if (const Status brought = bringWithFrame(scene, cell, waypoint); !brought) return brought.error();
  }
  return all;
}

// Divides motions in which a joint without limits turns by more than half a turn, which the shortest turn would not be.
JointPath withShortTurns(const RobotScene& scene, const JointPath& leg) {
  JointPath all{leg.front()};
  for (std::size_t i = 1; i < leg.size(); ++i) {
    const bool isShort = byShortestTurn(scene, leg[i - 1], leg[i]) == leg[i];
    const double largest = isShort ? 0.0 : (leg[i] - leg[i - 1]).cwiseAbs().maxCoeff();
    const int parts = 1 + static_cast<int>(largest / 3.0);
    for (int k = 1; k < parts; ++k)
      all.emplace_back(leg[i - 1] + static_cast<double>(k) / parts * (leg[i] - leg[i - 1]));
    all.push_back(leg[i]);
  }
  return all;
}

// Plans between two waypoints of a path.
class LegPlanning {
 public:
  LegPlanning(const CellScene& scene, const CellPlans& plans, const RouteSettings& settings)
      : m_scene(scene), m_plans(plans), m_settings(settings) {
    m_settings.plan.roadmap = scene.roadmap.get();
  }

  std::uint64_t steps() const { return m_steps; }

  // Adds the waypoints of a leg after its beginning, if its motions were planned between its ends and are still proven
  // free.
  bool keep(std::span<const Waypoint> leg, RobotPath& path, const Progress& progress) {
    if (!leg.back().isPlannedFrom(leg.front())) return false;
    for (std::size_t i = 1; i < leg.size(); ++i) {
      if (leg[i].motion != ProgramMotion::Kind::Joint || !m_scene.areOwnUnplannedJointsAt(leg[i].joints)) return false;
      const ArmValues begin = m_scene.planned(leg[i - 1].joints),
                      end = byShortestTurn(m_scene.scene, begin, m_scene.planned(leg[i].joints));
      if (!m_scene.scene.isWithinLimits(begin) || !m_scene.scene.isWithinLimits(end)) return false;
      MotionCheck check(m_scene.scene, begin, end, m_settings.plan.check);
      const bool isFree = check.run(progress) == MotionCheck::State::Free;
      m_steps += check.steps();
      if (!isFree) return false;
    }
    for (Waypoint waypoint : leg.subspan(1)) {
      waypoint.speed = leg.back().speed;  // Its present speed: those between go as plan() lets them
      waypoint.blend = leg.back().blend;
      path.waypoints.push_back(std::move(waypoint));
    }
    return true;
  }

  // Adds the waypoints after `from`, up to `to`. names: of both, for errors.
  Status plan(const Waypoint& from, const Waypoint& to, const std::array<std::string, 2>& names, RobotPath& path,
              Progress progress) {
    const ArmValues begin = m_scene.planned(from.joints),
                    end = byShortestTurn(m_scene.scene, begin, m_scene.planned(to.joints));
    if (to.motion == ProgramMotion::Kind::Linear) return follow(begin, end, to, names[1], path, progress);
    const std::array<ArmValues, 2> ends{begin, end};
    const Route route = planRoute(m_scene.scene, ends, m_settings, progress);
    m_steps += route.steps;
    if (!route.isSolved()) return problemOf(route, begin, end, names);
    const JointPath leg = withShortTurns(m_scene.scene, route.legs.front());
    for (std::size_t i = 1; i + 1 < leg.size(); ++i) {
      Waypoint between{.joints = m_scene.whole(leg[i]), .isCritical = false, .speed = to.speed, .blend = to.blend};
      path.waypoints.push_back(std::move(between));
    }
    path.waypoints.push_back(to);
    path.waypoints.back().plannedBetween = planEnds(from.joints, to.joints);
    return Done{};
  }

 private:
  Status follow(const ArmValues& begin, const ArmValues& end, const Waypoint& to, const std::string& name,
                RobotPath& path, Progress progress) {
    const CheckedLine line =
        checkLine(m_scene.scene, m_scene.arm, m_plans.tool, begin, end, {}, m_settings.plan.check, progress);
    m_steps += line.steps;
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    if (line.reached < 1.0)
      return Error{CellError::LineUnreachable, {name, roundedText(100.0 * line.reached, 3)}, {}, {}};
    if (!line.isFree()) return metAt(CellError::LineCollides, CellError::LineTooNear, name, line.blocked);
    path.waypoints.push_back(to);
    path.waypoints.back().plannedBetween.reset();
    return Done{};
  }

  Error problemOf(const Route& route, const ArmValues& begin, const ArmValues& end,
                  const std::array<std::string, 2>& names) const {
    switch (route.outcome) {
      case PlanResult::Outcome::StartBlocked:
        return metAt(CellError::WaypointCollides, CellError::WaypointTooNear, names[0], route.blocked);
      case PlanResult::Outcome::GoalBlocked:
        return metAt(CellError::WaypointCollides, CellError::WaypointTooNear, names[1], route.blocked);
      case PlanResult::Outcome::OutOfLimits: {
        const bool isBegin = !m_scene.scene.isWithinLimits(begin);
        return {CellError::WaypointBeyondLimits, {names[isBegin ? 0 : 1], jointBeyond(isBegin ? begin : end)}, {}, {}};
      }
      case PlanResult::Outcome::Cancelled:
        return {ErrorCode::Cancelled, {}, {}, {}};
      case PlanResult::Outcome::Solved:
      case PlanResult::Outcome::TimeOut:
        break;
    }
    return {CellError::RouteNotFound, {names[0], names[1], shownText(m_settings.plan.seconds)}, {}, {}};
  }

  // Returns the error of an obstacle at a waypoint: a collision, or only too close.
  Error metAt(const ErrorDescription& meeting, const ErrorDescription& near, const std::string& waypoint,
              const RobotScene::Nearest& blocked) const {
    const auto [link, other] = m_scene.namesOf(blocked);
    if (!(blocked.distance > 0.0)) return {meeting, {waypoint, link, other}, {}, {}};
    return {near, {waypoint, link, other, shownText(shownDistance(blocked.distance))}, {}, {}};
  }

  std::string jointBeyond(const ArmValues& values) const {
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      if (!m_scene.scene.joint(i).isWithin(values[i]))
        return m_scene.robot->model.jointOfDof(m_scene.dofs[static_cast<std::size_t>(i)]).name;
    }
    return m_scene.nameOfCoupled();
  }

  const CellScene& m_scene;
  const CellPlans& m_plans;
  RouteSettings m_settings;
  std::uint64_t m_steps = 0;
};

}  // namespace

std::vector<Parameter> planningParameters() {
  const FidelitySetting resolution = planResolutionSetting();
  const auto length = [](const char* id, const char* label, double value, double least, double largest) {
    return Property{.id = id,
                    .group = {},
                    .label = label,
                    .value = value,
                    .quantity = Quantity::Length,
                    .least = least,
                    .largest = largest};
  };
  const auto number = [](const char* id, const char* label, double value, double least, double largest) {
    return Property{.id = id, .group = {}, .label = label, .value = value, .least = least, .largest = largest};
  };
  return {plannerParameter(),
          {.property = length("clearance", QT_TRANSLATE_NOOP("Property", "Clearance"), 0.0, 0.0, 1e4),
           .meaning = "Clearance from all obstacles; default: that of the cell",
           .word = "MM",
           .hasDefault = false},
          {.property = length("resolution", QT_TRANSLATE_NOOP("Property", "Resolution of the proof"),
                              resolution.standard, resolution.least, resolution.largest),
           .meaning = "Resolution of the check: what exceeds the clearance by less counts as a collision",
           .word = "MM"},
          {.property = number("time", QT_TRANSLATE_NOOP("Property", "Time limit (s)"), 10.0, 0.001, 3600.0),
           .meaning = "Time after which a leg is given up, in seconds",
           .word = "S"},
          {.property = number("shortcuts", QT_TRANSLATE_NOOP("Property", "Shortcuts"), planShortcutsSetting().standard,
                              0.0, 1e5),
           .meaning = "Attempts to make each leg shorter",
           .word = "N",
           .isWhole = true},
          {.property = number("seed", "", 1.0, 0.0, 1e9),
           .meaning = "Seed of the random numbers",
           .word = "N",
           .isWhole = true}};
}

void setFidelity(OperationValues& values, const FidelityValues& fidelity) {
  values.setValid("resolution", fidelity.of(planResolutionSetting()));
  values.setValid("shortcuts", fidelity.of(planShortcutsSetting()));
}

PathCheckSettings checkSettingsOf(const OperationValues& values, const CellPlans& plans, const RobotPath& path) {
  PathCheckSettings settings{.clearance = values.given("clearance").value_or(plans.clearanceOf(path))};
  if (values.operation().find("resolution"))
    settings.resolution = std::min(settings.resolution, values.number("resolution"));
  return settings;
}

const Operation& planOperation() {
  static const Operation kOperation = [] {
    Operation made = {
        .id = "plan",
        .title = QT_TRANSLATE_NOOP("Tool", "Plan path"),
        .meaning = "Plans a path of the robot that is proven free of collisions",
        .parameters = {
            waypointParameter("from", "PLACE", "Start: a configuration, a target, 'here', or joint values (rad, mm)"),
            waypointParameter("to", "PLACE", "Goal, given like the start"),
            waypointParameter("via", "PLACE,...",
                              "Critical configurations or targets on the way; joint values: separated by ';'"),
            waypointParameter("name", "NAME", "The name of the path in the cell")}};
    for (Parameter& parameter : planningParameters()) made.parameters.push_back(std::move(parameter));
    return made;
  }();
  return kOperation;
}

std::string nameOfWaypoint(const Waypoint& waypoint, std::size_t number) {
  return waypoint.name.empty() ? "place " + std::to_string(number + 1) : waypoint.name;
}

Result<Waypoint> waypointCalled(const CellScene& scene, const RobotCellSnapshot& cell, const std::string& text,
                                const JointValues& near) {
  if (const NamedConfiguration* configuration = cell.plans->configuration(text)) {
    if (armNumber(*scene.robot, configuration->arm) != scene.armNumber)
      return Error{CellError::OfOtherArm, {configuration->name, configuration->arm}, {}, {}};
    return Waypoint{.joints = withJointsOf(*scene.robot, scene.armNumber, cell.joints, configuration->joints),
                    .name = configuration->name,
                    .configuration = configuration->name};
  }
  if (const NamedTarget* target = cell.plans->target(text)) {
    Waypoint waypoint{.joints = near, .name = target->name};
    const Status brought =
        bringTo(*target, scene, {*cell.plans, cell.bodies, scene.robot->model, cell.joints}, waypoint);
    return brought ? Result<Waypoint>(std::move(waypoint)) : brought.error();
  }
  const bool isHere = text == "here";
  const auto numbers = isHere ? std::nullopt : numbersOf(text, scene.scene.size());
  if (!isHere && !numbers) return Error{CellError::WaypointMissing, {text}, {}, {}};
  Result<JointValues> within = valuesWithinLimits(scene.robot->model, isHere ? cell.joints : scene.whole(*numbers));
  if (!within) return within.error();
  return Waypoint{.joints = std::move(within).value()};
}

Result<std::vector<Waypoint>> waypointsOf(const OperationValues& values, const CellScene& scene,
                                          const RobotCellSnapshot& cell) {
  std::vector<std::string> texts{values.text("from")};
  if (values.isSet("via")) {
    const std::string via = values.text("via");
    const bool isOne = cell.plans->configuration(via) || cell.plans->target(via) || numbersOf(via, scene.scene.size());
    const bool isMany = !isOne && via.find(';') != via.npos;
    for (std::string& word : isOne ? std::vector<std::string>{via} : wordsOf(via, isMany ? ";" : ","))
      texts.push_back(std::move(word));
  }
  texts.push_back(values.text("to"));
  std::vector<Waypoint> waypoints;
  for (const std::string& text : texts) {
    const JointValues& near = waypoints.empty() ? cell.joints : waypoints.back().joints;
    Result<Waypoint> waypoint = waypointCalled(scene, cell, text, near);
    if (!waypoint) return waypoint.error();
    waypoints.push_back(std::move(waypoint).value());
  }
  return waypoints;
}

RouteSettings routeSettingsOf(const OperationValues& values, const CellPlans& plans) {
  RouteSettings settings;
  settings.planner = planners()[values.whole("planner")].id;
  settings.plan.check.clearance = values.given("clearance").value_or(plans.clearance);
  settings.plan.check.resolution = values.number("resolution");
  settings.plan.seconds = values.number("time");
  settings.plan.seed = values.whole("seed");
  settings.shortcuts = static_cast<int>(values.whole("shortcuts"));
  return settings;
}

Result<PlannedPath> plannedThrough(const CellScene& scene, const CellPlans& plans, std::span<const Waypoint> given,
                                   const RouteSettings& settings, Progress progress) {
  const auto begin = std::chrono::steady_clock::now();
  const Result<std::vector<Waypoint>> at = atTargets(given, scene, plans);
  if (!at) return at.error();
  const std::span<const Waypoint> waypoints = *at;
  std::vector<const Waypoint*> kept;
  for (const Waypoint& waypoint : waypoints) {
    const bool isEnd = &waypoint == &waypoints.front() || &waypoint == &waypoints.back();
    if (waypoint.isCritical || isEnd || !waypoint.lines.empty()) kept.push_back(&waypoint);
  }
  PlannedPath planned;
  // Other robots are where they stand now; whether a leg can be kept is judged with them there.
  const auto present = [&](const JointValues& joints) {
    return withJointsOf(*scene.robot, scene.armNumber, scene.others, joints);
  };
  const auto standing = [&](Waypoint waypoint) {
    waypoint.joints = present(waypoint.joints);
    if (waypoint.plannedBetween && (*waypoint.plannedBetween)[0].size() == waypoint.joints.size())
      waypoint.plannedBetween =
          planEnds(present((*waypoint.plannedBetween)[0]), present((*waypoint.plannedBetween)[1]));
    return waypoint;
  };
  if (kept.size() < 2) return Error{CellError::PathTooShort, {planned.path.name}, {}, {}};
  const auto named = [&](const Waypoint& waypoint) {
    return nameOfWaypoint(waypoint, static_cast<std::size_t>(&waypoint - waypoints.data()));
  };
  LegPlanning legs(scene, plans, settings);
  planned.path.arm = plans.arm;
  planned.path.clearance = plans.ownClearance(settings.plan.check.clearance);
  planned.path.waypoints.push_back(standing(*kept.front()));
  const double share = 1.0 / static_cast<double>(kept.size() - 1);
  for (std::size_t i = 1; i < kept.size(); ++i) {
    const std::array<std::string, 2> names{named(*kept[i - 1]), named(*kept[i])};
    if (!scene.areOwnUnplannedJointsAt(kept[i]->joints)) return Error{CellError::OthersMoved, {names[1]}, {}, {}};
    const double done = share * static_cast<double>(i - 1);
    const Progress part = progress.part(done, done + share);
    std::vector<Waypoint> leg;
    for (const Waypoint& waypoint : std::span(kept[i - 1], kept[i] + 1)) leg.push_back(standing(waypoint));
    if (legs.keep(leg, planned.path, part)) {
      ++planned.keptLegs;
    } else if (const Status made = legs.plan(leg.front(), leg.back(), names, planned.path, part); !made) {
      return made.error();
    }
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  }
  planned.steps = legs.steps();
  planned.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return planned;
}

}  // namespace handwheel
