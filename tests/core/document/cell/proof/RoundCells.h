// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ExactConvexDistance.h"
#include "document/cell/RobotCellSnapshot.h"
#include "robot/ShapeSurfaces.h"
#include "scene/MeshGeometry.h"
#include "scene/PrimitiveGeometry.h"

#include <random>

// Random robot cells of round numbers and aligned poses. Gantries and small arms stand among boxes, cylinders, spheres
// and meshes of boxes, and may carry a part. Their convex sets are known beside what the program makes of them.
namespace handwheel::test {

// A solid of a cell. isMesh: a block that the cell has as triangles.
struct RoundSolid {
  ConvexSet set;  // at its pose in the link, or in the world
  bool isMesh = false;
};

// A joint of the chain, with the solids of the link that it moves.
struct RoundJoint {
  bool isPrismatic = false;
  Pose origin = Pose::Identity();
  Vec3 axis = Vec3::UnitZ();
  std::vector<RoundSolid> solids;
};

// A robot cell with a motion.
struct RoundCell {
  std::vector<RoundSolid> base;    // solids of the root
  std::vector<RoundJoint> joints;  // a chain
  std::optional<RoundSolid> part;  // a body that the last link carries
  std::vector<std::vector<RoundSolid>> obstacles;
  Eigen::VectorXd from, to;
  double clearance = 0.0;

  // Returns the poses of the links in the world, the root first.
  std::vector<Pose> linkPoses(const Eigen::VectorXd& values) const {
    std::vector<Pose> poses{Pose::Identity()};
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const double value = values[static_cast<Eigen::Index>(i)];
      Pose pose = poses.back() * joints[i].origin;
      if (joints[i].isPrismatic)
        pose.translate(value * joints[i].axis);
      else
        pose.rotate(Eigen::AngleAxisd(value, joints[i].axis));
      poses.push_back(pose);
    }
    return poses;
  }
  // Returns a bound of the travel of a point of the robot in the whole motion: each joint moves it by its own angle
  // times the largest distance that a point can have from its axis.
  double travel() const {
    double sum = 0.0, far = part ? farOf(*part) : 0.0;
    for (std::size_t i = joints.size(); i-- > 0;) {
      for (const RoundSolid& solid : joints[i].solids) far = std::max(far, farOf(solid));
      const auto k = static_cast<Eigen::Index>(i);
      const double moved = std::abs(to[k] - from[k]);
      sum += joints[i].isPrismatic ? moved : moved * far;
      far += joints[i].origin.translation().norm();
      if (joints[i].isPrismatic) far += std::max(std::abs(from[k]), std::abs(to[k]));
    }
    return sum;
  }

 private:
  static double farOf(const RoundSolid& solid) { return solid.set.pose.translation().norm() + solid.set.half.norm(); }
};

// A generator of random cells.
class RoundCells {
 public:
  explicit RoundCells(unsigned seed) : m_random(seed) {}

  RoundCell next() {
    RoundCell cell;
    if (upTo(2) == 0) cell.base.push_back(solid(Vec3(0.0, 0.0, -20.0), {50.0, 50.0, 10.0}));
    if (upTo(1) == 0)
      addGantry(cell);
    else
      addArm(cell);
    if (upTo(1) == 0) {
      cell.part = solid(5.0 * Vec3(upTo(8) - 4, upTo(8) - 4, upTo(8) - 4), size());
      turn(cell.part->set.pose);
    }
    for (int i = 1 + upTo(4); i > 0; --i) cell.obstacles.push_back(obstacle());
    const auto count = static_cast<Eigen::Index>(cell.joints.size());
    cell.from.resize(count);
    cell.to.resize(count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const bool slides = cell.joints[static_cast<std::size_t>(k)].isPrismatic;
      cell.from[k] = slides ? 10.0 * (upTo(40) - 20) : angle();
      cell.to[k] = upTo(3) == 0 ? cell.from[k] : slides ? 10.0 * (upTo(40) - 20) : angle();
    }
    cell.clearance = pick({0.0, 0.0, 1.0, 5.0, 10.0});
    return cell;
  }

