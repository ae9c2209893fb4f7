// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/CellScene.h"

#include "document/cell/BodyCarriers.h"
#include "document/cell/CellArms.h"
#include "document/cell/proof/MissingShapes.h"
#include "document/scene/BodyDisplay.h"
#include "planning/problems/PlanningSet.h"
#include "robot/Kinematics.h"
#include "scene/PrimitiveGeometry.h"

#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

// A description without any collision shapes collides with what it shows.
RobotModel withCollisions(const RobotModel& robot) {
  RobotModel changed = robot;
  if (!collidesWithVisuals(robot)) return changed;
  for (Link& link : changed.links) {
    link.collisions = link.visuals;
    link.unreadCollisions = link.unreadVisuals;
  }
  return changed;
}

struct AllowedPairs {
  std::set<LinkPair> links;
  std::vector<std::pair<std::uint32_t, BodyId>> bodies;
};

// The bodies that links carry become links, each behind a fixed joint. Returns their numbers, in order.
std::vector<BodyId> addCarried(const BodySet& bodies, RobotModel& robot) {
  std::vector<BodyId> carried;
  for (const BodyPointer& body : bodies) {
    const std::uint32_t carrier = carrierOf(*body, robot);
    if (carrier == kNone) continue;
    const auto link = static_cast<std::uint32_t>(robot.links.size());
    const auto joint = static_cast<std::uint32_t>(robot.joints.size());
    robot.links.push_back({.name = partOfBody(body->id), .parentJoint = joint, .visuals = {}, .collisions = {}});
    robot.joints.push_back(
        {.name = partOfBody(body->id), .parent = carrier, .child = link, .origin = body->pose, .limits = {}});
    robot.order.push_back(joint);
    carried.push_back(body->id);
  }
  return carried;
}

struct Obstacle {
  std::uint32_t link;
  CollisionBody body;
  Pose pose;
};

// Takes the shapes of the links that are not of this robot, where they stand. What is theirs keeps the clearance that
// things keep, and nothing of it is left out unasked, as pairs within one robot are.
std::vector<Obstacle> takeOthers(std::vector<CollisionBody>& shapes, const std::vector<Pose>& poses,
                                 const std::vector<std::uint32_t>& owners, std::size_t number) {
  std::vector<Obstacle> others;
  for (std::uint32_t l = 0; l < shapes.size(); ++l) {
    if (owners[l] != number && !shapes[l].pieces().empty())
      others.push_back({l, std::exchange(shapes[l], CollisionBody()), poses[l]});
  }
  return others;
}

// A body that replaces the shape of its carrier has the neighbours of that link.
void addNeighboursOfReplaced(const RobotCellSnapshot& cell, const RobotModel& robot, std::set<LinkPair>& pairs) {
  const std::set<LinkPair> between = pairs;
  for (const MissingShape& missing : missingShapes(*cell.robot, cell.bodies, *cell.plans)) {
    if (missing.state != MissingShape::State::Replaced) continue;
    const std::uint32_t link = linkNamed(robot, missing.part);
    const std::uint32_t body = linkNamed(robot, partOfBody(cell.bodies.withName(missing.by)->id));
    for (const auto& [a, b] : between) {
      if ((a == link || b == link) && a != body && b != body) pairs.insert(std::minmax(a == link ? b : a, body));
    }
  }
}

// robot: that of the cell with the bodies that it carries. owners: which robot each of its links belongs to.
AllowedPairs allowedOf(const RobotCellSnapshot& cell, const RobotModel& robot,
                       const std::vector<std::uint32_t>& owners) {
  AllowedPairs pairs{neighbours(robot), {}};
  addNeighboursOfReplaced(cell, robot, pairs.links);
  std::erase_if(pairs.links, [&](const LinkPair& pair) { return owners[pair.first] != owners[pair.second]; });
  for (const auto& [first, second] : cell.plans->allowed) {
    const std::uint32_t a = linkNamed(robot, first), b = linkNamed(robot, second);
    const auto body = bodyOfPart(a != kNone ? second : first);  // Either of them may be the carried body now
    if (a != kNone && b != kNone)
      pairs.links.insert(std::minmax(a, b));
    else if ((a != kNone || b != kNone) && body)
      pairs.bodies.emplace_back(a != kNone ? a : b, *body);
  }
  return pairs;
}

}  // namespace

