// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/problems/PlanningSet.h"

#include "base/JsonText.h"

#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostProblems = 100'000, kMostObstacles = 10'000;
constexpr double kMillimetres = 1000.0;  // mm per metre
constexpr double kFarthest = 1e6;        // m

Error malformedSet(std::string element, const char* reason) {
  return {ErrorCode::ElementMalformed, {std::move(element), reason}, {}, {}};
}

// Returns the expected number of finite numbers, none beyond the farthest position.
std::optional<std::vector<double>> numbersOf(const Json& object, const char* key, std::size_t count) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_array() || found->size() != count) return std::nullopt;
  std::vector<double> numbers;
  for (const Json& each : *found) {
    if (!each.is_number() || !(std::abs(each.get<double>()) <= kFarthest)) return std::nullopt;
    numbers.push_back(each.get<double>());
  }
  return numbers;
}

std::optional<Pose> poseFrom(const Json& json) {
  if (!json.is_object()) return std::nullopt;
  const auto position = numbersOf(json, "position", 3), turn = numbersOf(json, "orientation", 4);
  if (!position || !turn) return std::nullopt;
  const Eigen::Quaterniond quaternion((*turn)[3], (*turn)[0], (*turn)[1], (*turn)[2]);
  if (!(quaternion.norm() > 1e-6)) return std::nullopt;
  Pose pose(quaternion.normalized());
  pose.translation() = kMillimetres * Vec3((*position)[0], (*position)[1], (*position)[2]);
  return pose;
}

// A shape may be in the frame of an object, as in scenes of MoveIt.
std::optional<CollisionPiece> obstacleFrom(const Json& json) {
  const std::optional<Pose> own = poseFrom(json);
  if (!own) return std::nullopt;
  const auto object = json.find("object_pose");
  const std::optional<Pose> frame = object == json.end() ? Pose::Identity() : poseFrom(*object);
  if (!frame) return std::nullopt;
  const Pose pose = *frame * *own;
  const std::string type = stringAt(json, "type");
  const auto sizes = numbersOf(json, "dimensions", type == "box" ? 3 : type == "cylinder" ? 2 : 1);
  if (!sizes) return std::nullopt;
  for (const double size : *sizes) {
    if (size < 0.0) return std::nullopt;
  }
  const auto mm = [&](std::size_t i) { return kMillimetres * (*sizes)[i]; };
  if (type == "box") return CollisionPiece::box(pose, {mm(0), mm(1), mm(2)});
  if (type == "cylinder") return CollisionPiece::cylinder(pose, mm(1), mm(0));
  if (type == "sphere") return CollisionPiece::sphere(pose.translation(), mm(0));
  return std::nullopt;
}

// element: its name in errors.
Result<PlanningProblem> problemFrom(const Json& json, const std::string& element, std::size_t joints) {
  if (!json.is_object()) return malformedSet(element, "an object was expected");
  PlanningProblem problem;
  problem.name = "_" + std::to_string(countAt(json, "index"));
  const auto start = numbersOf(json, "start", joints), goal = numbersOf(json, "goal", joints);
  if (!start || !goal) return malformedSet(element, "start and goal need a number for each joint");
  problem.start = *start;
  problem.goal = *goal;
  const auto objects = json.find("objects");
  if (objects == json.end() || !objects->is_array() || objects->size() > kMostObstacles)
    return malformedSet(element + ".objects", "a list was expected");
  for (const Json& object : *objects) {
    auto piece = obstacleFrom(object);
    if (!piece) return malformedSet(element + ".objects", "one of them is not a box, cylinder or sphere");
    problem.obstacles.push_back(std::move(*piece));
    problem.names.push_back(stringAt(object, "name"));
  }
  return problem;
}

}  // namespace

Result<PlanningSet> readPlanningSet(std::string_view text) {
  const Result<Json> json = parseJson(text, "problems");
  return json ? planningSetFrom(*json) : Result<PlanningSet>(json.error());
}

Result<PlanningSet> planningSetFrom(const Json& json) {
  if (!json.is_object()) return malformedSet("problems", "an object was expected");
  PlanningSet set;
  set.name = stringAt(json, "scene", "problems");
  const auto joints = json.find("joints"), problems = json.find("problems");
  if (joints == json.end() || !joints->is_array() || joints->size() > static_cast<std::size_t>(kMostArmJoints))
    return malformedSet("joints", "a list was expected");
  for (const Json& joint : *joints) {
    if (!joint.is_string()) return malformedSet("joints", "names were expected");
    set.joints.push_back(joint.get<std::string>());
  }
  if (problems == json.end() || !problems->is_array() || problems->size() > kMostProblems)
    return malformedSet("problems", "a list was expected");
  for (std::size_t i = 0; i < problems->size(); ++i) {
    Result<PlanningProblem> problem =
        problemFrom((*problems)[i], "problems[" + std::to_string(i) + "]", set.joints.size());
    if (!problem) return problem.error();
    problem->name = set.name + problem->name;
    set.problems.push_back(std::move(problem).value());
  }
  return set;
}

std::vector<CollisionBody> collisionBodies(const RobotModel& robot,
                                           std::span<const std::shared_ptr<const CollisionMesh>> meshes) {
  std::vector<CollisionBody> bodies;
  for (const Link& link : robot.links) {
    std::vector<CollisionPiece> pieces;
    for (const PlacedShape& placed : link.collisions) {
      const Shape& shape = robot.shapes[placed.shape];
      if (const auto* box = std::get_if<BoxShape>(&shape)) {
        pieces.push_back(CollisionPiece::box(placed.origin, box->size));
      } else if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) {
        pieces.push_back(CollisionPiece::cylinder(placed.origin, cylinder->radius, cylinder->length));
      } else if (const auto* sphere = std::get_if<SphereShape>(&shape)) {
        pieces.push_back(CollisionPiece::sphere(placed.origin.translation(), sphere->radius));
      } else if (placed.shape < meshes.size() && meshes[placed.shape]) {
        pieces.push_back(CollisionPiece::ofMesh(placed.origin, meshes[placed.shape]));
      }
    }
    bodies.emplace_back(std::move(pieces));
  }
  return bodies;
}

}  // namespace handwheel
