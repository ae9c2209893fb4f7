// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/OptimisePathOperation.h"

#include "planning/ToolTrack.h"
#include "planning/VisitOrder.h"
#include "robot/arm/ClosedFormIk.h"
#include "tools/cell/path/PathBlends.h"

#include <QtGlobal>
#include <algorithm>
#include <chrono>

namespace handwheel {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostNodes =
    1500;                             // Choices of all stops together: their costs are a table of that size, squared
constexpr double kSameValues = 1e-6;  // rad, mm

// Waypoints that follow each other by straight lines, with the configurations to choose from.
struct Stop {
  std::vector<std::size_t> waypoints;  // by their numbers among the critical ones
  struct Choice {
    std::vector<ArmValues> values;  // Values at each waypoint
    double seconds = 0.0;           // Duration of its lines
  };
  std::vector<Choice> choices;
};

class OptimisePathOperation {
 public:
  OptimisePathOperation(const CellScene& scene, const CellPlans& plans, const OptimisationSettings& settings)
      : m_scene(scene), m_plans(plans), m_settings(settings), m_ik(ClosedFormIk::of(scene.arm)) {
    m_settings.route.plan.roadmap = scene.roadmap.get();
  }

  // Returns the critical waypoints in their new order, with their new joint values; unchanged if no path leads through
  // them.
  std::vector<Waypoint> optimised(const std::vector<Waypoint>& waypoints, OptimisedPath& result, Progress progress) {
    m_waypoints = &waypoints;
    findStops(progress.part(0.0, 0.2));
    std::vector<std::size_t> choices;
    for (const Stop& stop : m_stops) choices.push_back(stop.choices.size());
    const VisitCosts costs{[this](const Visit& from, const Visit& to) { return least(from, to); },
                           [this](const Visit& from, const Visit& to, Progress own) { return exact(from, to, own); }};
    const auto found =
        m_stops.size() < 2
            ? std::nullopt
            : cheapestOrder(choices, costs, {.mayReorder = m_settings.mayReorder, .seconds = m_settings.seconds},
                            progress.part(0.2, 1.0));
    std::vector<Waypoint> ordered;
    for (std::size_t i = 0; i < m_stops.size(); ++i) {
      const Visit visit = found ? found->visits[i] : Visit{i, 0};
      const Stop& stop = m_stops[visit.stop];
      for (std::size_t k = 0; k < stop.waypoints.size(); ++k) {
        Waypoint waypoint = waypoints[stop.waypoints[k]];
        if (visit.alternative > 0) {
          waypoint.joints = m_scene.whole(stop.choices[visit.alternative].values[k]);
          waypoint.configuration.clear();
          ++result.reconfigured;
        }
        result.order.push_back(stop.waypoints[k]);
        ordered.push_back(std::move(waypoint));
      }
    }
    return ordered;
  }

 private:
  ArmValues valuesOf(std::size_t waypoint) const { return m_scene.planned((*m_waypoints)[waypoint].joints); }

  // The first choice of each stop is its present one.
  void findStops(Progress progress) {
    for (std::size_t i = 0; i < m_waypoints->size(); ++i) {
      if (i == 0 || (*m_waypoints)[i].motion == ProgramMotion::Kind::Joint) m_stops.emplace_back();
      m_stops.back().waypoints.push_back(i);
    }
    const std::size_t most = std::max<std::size_t>(1, kMostNodes / m_stops.size());
    for (std::size_t s = 0; s < m_stops.size() && !progress.cancelled(); ++s) {
      Stop& stop = m_stops[s];
      Stop::Choice own;
      for (const std::size_t waypoint : stop.waypoints) own.values.push_back(valuesOf(waypoint));
      const bool isEnd = s == 0 || s + 1 == m_stops.size();
      if (stop.waypoints.size() > 1) own.seconds = secondsOfLines(stop, own);
      stop.choices.push_back(std::move(own));
      if (!isEnd && m_settings.mayReconfigure) addChoices(stop, most, progress);
      progress.set(static_cast<double>(s + 1) / static_cast<double>(m_stops.size()));
    }
  }

