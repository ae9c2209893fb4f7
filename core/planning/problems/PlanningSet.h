// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/planners/SblPlanner.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

using NamePair = std::pair<std::string, std::string>;

// A planning problem for comparing planners. It has the start, the goal and the obstacles of a robot.
struct PlanningProblem {
  std::string name;                       // name of the set and number of the problem
  std::vector<double> start, goal;        // rad, in the order of the set's joints
  std::vector<CollisionPiece> obstacles;  // in the frame of the robot's root; mm
  std::vector<std::string> names;         // names of the obstacles; all obstacles of one object have the same name
  std::vector<NamePair> allowed;          // pairs of links or obstacles whose collisions are ignored
};

struct PlanningSet {
  std::string name;
  std::vector<std::string> joints;
  std::vector<PlanningProblem> problems;
};

// Reads a set in the JSON format of MotionBenchMaker: {"scene", "joints": [name…], "problems": [{"index", "start",
// "goal", "objects": [{"type": "box", "cylinder" or "sphere", "dimensions", "position", "orientation": [x, y, z, w],
// "object_pose": the frame of position and orientation, if any}…]}…]}, in metres. The order of dimensions is that of
// MoveIt: for a cylinder, first the height, then the radius. Errors: ElementMalformed, and the errors of parseJson().
Result<PlanningSet> readPlanningSet(std::string_view json);
// Reads a set from parsed JSON of bounded depth. Errors: ElementMalformed.
Result<PlanningSet> planningSetFrom(const nlohmann::json& json);

// Returns the collision body of each link. meshes: the meshes of the robot's shapes, by the index of the shape; null:
// the shape is omitted.
std::vector<CollisionBody> collisionBodies(const RobotModel& robot,
                                           std::span<const std::shared_ptr<const CollisionMesh>> meshes = {});

}  // namespace handwheel
