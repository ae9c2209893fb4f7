// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellSnapshot.h"
#include "document/cell/proof/MissingShape.h"
#include "planning/PathShortcuts.h"
#include "planning/planners/Roadmap.h"

#include <mutex>
#include <unordered_map>

namespace handwheel {

// Bounding hierarchies of meshes for collisions. Each is built once and kept while its mesh exists. The functions may
// be called on any thread.
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

// Returns the shape of a body for collisions. The result is empty if the body has no triangles.
CollisionBody collisionBodyOf(const BodyGeometry& geometry, CollisionMeshes& meshes);

// A robot cell prepared for planning. The joints between the base of one robot and its tool are planned, the others do
// not move. All bodies are obstacles, including hidden ones; each body that a link carries is an additional link, fixed
// to its carrier. Other robots, with the bodies that they carry, are obstacles at their present joint values. A scene
// is immutable and may be used on any thread.
struct CellScene {
  RobotScene scene;
  SerialArm arm;                    // Joints from the root to the link that carries the tool
  std::vector<std::uint32_t> dofs;  // Degree of freedom of the robot for each planned joint
  JointValues others;               // Joint values of all robots, for the joints that are not planned
  // Ignored pairs of a carried body and the link next to its carrier, which meet at all joint values.
  std::set<LinkPair> alwaysMeeting;
  std::vector<MissingShape> missing;  // Shapes of links and bodies that could not be read
  std::shared_ptr<const CellRobot> robot;
  BodySet bodies;
  std::vector<BodyId> carried;  // Bodies that are additional links after those of the robot, in order
  std::size_t armNumber = 0;    // Index of the planned robot in CellRobot::arms
  std::shared_ptr<Roadmap> roadmap = std::make_shared<Roadmap>();  // Roadmap of the planner "prm", kept between plans

  ArmValues planned(const JointValues& joints) const;
  JointValues whole(const ArmValues& values) const;
  // Returns the names of the nearest pair: a link, and a link or body. The names are empty if there is no pair.
  std::pair<std::string, std::string> namesOf(const RobotScene::Nearest& nearest) const;
  // Returns the body that a link of the scene represents; nothing if it is a link of the robot.
  std::optional<BodyId> bodyOfLink(std::uint32_t link) const;
  // Returns the links that a carried body is not tested against while it is moved by hand: the link that represents the
  // body at its former pose, and its carrier. The result is empty if no link carries the body.
  std::vector<std::uint32_t> ownLinksOf(BodyId body) const;
  // First owner number of obstacles that are links of other robots. The owner number of such a link is the sum of this
  // value and the number of the link in the model; smaller owner numbers denote bodies.
  static constexpr std::uint32_t kLinkOwners = 0x8000'0000;
  static std::uint32_t linkOfOwner(std::uint32_t owner) {
    return owner == kNone || owner < kLinkOwners ? kNone : owner - kLinkOwners;
  }
  // Returns true if all joints that are not planned have the same values as in the scene.
  bool areUnplannedJointsAt(const JointValues& joints) const;
  // Returns true if the unplanned joints of the planned robot itself, such as those of a gripper, have the same values
  // as in the scene.
  bool areOwnUnplannedJointsAt(const JointValues& joints) const;
  // Returns true if the cell is unchanged since this scene was made. then: the plans when it was made.
  bool holdsFor(const RobotCellSnapshot& now, const CellPlans& then) const;
  // Returns the names of the other robots whose joint values in the scene differ from those in a waypoint of the path,
  // or whose bases were moved since the path was planned.
  std::set<std::string> robotsElsewhere(const RobotPath& path) const;
  const RobotArm& plannedArm() const { return robot->arms[armNumber]; }
  // Returns the name of the joint that the limits of a coupling (SerialArm::coupling()) are said of; empty: none.
  std::string nameOfCoupled() const;
  // Returns the arm relative to its own base, as its controller measures poses.
  SerialArm armFromBase() const;
};

// Prepare the scene for the robot that is planned for, or for the robot with the index `arm` in CellRobot::arms.
// Errors: the errors of SerialArm::of() and RobotScene::isSound().
Result<CellScene> sceneOf(const RobotCellSnapshot& cell, CollisionMeshes& meshes);
Result<CellScene> sceneOf(const RobotCellSnapshot& cell, CollisionMeshes& meshes, std::size_t arm);

}  // namespace handwheel
