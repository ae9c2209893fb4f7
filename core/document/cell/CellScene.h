// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellSnapshot.h"
#include "planning/PathShortcuts.h"
#include "planning/planners/Roadmap.h"

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

// A robot cell prepared for planning. The joints between the base of one robot and its tool are planned, the others
// stand. All bodies are obstacles, those that are not shown, too; those that a link carries are links of their own,
// fixed to it. Other robots, with what they carry, are obstacles where they stand. Immutable; any thread.
struct CellScene {
  RobotScene scene;
  SerialArm arm;                    // from the root to the link that carries the tool
  std::vector<std::uint32_t> dofs;  // of the robot, one for each planned joint
  JointValues others;               // of all robots: where the joints are that are not planned
  std::set<LinkPair>
      alwaysMeeting;  // pairs of links that meet however the joints stand, or close ones at rest: they do not count
  std::vector<std::uint32_t> shapeless;  // links whose meshes are missing: collisions of these are not seen
  std::shared_ptr<const CellRobot> robot;
  BodySet bodies;
  std::vector<BodyId> carried;  // the bodies that are links after those of the robot, in order
  std::size_t armNumber = 0;    // of the robot that is planned for, in CellRobot::arms
  std::shared_ptr<Roadmap> roadmap = std::make_shared<Roadmap>();  // of the planner "prm", from plan to plan

  ArmValues planned(const JointValues& joints) const;
  JointValues whole(const ArmValues& values) const;
  // What is nearest, by its names: a link, and a link or body. Both empty where nothing is.
  std::pair<std::string, std::string> namesOf(const RobotScene::Nearest& nearest) const;
  // The body that this link of the scene is; none: it is one of the robot.
  std::optional<BodyId> bodyOfLink(std::uint32_t link) const;
  // The links that a carried body does not collide with while it is moved by hand: what it is itself, which is still
  // where it was, and what carries it. Empty: it stands.
  std::vector<std::uint32_t> ownLinksOf(BodyId body) const;
  // Obstacles of these owners are links of other robots, by their numbers in the model; all others are bodies.
  static constexpr std::uint32_t kLinkOwners = 0x8000'0000;
  static std::uint32_t linkOfOwner(std::uint32_t owner) {
    return owner == kNone || owner < kLinkOwners ? kNone : owner - kLinkOwners;
  }
  // Whether all joints that are not planned are where they are at these values.
  bool areUnplannedJointsAt(const JointValues& joints) const;
  // The same of those of the robot that is planned for, as of a gripper.
  bool areOwnUnplannedJointsAt(const JointValues& joints) const;
  // Whether the cell is still what this was made of. allowed: the pairs of links that might touch then.
  bool holdsFor(const RobotCellSnapshot& now, const std::set<std::pair<std::string, std::string>>& allowed) const;
  // The names of the other robots that stand elsewhere at some place of the path, or whose bases were moved since.
  std::set<std::string> robotsElsewhere(const RobotPath& path) const;
  const RobotArm& plannedArm() const { return robot->arms[armNumber]; }
  // The same arm from its own base on, as its controller counts.
  SerialArm armFromBase() const;
};

// For the robot that is planned for, or for another one by its number. Errors: those of SerialArm::of() and
// RobotScene::isSound().
Result<CellScene> sceneOf(const RobotCellSnapshot& cell, CollisionMeshes& meshes);
Result<CellScene> sceneOf(const RobotCellSnapshot& cell, CollisionMeshes& meshes, std::size_t arm);

}  // namespace handwheel