 private:
  int upTo(int last) { return std::uniform_int_distribution<int>(0, last)(m_random); }
  double pick(std::initializer_list<double> values) {
    return values.begin()[upTo(static_cast<int>(values.size()) - 1)];
  }
  double angle() { return M_PI / 12.0 * (upTo(24) - 12); }
  Vec3 size() {  // half sizes
    const auto one = [&] { return pick({1.0, 2.5, 5.0, 10.0, 10.0, 25.0, 50.0}); };
    return {one(), one(), one()};
  }
  void turn(Pose& pose) {
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      pose.rotate(Eigen::AngleAxisd(pick({0.0, 0.0, 0.0, 90.0, 180.0, 45.0, 30.0}) * M_PI / 180.0, Vec3::Unit(axis)));
  }
  RoundSolid solid(const Vec3& at, const Vec3& half) {
    using Kind = ConvexSet::Kind;
    RoundSolid made;
    const int kind = upTo(5);
    made.set.kind = kind == 0 ? Kind::Ball : kind == 1 ? Kind::Cylinder : Kind::Block;
    made.isMesh = kind == 2;
    made.set.pose.translation() = at;
    made.set.half = half;
    if (made.set.kind == Kind::Ball) made.set.half = Vec3::Constant(half.x());
    if (made.set.kind == Kind::Cylinder) made.set.half.y() = half.x();
    return made;
  }
  // One solid, or a mesh of up to three boxes, which may lie inside of each other.
  std::vector<RoundSolid> obstacle() {
    const Vec3 at = 10.0 * Vec3(upTo(60) - 30, upTo(60) - 30, upTo(40) - 20);
    std::vector<RoundSolid> made{solid(at, upTo(3) == 0 ? Vec3(pick({5.0, 10.0}), 200.0, 200.0) : Vec3(2.0 * size()))};
    turn(made.front().set.pose);
    for (int more = made.front().isMesh ? upTo(2) : 0; more > 0; --more) {
      RoundSolid shell = made.front();
      shell.set.pose.translate(5.0 * Vec3(upTo(40) - 20, upTo(40) - 20, upTo(40) - 20));
      shell.set.half = size();
      made.push_back(shell);
    }
    return made;
  }
  void addGantry(RoundCell& cell) {
    const int axes = 1 + upTo(2), first = upTo(2);
    for (int i = 0; i < axes; ++i) {
      RoundJoint joint;
      joint.isPrismatic = true;
      joint.axis = Vec3::Unit((first + i) % 3);
      joint.origin.translation() = 10.0 * Vec3(upTo(10) - 5, upTo(10) - 5, upTo(10) - 5);
      if (i + 1 == axes || upTo(1) == 0) joint.solids.push_back(solid(Vec3::Zero(), size()));
      cell.joints.push_back(std::move(joint));
    }
    if (upTo(3) > 0) return;
    RoundJoint wrist;
    wrist.axis = Vec3::Unit(upTo(2));
    wrist.origin.translation().z() = 10.0 * upTo(10);
    wrist.solids.push_back(solid(Vec3(10.0 * upTo(5), 0.0, 0.0), size()));
    cell.joints.push_back(std::move(wrist));
  }
  void addArm(RoundCell& cell) {
    double length = 0.0;
    for (int i = 1 + upTo(3); i > 0; --i) {
      RoundJoint joint;
      joint.axis = Vec3::Unit(1 + upTo(1));
      joint.origin.translation() = Vec3(length, 0.0, pick({0.0, 0.0, 20.0, 50.0}));
      length = pick({50.0, 100.0, 150.0, 200.0});
      joint.solids.push_back(solid(Vec3(0.5 * length, 0.0, 0.0), {0.5 * length, pick({5.0, 10.0}), pick({5.0, 10.0})}));
      if (joint.solids.front().set.kind != ConvexSet::Kind::Block) {  // along the link
        joint.solids.front().set.half = {10.0, 10.0, 0.5 * length};
        joint.solids.front().set.pose.rotate(Eigen::AngleAxisd(M_PI / 2.0, Vec3::UnitY()));
      }
      if (upTo(3) == 0) joint.solids.push_back(solid(Vec3::Zero(), Vec3(20.0, 20.0, 20.0)));
      cell.joints.push_back(std::move(joint));
    }
  }

  std::mt19937 m_random;
};

inline TriangleSoup soupOf(const ConvexSet& block, const Pose& at) {
  TriangleSoup soup = surfaceOf(BoxShape{2.0 * block.half});
  for (Vec3& point : soup.points) point = at * point;
  return soup;
}

