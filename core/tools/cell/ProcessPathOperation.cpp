// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/ProcessPathOperation.h"

#include "base/NumberText.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/CellErrors.h"
#include "planning/DrawnCurve.h"
#include "planning/ToolTrack.h"
#include "scene/RigidPose.h"
#include "tools/scene/BodyOperation.h"

#include <QtGlobal>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

namespace handwheel {

namespace {

constexpr double kNormalAngle = 5.0 * std::numbers::pi / 180.0;  // Deviation of normals after simplification
constexpr int kFreeSpins = 24;                                   // turns of a tool that may be turned about its axis

Parameter textParameter(const char* id, const char* word, std::string meaning) {
  return {.property = {.id = id, .group = {}, .label = {}, .value = ""},
          .meaning = std::move(meaning),
          .word = word,
          .hasDefault = false};
}

Parameter numberParameter(const char* id, const char* label, const char* word, std::string meaning, double value,
                          double least, double largest, Quantity quantity) {
  return {.property = {.id = id,
                       .group = {},
                       .label = label,
                       .value = value,
                       .quantity = quantity,
                       .least = least,
                       .largest = largest},
          .meaning = std::move(meaning),
          .word = word};
}

Parameter flagParameter(const char* id, const char* label, std::string meaning) {
  return {.property = {.id = id, .group = {}, .label = label, .value = false}, .meaning = std::move(meaning)};
}

Error errorAt(const ErrorDescription& code, const FollowedTrack& track, std::span<const Pose> poses,
              std::vector<std::string> more = {}) {
  const Vec3 at = poses[track.failedAt].translation();
  std::vector<std::string> arguments{std::to_string(track.failedAt + 1), std::to_string(poses.size()),
                                     roundedText(at.x(), 6), roundedText(at.y(), 6), roundedText(at.z(), 6)};
  for (std::string& each : more) arguments.push_back(std::move(each));
  return {code, std::move(arguments), {}, {}};
}

Status checkFollowed(const FollowedTrack& track, std::span<const Pose> poses, const CellScene& scene) {
  switch (track.outcome) {
    case FollowedTrack::Outcome::Solved:
      return Done{};
    case FollowedTrack::Outcome::OutOfReach:
      return errorAt(CellError::TrackOutOfReach, track, poses);
    case FollowedTrack::Outcome::Blocked: {
      const auto [link, other] = scene.namesOf(track.blocked);
      return errorAt(CellError::TrackBlocked, track, poses, {link, other});
    }
    case FollowedTrack::Outcome::NoPath:
      return errorAt(CellError::TrackBroken, track, poses);
    case FollowedTrack::Outcome::Cancelled:
      break;
  }
  return Error{ErrorCode::Cancelled, {}, {}, {}};
}

// Returns the points of a drawn curve after its first. Error: NumberMalformed.
Result<std::vector<Vec3>> pointsThrough(const std::string& text) {
  std::vector<Vec3> points;
  std::vector<double> numbers;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::string_view word = rest.substr(0, rest.find_first_of(",; "));
    rest.remove_prefix(std::min(rest.size(), word.size() + 1));
    if (word.empty()) continue;
    double number = 0.0;
    ErrorCode why = ErrorCode::NumberMalformed;
    const bool isNumber = parseDecimal(word, number, why) && std::abs(number) <= kFarthestBody;
    if (!isNumber) return Error{ErrorCode::NumberMalformed, {std::string(word)}, {}, {}};
    numbers.push_back(number);
  }
  if (numbers.empty() || numbers.size() % 3 != 0) return Error{ErrorCode::NumberMalformed, {text}, {}, {}};
  for (std::size_t i = 0; i < numbers.size(); i += 3) points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  return points;
}

Result<SurfaceTrack> drawnTrack(std::shared_ptr<const PartSurface> surface, const Pose& toBody, const Vec3& near,
                                const std::string& through) {
  const Result<std::vector<Vec3>> points = pointsThrough(through);
  if (!points) return points.error();
  DrawnCurve curve(std::move(surface), near);
  for (std::size_t i = 0; i < points->size(); ++i) {
    if (!curve.goOnTo(toBody * (*points)[i]))
      return Error{CellError::DrawnCurveBroken, {std::to_string(i + 1), std::to_string(i + 2)}, {}, {}};
  }
  return curve.track();
}

void move(SurfaceTrack& track, const Pose& by) {
  for (TrackPoint& point : track.points) {
    point.position = by * point.position;
    point.direction = by.linear() * point.direction;
    point.normal = by.linear() * point.normal;
  }
}

PathProcess processOf(const OperationValues& values, PathProcess process) {
  for (const Parameter& parameter : values.operation().parameters) {
    const std::string& id = parameter.property.id;
    if (values.isSet(id) && id != "name") process.values.emplace(id, *values.value(id));
  }
  return process;
}

// Plans from one waypoint to another and adds those between them, and the second.
Status addLeg(const CellScene& scene, const CellPlans& plans, const Waypoint& from, const Waypoint& to,
              const RouteSettings& settings, PlannedPath& planned, Progress progress) {
  const std::array<Waypoint, 2> ends{from, to};
  Result<PlannedPath> leg = plannedThrough(scene, plans, ends, settings, progress);
  if (!leg) return leg.error();
  planned.steps += leg->steps;
  for (std::size_t i = 1; i < leg->path.waypoints.size(); ++i)
    planned.path.waypoints.push_back(std::move(leg->path.waypoints[i]));
  return Done{};
}

// Near which the joints along the curve are looked for: the first end of the path that has joints of its own, so that
// the path is the same wherever the robot happens to stand. Without one, as targets have none: where the robot stands.
Result<JointValues> jointsToBeginFrom(const CellScene& scene, const RobotCellSnapshot& cell,
                                      const OperationValues& values) {
  for (const char* const end : {"from", "to"}) {
    if (!values.isSet(end)) continue;
    const std::string name = values.text(end);
    if (!cell.plans->configuration(name) && cell.plans->target(name)) continue;
    Result<Waypoint> waypoint = waypointCalled(scene, cell, name, cell.joints);
    return waypoint ? Result<JointValues>(std::move(waypoint->joints)) : waypoint.error();
  }
  return cell.joints;
}

// Returns the parameters that choose the curve and the part.
std::vector<Parameter> curveParameters() {
  return {textParameter("part", "BODY", "The part, given by name or number"),
          {.property = {.id = "near",
                        .group = {},
                        .label = {},
                        .value = "0,0,0",
                        .quantity = Quantity::Length,
                        .least = -kFarthestBody,
                        .largest = kFarthestBody},
           .meaning = "A place near the curve, in mm from the robot's base; a section goes through it",
           .word = "X,Y,Z",
           .parts = {{"x"}, {"y"}, {"z"}},
           .hasDefault = false},
          {.property = {.id = "along",
                        .group = {},
                        .label = QT_TRANSLATE_NOOP("Property", "Along"),
                        .value = 0.0,
                        .choices = {QT_TRANSLATE_NOOP("Property", "an edge"),
                                    QT_TRANSLATE_NOOP("Property", "a section across X"),
                                    QT_TRANSLATE_NOOP("Property", "a section across Y"),
                                    QT_TRANSLATE_NOOP("Property", "a section across Z"),
                                    QT_TRANSLATE_NOOP("Property", "a drawn curve")}},
           .meaning = "Curve that the tool follows; sections are perpendicular to an axis of the base",
           .word = "CURVE",
           .words = {"edge", "x", "y", "z", "drawn"}},
          textParameter("through", "PLACES", "Further points of a drawn curve: X,Y,Z;X,Y,Z"),
          {.property = {.id = "length",
                        .group = {},
                        .label = QT_TRANSLATE_NOOP("Property", "Length from there (0: all)"),
                        .value = 0.0,
                        .quantity = Quantity::Length,
                        .least = 0.0,
                        .largest = kFarthestBody},
           .meaning = "Length of the curve from the place on; 0: all of it",
           .word = "MM"}};
}

// Returns the parameters that define how the tool is held and moved along it.
std::vector<Parameter> holdingParameters() {
  constexpr double kRightAngle = 0.5 * std::numbers::pi;
  constexpr double kMostLead = 85.0 * kRadiansPerDegree;
  return {
      flagParameter("reverse", QT_TRANSLATE_NOOP("Property", "Opposite direction"),
                    "Follow the curve in the opposite direction"),
      numberParameter("lead", QT_TRANSLATE_NOOP("Property", "Lead"), "DEGREES",
                      "Lead angle of the tool; negative: it trails", 0.0, -kMostLead, kMostLead, Quantity::Angle),
      numberParameter("tilt", QT_TRANSLATE_NOOP("Property", "Tilt"), "DEGREES",
                      "Tilt of the tool to the right of its path", 0.0, -kRightAngle, kRightAngle, Quantity::Angle),
      numberParameter("spin", QT_TRANSLATE_NOOP("Property", "Turn about the tool"), "DEGREES",
                      "Rotation of the tool about its own axis", 0.0, -std::numbers::pi, std::numbers::pi,
                      Quantity::Angle),
      flagParameter("free", QT_TRANSLATE_NOOP("Property", "Free to turn about the tool"),
                    "The rotation of the tool about its own axis is chosen freely"),
      numberParameter("standoff", QT_TRANSLATE_NOOP("Property", "Distance from the part"), "MM",
                      "Distance of the tool from the curve", 1.0, -1e3, 1e3, Quantity::Length),
      numberParameter("approach", QT_TRANSLATE_NOOP("Property", "Approach and retract"), "MM",
                      "Length of approach and retract along the axis of the tool", 50.0, 0.0, 1e4, Quantity::Length),
      numberParameter("speed", QT_TRANSLATE_NOOP("Property", "Speed (mm/s)"), "MM/S",
                      "Speed of the tool along the curve, in mm/s", 50.0, 0.01, 1e4, Quantity::Number),
      numberParameter("blend", QT_TRANSLATE_NOOP("Property", "Blend"), "MM",
                      "Radius within which the tool may round off a point of the curve", 1.0, 0.0, 100.0,
                      Quantity::Length),
      numberParameter("tolerance", QT_TRANSLATE_NOOP("Property", "Tolerance"), "MM",
                      "Largest distance of the path from the curve", 0.1, 1e-4, 100.0, Quantity::Length),
      {.property = {.id = "clearance",
                    .group = {},
                    .label = QT_TRANSLATE_NOOP("Property", "Clearance"),
                    .value = 0.0,
                    .quantity = Quantity::Length,
                    .least = 0.0,
                    .largest = 1e4},
       .meaning = "Clearance from all obstacles; default: that of the cell",
       .word = "MM",
       .hasDefault = false}};
}

// From approach to retract.
std::vector<Waypoint> processWaypoints(const CellScene& scene, const FollowedTrack& followed,
                                       const OperationValues& values) {
  std::vector<Waypoint> waypoints;
  for (const ArmValues& each : followed.values) {
    waypoints.push_back({.joints = scene.whole(each),
                         .motion = ProgramMotion::Kind::Linear,
                         .speed = values.number("speed"),
                         .blend = values.number("blend")});
  }
  waypoints.front() = {.joints = waypoints.front().joints, .name = "approach"};
  waypoints.back().name = "retract";
  waypoints[1].blend = waypoints[waypoints.size() - 2].blend = waypoints.back().blend = 0.0;
  return waypoints;
}

}  // namespace

