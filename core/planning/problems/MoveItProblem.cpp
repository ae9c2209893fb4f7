// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/problems/MoveItProblem.h"

#include "base/JsonText.h"
#include "planning/problems/YamlText.h"

#include <map>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using Json = nlohmann::json;

Error malformedPair(std::string element, const char* reason) {
  return {ErrorCode::ElementMalformed, {std::move(element), reason}, {}, {}};
}

// Returns the value under these keys, each nested in the one before; null if there is none.
const Json& under(const Json& json, std::initializer_list<const char*> keys) {
  static const Json kNothing;
  const Json* found = &json;
  for (const char* key : keys) {
    if (!found->is_object() || !found->contains(key)) return kNothing;
    found = &(*found)[key];
  }
  return *found;
}

bool isFilled(const Json& json) {
  return !json.is_null() && !(json.is_structured() && json.empty());
}

// Adds the shapes of an object in the format of a JSON set. Returns the error; null: none.
const char* addShapes(const Json& object, Json& shapes) {
  for (const char* other : {"meshes", "planes"}) {
    if (isFilled(under(object, {other}))) return "meshes and planes are not supported";
  }
  const std::string frame = stringAt(under(object, {"header"}), "frame_id");
  if (!frame.empty() && frame != "world" && frame != "/world") return "only the frame of the root is supported";
  const Json &primitives = under(object, {"primitives"}), &poses = under(object, {"primitive_poses"});
  if (!primitives.is_array() || !poses.is_array() || primitives.size() != poses.size())
    return "primitives and primitive_poses need equally many elements";
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    Json shape = {{"name", stringAt(object, "id")},
                  {"type", under(primitives[i], {"type"})},
                  {"dimensions", under(primitives[i], {"dimensions"})},
                  {"position", under(poses[i], {"position"})},
                  {"orientation", under(poses[i], {"orientation"})}};
    if (object.contains("pose")) shape["object_pose"] = object["pose"];
    shapes.push_back(std::move(shape));
  }
  return nullptr;
}

Result<Json> shapesOf(const Json& scene) {
  if (isFilled(under(scene, {"world", "octomap"}))) return malformedPair("scene.world.octomap", "it is not supported");
  if (isFilled(under(scene, {"robot_state", "attached_collision_objects"})))
    return malformedPair("scene.robot_state.attached_collision_objects", "they are not supported");
  const Json& objects = under(scene, {"world", "collision_objects"});
  if (!objects.is_array() && !objects.is_null())
    return malformedPair("scene.world.collision_objects", "a list was expected");
  Json shapes = Json::array();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (const char* wrong = addShapes(objects[i], shapes))
      return malformedPair("scene.world.collision_objects[" + std::to_string(i) + "]", wrong);
  }
  return shapes;
}

// Returns the pairs that the matrix allows, by name.
Result<std::vector<NamePair>> allowedOf(const Json& scene) {
  const Json& matrix = under(scene, {"allowed_collision_matrix"});
  const Json &names = under(matrix, {"entry_names"}), &rows = under(matrix, {"entry_values"});
  std::vector<NamePair> allowed;
  if (names.is_null() && rows.is_null()) return allowed;
  const auto malformed = malformedPair("scene.allowed_collision_matrix", "a square of true and false was expected");
  if (!names.is_array() || !rows.is_array() || rows.size() != names.size()) return malformed;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!names[i].is_string() || !rows[i].is_array() || rows[i].size() != names.size()) return malformed;
    for (std::size_t k = 0; k < i; ++k) {
      if (!rows[i][k].is_boolean()) return malformed;
      if (rows[i][k].get<bool>()) allowed.emplace_back(names[k].get<std::string>(), names[i].get<std::string>());
    }
  }
  return allowed;
}

// Returns the joints of the goal with their positions, in order.
Result<std::vector<std::pair<std::string, double>>> goalOf(const Json& request) {
  const Json& goals = under(request, {"goal_constraints"});
  const auto malformed =
      malformedPair("request.goal_constraints", "one goal with joint_constraints, and nothing else, was expected");
  if (!goals.is_array() || goals.size() != 1) return malformed;
  for (const char* other : {"position_constraints", "orientation_constraints", "visibility_constraints"}) {
    if (isFilled(under(goals[0], {other}))) return malformed;
  }
  std::vector<std::pair<std::string, double>> goal;
  for (const Json& each : under(goals[0], {"joint_constraints"})) {
    const Json& position = under(each, {"position"});
    const std::string joint = stringAt(each, "joint_name");
    if (joint.empty() || !position.is_number()) return malformed;
    goal.emplace_back(joint, position.get<double>());
  }
  if (goal.empty()) return malformed;
  return goal;
}

Result<std::map<std::string, double>> startOf(const Json& request) {
  if (isFilled(under(request, {"start_state", "attached_collision_objects"})))
    return malformedPair("request.start_state.attached_collision_objects", "they are not supported");
  const Json& names = under(request, {"start_state", "joint_state", "name"});
  const Json& positions = under(request, {"start_state", "joint_state", "position"});
  const auto malformed = malformedPair("request.start_state.joint_state", "a position for each name was expected");
  if (!names.is_array() || !positions.is_array() || names.size() != positions.size()) return malformed;
  std::map<std::string, double> start;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!names[i].is_string() || !positions[i].is_number()) return malformed;
    start[names[i].get<std::string>()] = positions[i].get<double>();
  }
  return start;
}

}  // namespace

Result<PlanningSet> readMoveItProblem(std::string_view scene, std::string_view request, const std::string& name) {
  const Result<Json> world = parseYaml(scene, "scene"), query = parseYaml(request, "request");
  if (!world) return world.error();
  if (!query) return query.error();
  const auto goal = goalOf(*query);
  if (!goal) return goal.error();
  const auto start = startOf(*query);
  if (!start) return start.error();
  const Result<Json> shapes = shapesOf(*world);
  if (!shapes) return shapes.error();
  Result<std::vector<NamePair>> allowed = allowedOf(*world);
  if (!allowed) return allowed.error();
  Json joints = Json::array(), from = Json::array(), to = Json::array();
  for (const auto& [joint, position] : *goal) {
    const auto found = start->find(joint);
    if (found == start->end()) return malformedPair("request.start_state", "a joint of the goal is missing");
    joints.push_back(joint);
    from.push_back(found->second);
    to.push_back(position);
  }
  const Json problem = {{"start", from}, {"goal", to}, {"objects", *shapes}};
  Result<PlanningSet> set =
      planningSetFrom({{"scene", name}, {"joints", joints}, {"problems", Json::array({problem})}});
  if (!set) {
    Error error = set.error();  // the name of the set is meaningless to the user
    const bool isOfScene = error.arguments.at(0).find("objects") != std::string::npos;
    error.arguments[0] = isOfScene ? "scene.world.collision_objects" : "request";
    return error;
  }
  set->problems[0].name = name;
  set->problems[0].allowed = std::move(allowed).value();
  return set;
}

}  // namespace handwheel