inline void addSolid(const RoundSolid& solid, CellRobot& robot, Link& link) {
  const Vec3& half = solid.set.half;
  std::shared_ptr<const TriangleSoup> surface;
  Shape shape = BoxShape{2.0 * half};
  if (solid.isMesh) {
    shape = MeshShape{"box.stl", Vec3::Ones()};
    surface = std::make_shared<const TriangleSoup>(soupOf(solid.set, Pose::Identity()));
  } else if (solid.set.kind == ConvexSet::Kind::Ball) {
    shape = SphereShape{half.x()};
  } else if (solid.set.kind == ConvexSet::Kind::Cylinder) {
    shape = CylinderShape{half.x(), 2.0 * half.z()};
  }
  link.collisions.push_back({static_cast<std::uint32_t>(robot.model.shapes.size()), solid.set.pose, {}});
  robot.model.shapes.push_back(shape);
  robot.surfaces.push_back(std::move(surface));
}

// Returns a body of the cell from its solids. A mesh of several boxes is one body.
inline BodyPointer bodyOf(const std::vector<RoundSolid>& solids, BodyId id) {
  const ConvexSet& first = solids.front().set;
  Body body{.id = id, .name = "body " + std::to_string(id), .pose = first.pose};
  if (solids.front().isMesh) {
    TriangleSoup all;
    for (const RoundSolid& each : solids) {
      const TriangleSoup soup = soupOf(each.set, first.pose.inverse() * each.set.pose);
      const auto offset = static_cast<std::uint32_t>(all.points.size());
      all.points.insert(all.points.end(), soup.points.begin(), soup.points.end());
      for (const Triangle& t : soup.triangles) all.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    }
    body.geometry = std::make_shared<const MeshGeometry>(std::move(all));
  } else if (first.kind == ConvexSet::Kind::Ball) {
    body.geometry = *PrimitiveGeometry::make(Primitive::Sphere, {first.half.x()});
  } else if (first.kind == ConvexSet::Kind::Cylinder) {
    body.geometry = *PrimitiveGeometry::make(Primitive::Cylinder, {first.half.x(), 2.0 * first.half.z()});
  } else {
    const Vec3 full = 2.0 * first.half;
    body.geometry = *PrimitiveGeometry::make(Primitive::Cuboid, {full.x(), full.y(), full.z()});
  }
  return std::make_shared<const Body>(std::move(body));
}

// Returns the cell as the program has it.
inline RobotCellSnapshot cellOf(const RoundCell& round) {
  auto robot = std::make_shared<CellRobot>();
  RobotModel& model = robot->model;
  model.name = "round";
  model.root = 0;
  model.links.push_back({.name = "link_0", .visuals = {}, .collisions = {}});
  for (const RoundSolid& solid : round.base) addSolid(solid, *robot, model.links.front());
  for (std::uint32_t i = 0; i < round.joints.size(); ++i) {
    const RoundJoint& from = round.joints[i];
    Joint joint{.name = "joint_" + std::to_string(i + 1), .parent = i, .child = i + 1, .origin = from.origin};
    joint.kind = from.isPrismatic ? JointKind::Prismatic : JointKind::Revolute;
    joint.axis = from.axis;
    joint.limits.lower = from.isPrismatic ? -1000.0 : -2.0 * M_PI;
    joint.limits.upper = -joint.limits.lower;
    joint.dof = i;
    model.links.push_back({.name = "link_" + std::to_string(i + 1), .parentJoint = i, .visuals = {}, .collisions = {}});
    for (const RoundSolid& solid : from.solids) addSolid(solid, *robot, model.links.back());
    model.order.push_back(i);
    model.dofs.push_back(i);
    model.joints.push_back(std::move(joint));
  }
  robot->arms = {wholeArm(model)};
  RobotCellSnapshot cell;
  cell.joints = round.from;
  BodyId next = 1;
  if (round.part) {
    Body part = *bodyOf({*round.part}, next++);
    part.carrier = model.links.back().name;
    cell.bodies = cell.bodies.with(std::make_shared<const Body>(std::move(part)));
  }
  for (const auto& obstacle : round.obstacles) cell.bodies = cell.bodies.with(bodyOf(obstacle, next++));
  cell.robot = std::move(robot);
  return cell;
}

}  // namespace handwheel::test