const Operation& processPathOperation() {
  static const Operation kOperation = [] {
    Operation process = {.id = "process",
                         .title = QT_TRANSLATE_NOOP("Tool", "Plan process path"),
                         .meaning = "Plans a path of the tool along an edge, a section or a drawn curve of a part",
                         .parameters = curveParameters()};
    auto& all = process.parameters;
    for (Parameter& each : holdingParameters()) all.push_back(std::move(each));
    all.push_back(textParameter("from", "PLACE", "Start of a collision-free path to the curve"));
    all.push_back(textParameter("to", "PLACE", "Goal of a collision-free path after the curve"));
    all.push_back(textParameter("name", "NAME", "The name of the path in the cell"));
    return process;
  }();
  return kOperation;
}

Result<BodyPointer> partCalled(const OperationValues& values, const CellScene& scene) {
  Result<BodyPointer> part = bodyCalled(scene.bodies, values.text("part"));
  if (part && carrierOf(**part, scene.robot->model) != kNone)
    return Error{CellError::PartCarried, {(*part)->name}, {}, {}};
  return part;
}

Result<SurfaceTrack> trackOn(const std::shared_ptr<const PartSurface>& surface, const Body& body,
                             const OperationValues& values) {
  const std::vector<double> numbers = values.numbers("near");
  const Pose toBody = body.pose.inverse(Eigen::Isometry);
  const Vec3 near = toBody * Vec3(numbers[0], numbers[1], numbers[2]);
  const std::size_t along = values.whole("along");
  SurfaceTrack track;
  if (along == kAlongDrawn) {
    Result<SurfaceTrack> drawn =
        drawnTrack(surface, toBody, near, values.isSet("through") ? values.text("through") : std::string());
    if (!drawn) return drawn.error();
    track = std::move(drawn).value();
  } else if (along == kAlongEdge) {
    track = surface->edgeNear(near, std::numeric_limits<double>::max());
  } else {
    track = surface->sectionNear(near, toBody.linear().col(static_cast<Eigen::Index>(along) - 1), near);
  }
  track = finishedTrack(std::move(track), near, body, values);
  if (track.points.size() < 2) return Error{CellError::TrackMissing, {body.name}, {}, {}};
  return track;
}

