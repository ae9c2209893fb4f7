// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/dh/DhTable.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr ShapeColour kGrey{0.62f, 0.64f, 0.67f}, kOrange{0.87f, 0.52f, 0.22f};

Pose afterJoint(const DhRow& row) {
  return Pose(Eigen::AngleAxisd(row.theta, Vec3::UnitZ()) * Eigen::Translation3d(row.a, 0.0, row.d) *
              Eigen::AngleAxisd(row.alpha, Vec3::UnitX()));
}

// Puts shapes into links, each shape once in the model.
class Builder {
 public:
  explicit Builder(RobotModel& robot) : m_robot(robot) {}

  void add(std::uint32_t link, Shape shape, const Pose& origin, std::optional<ShapeColour> colour) {
    const auto index = static_cast<std::uint32_t>(m_robot.shapes.size());
    m_robot.shapes.push_back(std::move(shape));
    m_robot.links[link].visuals.push_back({index, origin, colour});
    m_robot.links[link].collisions.push_back({index, origin, colour});
  }

  // Adds a cylinder from one point to another, with round ends of the same radius if requested.
  void addBar(std::uint32_t link, const Vec3& from, const Vec3& to, double radius) {
    const double length = (to - from).norm();
    if (length < 1e-9 * radius) return;
    Pose pose = Pose::Identity();
    pose.translation() = 0.5 * (from + to);
    pose.linear() = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), to - from).toRotationMatrix();
    add(link, CylinderShape{radius, length}, pose, kOrange);
  }

  void addBall(std::uint32_t link, const Vec3& at, double radius) {
    add(link, SphereShape{radius}, Pose(Eigen::Translation3d(at)), kOrange);
  }

  // Adds the housing of a joint, about the z axis of its frame.
  void addHousing(std::uint32_t link, double radius) {
    add(link, CylinderShape{1.15 * radius, 2.3 * radius}, Pose::Identity(), kGrey);
  }

 private:
  RobotModel& m_robot;
};

// Draws the plain shape of a link: along the joint's axis, then across to the next joint.
void drawLink(Builder& builder, std::uint32_t link, const DhRow& row, double radius) {
  const Vec3 end = afterJoint(row).translation(), corner(0.0, 0.0, end.z());
  builder.addHousing(link, radius);
  builder.addBar(link, Vec3::Zero(), corner, radius);
  if (std::abs(row.d) > radius && std::abs(row.a) > 0.0) builder.addBall(link, corner, radius);
  builder.addBar(link, corner, end, 0.9 * radius);
}

double thicknessOf(const DhTable& table) {
  if (table.thickness > 0.0) return table.thickness;
  return 0.055 * std::max(armOf(std::vector<DhRow>(table.joints.begin(), table.joints.end())).reach(), 1e-3);
}

}  // namespace

std::set<LinkPair> overlappingLinks(const DhTable& table) {
  std::set<LinkPair> pairs;
  const double reach = 2.5 * thicknessOf(table);
  for (std::uint32_t i = 0; i + 1 < table.joints.size(); ++i) {
    const bool isPlain = table.joints[i].mesh.empty() && table.joints[i + 1].mesh.empty();
    // Link i + 1 is between link i and link i + 2.
    if (isPlain && afterJoint(table.joints[i]).translation().norm() < reach) pairs.insert({i, i + 2});
  }
  return pairs;
}

bool isTableColour(const ShapeColour& colour) {
  constexpr float kRounding = 1e-3f;
  const auto isAlike = [&](const ShapeColour& other) {
    return std::equal(colour.begin(), colour.end(), other.begin(),
                      [](float a, float b) { return std::abs(a - b) <= kRounding; });
  };
  return isAlike(kGrey) || isAlike(kOrange);
}

RobotModel robotOf(const DhTable& table) {
  RobotModel robot;
  robot.name = table.name;
  robot.root = 0;
  robot.links.push_back({.name = "base", .parentJoint = kNone, .visuals = {}, .collisions = {}});
  const double thickness = thicknessOf(table);
  Builder builder(robot);
  const auto mesh = [&](const std::string& file) { return MeshShape{file, Vec3::Constant(1e-3 * table.meshUnit)}; };
  if (table.baseMesh.empty())
    builder.add(0, CylinderShape{1.7 * thickness, 0.6 * thickness}, Pose(Eigen::Translation3d(0, 0, 0.3 * thickness)),
                kGrey);
  else
    builder.add(0, mesh(table.baseMesh), Pose::Identity(), std::nullopt);
  Pose before = Pose::Identity();
  for (std::size_t i = 0; i < table.joints.size(); ++i) {
    const DhJoint& row = table.joints[i];
    Joint joint;
    joint.name = row.name;
    joint.kind = row.isPrismatic                                        ? JointKind::Prismatic
                 : std::isfinite(row.lower) || std::isfinite(row.upper) ? JointKind::Revolute
                                                                        : JointKind::Continuous;
    joint.parent = static_cast<std::uint32_t>(i);
    joint.child = static_cast<std::uint32_t>(i + 1);
    joint.origin = before;
    joint.axis = row.sign * Vec3::UnitZ();
    joint.limits = {row.lower, row.upper, row.velocity, row.effort};
    joint.dof = static_cast<std::uint32_t>(i);
    robot.links.push_back({.name = "link_" + std::to_string(i + 1),
                           .parentJoint = static_cast<std::uint32_t>(i),
                           .visuals = {},
                           .collisions = {}});
    robot.dofs.push_back(joint.dof);
    robot.order.push_back(joint.dof);
    robot.joints.push_back(std::move(joint));
    before = afterJoint(row);
    const auto link = static_cast<std::uint32_t>(i + 1);
    // Wrists are thinner than shoulders.
    const double taper = 1.0 - 0.5 * static_cast<double>(i) / static_cast<double>(table.joints.size());
    if (row.mesh.empty())
      drawLink(builder, link, row, taper * thickness);
    else
      builder.add(link, mesh(row.mesh), before, std::nullopt);
  }
  Joint end;
  end.name = "flange";
  end.parent = static_cast<std::uint32_t>(table.joints.size());
  end.child = end.parent + 1;
  end.origin = before;
  robot.links.push_back({.name = "flange",
                         .parentJoint = static_cast<std::uint32_t>(robot.joints.size()),
                         .visuals = {},
                         .collisions = {}});
  robot.order.push_back(static_cast<std::uint32_t>(robot.joints.size()));
  robot.joints.push_back(std::move(end));
  return robot;
}

}  // namespace handwheel