// Cylinders and spheres as they are: their triangles are inside of them.
CollisionBody collisionBodyOf(const BodyGeometry& geometry, CollisionMeshes& meshes) {
  if (const auto* primitive = dynamic_cast<const PrimitiveGeometry*>(&geometry)) {
    const std::vector<double>& d = primitive->dimensions();
    switch (primitive->primitive()) {
      case Primitive::Cuboid:
        return CollisionBody({CollisionPiece::box(Pose::Identity(), {d[0], d[1], d[2]})});
      case Primitive::Cylinder:
        return CollisionBody({CollisionPiece::cylinder(Pose::Identity(), d[0], d[1])});
      case Primitive::Sphere:
        return CollisionBody({CollisionPiece::sphere(Vec3::Zero(), d[0])});
      case Primitive::Cone:
        break;
    }
  }
  const std::shared_ptr<const CollisionMesh> mesh = meshes.of(geometry.surface());
  if (mesh->bounds().isEmpty()) return {};
  return CollisionBody({CollisionPiece::ofMesh(Pose::Identity(), mesh)});
}

std::shared_ptr<const CollisionMesh> CollisionMeshes::of(const std::shared_ptr<const TriangleSoup>& soup) {
  {
    const std::lock_guard lock(m_mutex);
    std::erase_if(m_entries, [](const auto& entry) { return entry.second.soup.expired(); });
    const auto found = m_entries.find(soup.get());
    if (found != m_entries.end()) return found->second.mesh;
  }
  auto mesh = std::make_shared<const CollisionMesh>(*soup);
  const std::lock_guard lock(m_mutex);
  return m_entries.try_emplace(soup.get(), Entry{soup, std::move(mesh)}).first->second.mesh;
}

ArmValues CellScene::planned(const JointValues& joints) const {
  ArmValues values(static_cast<Eigen::Index>(dofs.size()));
  for (std::size_t i = 0; i < dofs.size(); ++i) values[static_cast<Eigen::Index>(i)] = joints[dofs[i]];
  return values;
}

JointValues CellScene::whole(const ArmValues& values) const {
  JointValues joints = others;
  for (std::size_t i = 0; i < dofs.size(); ++i) joints[dofs[i]] = values[static_cast<Eigen::Index>(i)];
  return joints;
}

std::pair<std::string, std::string> CellScene::namesOf(const RobotScene::Nearest& nearest) const {
  const auto nameOfLink = [&](std::uint32_t link) {
    if (link == kNone) return std::string();
    const auto body = bodyOfLink(link);
    return body ? bodies.withId(*body)->name : robot->model.links[link].name;
  };
  if (const std::uint32_t link = linkOfOwner(nearest.owner); link != kNone)
    return {nameOfLink(nearest.link), nameOfLink(link)};
  const BodyPointer body = nearest.owner == kNone ? nullptr : bodies.withId(nearest.owner);
  return {nameOfLink(nearest.link), body ? body->name : nameOfLink(nearest.otherLink)};
}

std::optional<BodyId> CellScene::bodyOfLink(std::uint32_t link) const {
  const std::size_t own = robot->model.links.size();
  return link == kNone || link < own ? std::nullopt : std::optional(carried[link - own]);
}

std::vector<std::uint32_t> CellScene::ownLinksOf(BodyId body) const {
  const auto found = std::find(carried.begin(), carried.end(), body);
  if (found == carried.end()) return {};
  const auto itself = static_cast<std::uint32_t>(robot->model.links.size() + (found - carried.begin()));
  return {itself, carrierOf(*bodies.withId(body), robot->model)};
}

bool CellScene::areUnplannedJointsAt(const JointValues& joints) const {
  return whole(planned(joints)) == joints;
}

bool CellScene::holdsFor(const RobotCellSnapshot& now, const CellPlans& then) const {
  return robot == now.robot && bodies == now.bodies && then.allowed == now.plans->allowed &&
         then.missingAs == now.plans->missingAs && areUnplannedJointsAt(now.joints) &&
         armNumber == activeArmNumber(*now.robot, *now.plans);
}

bool CellScene::areOwnUnplannedJointsAt(const JointValues& joints) const {
  const JointValues wanted = whole(planned(joints));
  return withJointsOf(*robot, armNumber, wanted, joints) == wanted;
}

std::set<std::string> CellScene::robotsElsewhere(const RobotPath& path) const {
  constexpr double kRounded = 1e-9;  // a share: a description is written and read again whenever a base is moved
  std::set<std::string> names;
  for (std::size_t i = 0; i < robot->arms.size(); ++i) {
    if (i == armNumber) continue;
    const auto base = path.bases.find(robot->arms[i].name);
    const bool isMoved =
        base != path.bases.end() && !basePose(robot->model, robot->arms[i]).isApprox(base->second, kRounded);
    const auto standsElsewhere = [&](const Waypoint& waypoint) {
      return withJointsOf(*robot, i, others, waypoint.joints) != others;
    };
    if (isMoved || std::any_of(path.waypoints.begin(), path.waypoints.end(), standsElsewhere))
      names.insert(robot->arms[i].name);
  }
  return names;
}