  // The values with which the tool is at the same pose, free, those next to the present ones first.
  std::vector<ArmValues> alternatives(const ArmValues& present) const {
    std::vector<ArmValues> found;
    if (!m_ik) return found;
    IkSolutions solutions;
    m_ik->solve(m_scene.arm.tipPose(present), present, solutions);
    const ArmValues middle = m_scene.arm.middle();
    const auto isKnown = [&](const ArmValues& same) {
      const auto isSame = [&](const ArmValues& each) { return (each - same).cwiseAbs().maxCoeff() < kSameValues; };
      return isSame(present) || std::any_of(found.begin(), found.end(), isSame);
    };
    for (const ArmValues& reference : {present, middle}) {
      for (const IkSolutions::Solution& solution : solutions) {
        const auto within = withinLimits(m_scene.arm, solution.values, reference);
        if (within && !isKnown(*within) && isFreeAt(m_scene.scene, *within, m_settings.route.plan.check))
          found.push_back(*within);
      }
    }
    return found;
  }

  void addChoices(Stop& stop, std::size_t most, Progress progress) const {
    for (const ArmValues& first : alternatives(stop.choices.front().values.front())) {
      if (stop.choices.size() >= most || progress.cancelled()) return;
      Stop::Choice choice{{first}};
      for (std::size_t k = 1; k < stop.waypoints.size(); ++k) {
        const auto next = alongLine(choice.values.back(), stop.choices.front().values[k], progress);
        if (!next) break;
        choice.values.push_back(*next);
      }
      if (choice.values.size() < stop.waypoints.size()) continue;
      if (stop.waypoints.size() > 1) choice.seconds = secondsOfLines(stop, choice);
      stop.choices.push_back(std::move(choice));
    }
  }

  // Returns the end of a straight line from these values to the pose of others.
  std::optional<ArmValues> alongLine(const ArmValues& from, const ArmValues& present, Progress progress) const {
    std::vector<ArmValues> ends = alternatives(present);
    ends.push_back(present);
    std::sort(ends.begin(), ends.end(), [&](const ArmValues& a, const ArmValues& b) {
      return (a - from).squaredNorm() < (b - from).squaredNorm();
    });
    for (const ArmValues& end : ends) {
      const CheckedLine line =
          checkLine(m_scene.scene, m_scene.arm, m_plans.tool, from, end, {}, m_settings.route.plan.check, progress);
      if (line.isFree()) return end;
    }
    return std::nullopt;
  }

  double secondsOfLines(const Stop& stop, const Stop::Choice& choice) const {
    RobotPath lines;
    for (std::size_t k = 0; k < choice.values.size(); ++k) {
      lines.waypoints.push_back((*m_waypoints)[stop.waypoints[k]]);
      lines.waypoints.back().joints = m_scene.whole(choice.values[k]);
    }
    return timed(m_scene, m_plans, lines, resolved(m_scene, m_plans, lines), {}).duration();
  }

  double secondsOf(JointPath path, const Visit& to) const {
    const Stop& stop = m_stops[to.stop];
    const std::vector<MotionPace> paces(path.size(), {.speed = (*m_waypoints)[stop.waypoints.front()].speed});
    return TimedPath(m_scene.scene, std::move(path), {m_plans.rates}, paces).duration() +
           stop.choices[to.alternative].seconds;
  }

  // No motion is faster than the straight one: each begins and ends at rest, and no joint exceeds its speed.
  double least(const Visit& from, const Visit& to) const {
    return secondsOf({endOf(from), m_stops[to.stop].choices[to.alternative].values.front()}, to);
  }

  double exact(const Visit& from, const Visit& to, Progress progress) const {
    const std::array<ArmValues, 2> ends{endOf(from), m_stops[to.stop].choices[to.alternative].values.front()};
    const Route route = planRoute(m_scene.scene, ends, m_settings.route, progress);
    return route.isSolved() ? secondsOf(route.legs.front(), to) : kNever;
  }

  const ArmValues& endOf(const Visit& visit) const {
    return m_stops[visit.stop].choices[visit.alternative].values.back();
  }

  const CellScene& m_scene;
  const CellPlans& m_plans;
  OptimisationSettings m_settings;
  std::optional<ClosedFormIk> m_ik;
  const std::vector<Waypoint>* m_waypoints = nullptr;
  std::vector<Stop> m_stops;
};

}  // namespace

