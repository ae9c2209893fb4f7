// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/planners/SblPlanner.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

using NamePair = std::pair<std::string, std::string>;

// A planning problem to compare planners with: a robot from start to goal among obstacles.
struct PlanningProblem {
  std::string name;                       // name of the set, and its number
  std::vector<double> start, goal;        // rad, in the order of the set's joints
  std::vector<CollisionPiece> obstacles;  // in the frame of the robot's root; mm
  std::vector<std::string> names;         // names of the obstacles; those of one object have the same
  std::vector<NamePair> allowed;          // names of links or obstacles whose collisions are ignored
};

struct PlanningSet {
  std::string name;
  std::vector<std::string> joints;
  std::vector<PlanningProblem> problems;
};

// Reads a set in the JSON format of MotionBenchMaker: {"scene", "joints": [name…], "problems": [{"index", "start",
// "goal", "objects": [{"type": "box", "cylinder" or "sphere", "dimensions", "position", "orientation": [x, y, z, w],
// "object_pose": the frame of these two, if any}…]}…]}, in metres. Dimensions are those of MoveIt: for a cylinder its
// height, then its radius. Errors: ElementMalformed, those of parseJson().
Result<PlanningSet> readPlanningSet(std::string_view json);
// Reads a set that is parsed already, with bounded depth.
Result<PlanningSet> planningSetFrom(const nlohmann::json& json);

// Returns the collision shape of each link, as far as it is made of primitives. Meshes are given by the caller, by the
// index of the shape; null: missing.
std::vector<CollisionBody> collisionBodies(const RobotModel& robot,
                                           std::span<const std::shared_ptr<const CollisionMesh>> meshes = {});

}  // namespace handwheel