std::string CellScene::nameOfCoupled() const {
  return arm.coupling() ? robot->model.jointOfDof(dofs[2]).name : std::string();
}

SerialArm CellScene::armFromBase() const {
  std::vector<ArmJoint> joints(arm.joints().begin(), arm.joints().end());
  const Pose base = basePose(robot->model, plannedArm()).inverse(Eigen::Isometry);
  if (!joints.empty()) joints.front().before = base * joints.front().before;
  return SerialArm(std::move(joints), arm.size() == 0 ? Pose(base * arm.tip()) : arm.tip())
      .withCoupling(arm.coupling());
}

Result<CellScene> sceneOf(const RobotCellSnapshot& cell, CollisionMeshes& meshes) {
  return sceneOf(cell, meshes, activeArmNumber(*cell.robot, *cell.plans));
}

Result<CellScene> sceneOf(const RobotCellSnapshot& cell, CollisionMeshes& meshes, std::size_t number) {
  RobotModel robot = withCollisions(cell.robot->model);
  Result<SerialArm::InRobot> arm = SerialArm::of(robot, robot.root, cell.robot->arms[number].flange);
  if (!arm) return arm.error();
  std::vector<std::shared_ptr<const CollisionMesh>> surfaces(robot.shapes.size());
  for (std::size_t i = 0; i < robot.shapes.size(); ++i) {
    if (std::holds_alternative<MeshShape>(robot.shapes[i]) && cell.robot->surfaces[i])
      surfaces[i] = meshes.of(cell.robot->surfaces[i]);
  }
  std::vector<BodyId> carried = addCarried(cell.bodies, robot);
  const std::vector<std::uint32_t> owners = armsOfLinks(robot, cell.robot->arms);
  const AllowedPairs allowed = allowedOf(cell, robot, owners);
  std::vector<CollisionBody> shapes = collisionBodies(robot, surfaces);
  for (std::size_t i = 0; i < carried.size(); ++i) {
    shapes[cell.robot->model.links.size() + i] = collisionBodyOf(*cell.bodies.withId(carried[i])->geometry, meshes);
  }
  const std::vector<Obstacle> others = takeOthers(shapes, linkPoses(robot, cell.joints), owners, number);
  RobotScene scene(robot, Pose::Identity(), std::move(shapes), arm->dofs, cell.joints, allowed.links);
  if (const Status sound = scene.isSound(); !sound) return sound.error();
  // Objects that the robot carries are chosen by the user and may be turned into the arm: of these, only pairs that
  // always meet the link next to their own are ignored. Pairs of links are left out only where the user knows of them
  // (CellPlans::allowed).
  std::set<LinkPair> alwaysMeeting;
  if (!carried.empty()) alwaysMeeting = scene.alwaysMeeting();
  std::erase_if(alwaysMeeting, [&](const LinkPair& pair) {
    return pair.second < cell.robot->model.links.size() || scene.jointsBetween(pair) > 1;
  });
  scene.allowPairs(alwaysMeeting);
  for (const BodyPointer& body : cell.bodies) {
    if (std::find(carried.begin(), carried.end(), body->id) == carried.end())
      scene.addObstacle(collisionBodyOf(*body->geometry, meshes), body->pose, body->id);
  }
  for (const auto& [link, body] : allowed.bodies) scene.allow(link, body);
  const std::optional<AxisCoupling> coupling = couplingOf(cell.robot->arms[number], arm->arm);
  scene.setCoupling(coupling);
  const auto ownerOf = [&](std::uint32_t link) {
    const std::size_t own = cell.robot->model.links.size();
    return link < own ? CellScene::kLinkOwners + link : carried[link - own];
  };
  for (const Obstacle& other : others) scene.addObstacle(other.body, other.pose, ownerOf(other.link));
  for (const auto& [a, b] : allowed.links) {
    if (owners[a] != number) scene.allow(b, ownerOf(a));
    if (owners[b] != number) scene.allow(a, ownerOf(b));
  }
  return CellScene{std::move(scene),
                   arm->arm.withCoupling(coupling),
                   std::move(arm->dofs),
                   cell.joints,
                   std::move(alwaysMeeting),
                   missingShapes(*cell.robot, cell.bodies, *cell.plans),
                   cell.robot,
                   cell.bodies,
                   std::move(carried),
                   number};
}

}  // namespace handwheel
