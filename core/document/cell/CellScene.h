// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellSnapshot.h"
#include "planning/PathShortcuts.h"
#include "planning/Roadmap.h"

#include <mutex>
#include <unordered_map>

namespace handwheel {

// The hierarchies of meshes for collisions, each built once as long as its mesh lives. Any thread.
class CollisionMeshes {
 public:
  std::shared_ptr<const CollisionMesh> of(const std::shared_ptr<const TriangleSoup>& soup);

 private:
  struct Entry {
    std::weak_ptr<const TriangleSoup> soup;
    std::shared_ptr<const CollisionMesh> mesh;
  };
  std::mutex m_mutex;
  std::unordered_map<const TriangleSoup*, Entry> m_entries;
};

// The shape of a body for collisions; empty where it has no triangles.
CollisionBody collisionBodyOf(const BodyGeometry& geometry, CollisionMeshes& meshes);

// A robot cell prepared for planning: the joints between the robot's base and its tool are planned, the others stand.
// All bodies are obstacles, those that are not shown, too; those that a link carries are links of their own, fixed to
// it. Immutable; any thread.
struct CellScene {
  RobotScene scene;
  SerialArm arm;                    // from the root to the link that carries the tool
  std::vector<std::uint32_t> dofs;  // of the robot, one for each planned joint
  JointValues others;               // of the whole robot: where the joints are that are not planned
  std::set<LinkPair>
      alwaysMeeting;  // pairs of links that meet however the joints stand, or close ones at rest: they do not count
  std::vector<std::uint32_t> shapeless;  // links whose meshes are missing: collisions of these are not seen
  std::shared_ptr<const CellRobot> robot;
  BodySet bodies;
  std::vector<BodyId> carried;  // the bodies that are links after those of the robot, in order
  std::shared_ptr<Roadmap> roadmap = std::make_shared<Roadmap>();  // of the planner "prm", from plan to plan

  ArmValues planned(const JointValues& joints) const;
  JointValues whole(const ArmValues& values) const;
  // What is nearest, by its names: a link, and a link or body. Both empty where nothing is.
  std::pair<std::string, std::string> namesOf(const RobotScene::Nearest& nearest) const;
  // The body that this link of the scene is; none: it is one of the robot.
  std::optional<BodyId> bodyOfLink(std::uint32_t link) const;
  // The joints that are not planned must be the same at both. False: they are not.
  bool standsAs(const JointValues& joints) const;
};

// Errors: those of SerialArm::of() and RobotScene::isSound().
Result<CellScene> sceneOf(const RobotCellSnapshot& cell, CollisionMeshes& meshes);

}  // namespace handwheel