SurfaceTrack finishedTrack(SurfaceTrack track, const Vec3& near, const Body& body, const OperationValues& values) {
  if (track.points.size() < 2) return {};
  if (values.flag("reverse")) track = track.reversed();
  const double length = values.number("length");
  if (track.isClosed || length > 0.0)
    track = pieceFrom(track, near, length > 0.0 ? length : std::numeric_limits<double>::max());
  if (track.points.size() < 2) return {};
  track = simplified(track, values.number("tolerance"), kNormalAngle);
  move(track, body.pose);
  return track;
}

Result<PlannedPath> processPath(const CellScene& scene, const RobotCellSnapshot& cell, const OperationValues& values,
                                const std::shared_ptr<const PartSurface>& surface, const Body& body, Progress progress,
                                const std::optional<Pose>& chosenAt) {
  const auto begin = std::chrono::steady_clock::now();
  Body asChosen = body;
  asChosen.pose = chosenAt.value_or(body.pose);
  Result<SurfaceTrack> track = trackOn(surface, asChosen, values);
  if (!track) return track.error();
  if (chosenAt) move(*track, body.pose * chosenAt->inverse(Eigen::Isometry));
  if (track->points.size() > RobotPath::kMostWaypoints)
    return Error{ErrorCode::FileTooLarge,
                 {"points", std::to_string(track->points.size()), std::to_string(RobotPath::kMostWaypoints)},
                 {},
                 {}};
  std::vector<Pose> poses = toolPoses(*track, {.lead = values.number("lead"),
                                               .tilt = values.number("tilt"),
                                               .spin = values.number("spin"),
                                               .standoff = values.number("standoff")});
  const Pose away(Eigen::Translation3d(0.0, 0.0, -values.number("approach")));
  poses.insert(poses.begin(), poses.front() * away);
  poses.push_back(poses.back() * away);
  RouteSettings route;
  route.plan.check.clearance = values.given("clearance").value_or(cell.plans->clearance);
  route.plan.seconds = 10.0;
  const TrackSettings settings{.check = route.plan.check, .line = {}, .spins = values.flag("free") ? kFreeSpins : 1};
  const Result<JointValues> near = jointsToBeginFrom(scene, cell, values);
  if (!near) return near.error();
  const FollowedTrack followed = followTrack(scene.scene, scene.arm, cell.plans->tool, poses, scene.planned(*near),
                                             settings, progress.part(0.0, 0.8));
  if (const Status solved = checkFollowed(followed, poses, scene); !solved) return solved.error();
  PlannedPath planned;
  planned.path.waypoints = processWaypoints(scene, followed, values);
  const std::vector<Waypoint>& waypoints = planned.path.waypoints;
  if (values.isSet("from")) {
    const Result<Waypoint> from = waypointCalled(scene, cell, values.text("from"), waypoints.front().joints);
    if (!from) return from.error();
    PlannedPath before;
    before.path.waypoints.push_back(*from);
    const Status leg = addLeg(scene, *cell.plans, *from, waypoints.front(), route, before, progress.part(0.8, 0.9));
    if (!leg) return leg.error();
    before.path.waypoints.insert(before.path.waypoints.end(), waypoints.begin() + 1, waypoints.end());
    planned = std::move(before);
  }
  if (values.isSet("to")) {
    const Result<Waypoint> to = waypointCalled(scene, cell, values.text("to"), planned.path.waypoints.back().joints);
    if (!to) return to.error();
    const Waypoint last = planned.path.waypoints.back();
    const Status leg = addLeg(scene, *cell.plans, last, *to, route, planned, progress.part(0.9, 1.0));
    if (!leg) return leg.error();
  }
  planned.path.arm = cell.plans->arm;
  planned.isJagged = isJagged(*track);
  planned.path.clearance = cell.plans->ownClearance(route.plan.check.clearance);
  planned.path.process = processOf(
      values, {{}, asChosen.pose, body.pose, cell.plans->tool, basePose(scene.robot->model, scene.plannedArm())});
  planned.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return planned;
}

OperationValues valuesOf(const PathProcess& process) {
  OperationValues values(processPathOperation());
  for (const auto& [id, value] : process.values) {
    if (values.operation().find(id)) static_cast<void>(values.set(id, value));
  }
  return values;
}

}  // namespace handwheel