const Operation& optimisePathOperation() {
  static const Operation kOperation = [] {
    Operation made = {
        .id = "optimise-path",
        .title = QT_TRANSLATE_NOOP("Tool", "Optimise path"),
        .meaning = "Chooses the order and the configurations of the critical places of a path that take the least time",
        .parameters = {
            {.property = {.id = "keep-order", .group = {}, .label = {}, .value = false},
             .meaning = "Keep the order of the places"},
            {.property = {.id = "keep-configurations", .group = {}, .label = {}, .value = false},
             .meaning = "Keep the joint values at each place"},
            {.property = {.id = "search", .group = {}, .label = {}, .value = 30.0, .least = 0.001, .largest = 3600.0},
             .meaning = "Time limit of the search for a better order, in seconds",
             .word = "S"},
            {.property = {.id = "name", .group = {}, .label = {}, .value = ""},
             .meaning = "Name of the path in the cell; default: its present name",
             .word = "NAME",
             .hasDefault = false}}};
    for (Parameter& parameter : planningParameters()) made.parameters.push_back(std::move(parameter));
    return made;
  }();
  return kOperation;
}

OptimisationSettings optimisationSettingsOf(const OperationValues& values, const CellPlans& plans,
                                            const RobotPath& path) {
  RouteSettings route = routeSettingsOf(values, plans);
  route.plan.check.clearance = values.given("clearance").value_or(plans.clearanceOf(path));
  return {.route = std::move(route),
          .mayReorder = !values.flag("keep-order"),
          .mayReconfigure = !values.flag("keep-configurations"),
          .seconds = values.number("search")};
}

Result<OptimisedPath> optimisedPath(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                                    const OptimisationSettings& settings, Progress progress) {
  const auto begin = std::chrono::steady_clock::now();
  const PathCheckSettings check{
      .clearance = settings.route.plan.check.clearance,
      .resolution = std::min(PathCheckSettings().resolution, settings.route.plan.check.resolution)};
  const Result<CheckedPath> present = checkPath(scene, plans, path, check, progress.part(0.0, 0.1));
  if (!present) return present.error();
  std::vector<Waypoint> critical;
  for (const Waypoint& waypoint : path.waypoints) {
    const bool isEnd = &waypoint == &path.waypoints.front() || &waypoint == &path.waypoints.back();
    if (waypoint.isCritical || isEnd || !waypoint.lines.empty()) critical.push_back(waypoint);
  }
  OptimisedPath result;
  result.before = present->seconds;
  // Statements of a program keep their order.
  const auto hasStatement = [](const Waypoint& waypoint) {
    return std::ranges::any_of(waypoint.lines,
                               [](const ProgramLine& line) { return line.kind == ProgramLine::Kind::Statement; });
  };
  OptimisationSettings possible = settings;
  possible.mayReorder = settings.mayReorder && std::ranges::none_of(path.waypoints, hasStatement);
  const std::vector<Waypoint> waypoints =
      OptimisePathOperation(scene, plans, possible).optimised(critical, result, progress.part(0.1, 0.9));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  Result<PlannedPath> planned = plannedThrough(scene, plans, waypoints, settings.route, progress.part(0.9, 1.0));
  if (!planned) return planned.error();
  result.planned = std::move(planned).value();
  result.planned.path.name = path.name;
  result.planned.path.language = path.language;
  result.planned.path.head = path.head;
  // The path keeps its curve if it passes the same waypoints.
  if (result.reconfigured == 0 && std::is_sorted(result.order.begin(), result.order.end()))
    result.planned.path.process = path.process;
  const ResolvedPath resolvedPath = resolved(scene, plans, result.planned.path, progress.part(1.0, 1.0));
  const std::vector<double> blends =
      certifiedBlends(scene, plans, result.planned.path, resolvedPath, check.clearance, progress);
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  result.after = timed(scene, plans, result.planned.path, resolvedPath, blends).duration();
  constexpr double kQuicker = 1e-9;  // s
  result.isChanged = !present->isCertified() || result.after < result.before - kQuicker;
  if (!result.isChanged) {
    result.planned.path = path;
    result.after = result.before;
    result.reconfigured = 0;
    std::sort(result.order.begin(), result.order.end());
  }
  result.planned.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace handwheel
