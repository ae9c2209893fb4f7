// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/RobotArms.h"

#include "base/NumberText.h"
#include "robot/dh/DhTable.h"

#include <algorithm>
#include <cassert>

namespace handwheel {

namespace {

std::uint32_t shifted(std::uint32_t number, std::size_t by) {
  return number == kNone ? kNone : number + static_cast<std::uint32_t>(by);
}

// Returns the new indices of the kept elements, in order; kNone for the others.
std::vector<std::uint32_t> numbersOf(const std::vector<bool>& kept) {
  std::vector<std::uint32_t> numbers(kept.size(), kNone);
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i]) numbers[i] = next++;
  }
  return numbers;
}

// Returns the name with letters, digits, "-" and "_" only; letters beyond ASCII are kept.
std::string plainName(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    const bool isBeyondAscii = static_cast<unsigned char>(c) >= 0x80;
    plain += isBeyondAscii || isLetter(c) || isDigit(c) || c == '-' ? c : '_';
  }
  return plain.empty() ? "robot" : plain;
}

std::string freeLinkName(const RobotModel& robot, const std::string& preferred) {
  std::string name = preferred;
  for (int number = 2; linkNamed(robot, name) != kNone; ++number) name = preferred + '_' + std::to_string(number);
  return name;
}

// Removes the shapes that no link uses any more.
void dropShapes(RobotModel& robot) {
  std::vector<bool> isUsed(robot.shapes.size());
  const auto each = [&](const auto& visit) {
    for (Link& link : robot.links) {
      for (PlacedShape& placed : link.visuals) visit(placed);
      for (PlacedShape& placed : link.collisions) visit(placed);
    }
  };
  each([&](const PlacedShape& placed) { isUsed[placed.shape] = true; });
  const std::vector<std::uint32_t> numbers = numbersOf(isUsed);
  each([&](PlacedShape& placed) { placed.shape = numbers[placed.shape]; });
  std::vector<Shape> shapes;
  for (std::size_t i = 0; i < isUsed.size(); ++i) {
    if (isUsed[i]) shapes.push_back(std::move(robot.shapes[i]));
  }
  robot.shapes = std::move(shapes);
}

}  // namespace

RobotArm wholeArm(const RobotModel& robot) {
  const LibraryRobot* const known = libraryRobot(robot.name);
  return {known ? known->id : plainName(robot.name), robot.name, robot.root, toolLink(robot)};
}

std::vector<std::uint32_t> armsOfLinks(const RobotModel& robot, std::span<const RobotArm> arms) {
  std::vector<std::uint32_t> owners(robot.links.size(), kNone);
  std::vector<std::uint32_t> based(robot.links.size(), kNone);
  for (std::uint32_t i = 0; i < arms.size(); ++i) based[arms[i].base] = i;
  if (robot.root != kNone) owners[robot.root] = based[robot.root];
  for (const std::uint32_t j : robot.order) {
    const Joint& joint = robot.joints[j];
    owners[joint.child] = based[joint.child] != kNone ? based[joint.child] : owners[joint.parent];
  }
  return owners;
}

std::vector<std::uint32_t> armsOfDofs(const RobotModel& robot, std::span<const RobotArm> arms) {
  const std::vector<std::uint32_t> ofLinks = armsOfLinks(robot, arms);
  std::vector<std::uint32_t> owners;
  for (std::size_t dof = 0; dof < robot.dofs.size(); ++dof) owners.push_back(ofLinks[robot.jointOfDof(dof).child]);
  return owners;
}

Pose basePose(const RobotModel& robot, const RobotArm& arm) {
  return arm.base == robot.root ? Pose::Identity() : robot.joints[robot.links[arm.base].parentJoint].origin;
}

bool hasPlainShapes(const RobotModel& robot, std::span<const RobotArm> arms, std::size_t number) {
  const std::vector<std::uint32_t> owners = armsOfLinks(robot, arms);
  const auto isMesh = [&](const PlacedShape& placed) {
    return std::holds_alternative<MeshShape>(robot.shapes[placed.shape]);
  };
  bool isOfTable = false;
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const Link& link = robot.links[l];
    const auto isTables = [](const PlacedShape& placed) { return placed.colour && isTableColour(*placed.colour); };
    isOfTable = isOfTable || (owners[l] == number && std::any_of(link.visuals.begin(), link.visuals.end(), isTables));
    if (owners[l] == number && (std::any_of(link.visuals.begin(), link.visuals.end(), isMesh) ||
                                std::any_of(link.collisions.begin(), link.collisions.end(), isMesh)))
      return false;
  }
  return isOfTable;
}

RobotModel withBothShapes(RobotModel robot) {
  const auto& links = robot.links;
  const bool isSeen = std::ranges::any_of(links, [](const Link& link) { return !link.visuals.empty(); });
  const bool isSolid = std::ranges::any_of(links, &Link::isSolid);
  for (Link& link : robot.links) {
    if (!isSolid) {
      link.collisions = link.visuals;
      link.unreadCollisions = link.unreadVisuals;
    }
    if (!isSeen) link.visuals = link.collisions;
  }
  return robot;
}

RobotModel joined(const RobotModel& robot, const RobotModel& other, const std::string& name, const Pose& base) {
  RobotModel all = robot;
  const std::string prefix = name + '_';
  const std::size_t links = robot.links.size(), joints = robot.joints.size() + 1, shapes = robot.shapes.size(),
                    dofs = robot.dofs.size();
  const auto mount = static_cast<std::uint32_t>(robot.joints.size());
  all.joints.push_back({.name = prefix + "mount",
                        .parent = robot.root,
                        .child = shifted(other.root, links),
                        .origin = base,
                        .limits = {}});
  for (int number = 2; std::any_of(other.joints.begin(), other.joints.end(),
                                   [&](const Joint& joint) { return prefix + joint.name == all.joints.back().name; });
       ++number)
    all.joints.back().name = prefix + "mount_" + std::to_string(number);
  for (Link link : other.links) {
    link.name = prefix + link.name;
    link.parentJoint = link.parentJoint == kNone ? mount : shifted(link.parentJoint, joints);
    for (auto* const placed : {&link.visuals, &link.collisions}) {
      for (PlacedShape& each : *placed) each.shape = shifted(each.shape, shapes);
    }
    all.links.push_back(std::move(link));
  }
  for (Joint joint : other.joints) {
    joint.name = prefix + joint.name;
    joint.parent = shifted(joint.parent, links);
    joint.child = shifted(joint.child, links);
    joint.dof = shifted(joint.dof, dofs);
    all.joints.push_back(std::move(joint));
  }
  for (Shape shape : other.shapes) {
    if (auto* const mesh = std::get_if<MeshShape>(&shape)) mesh->file += '#' + name;
    all.shapes.push_back(std::move(shape));
  }
  all.order.push_back(mount);
  for (const std::uint32_t joint : other.order) all.order.push_back(shifted(joint, joints));
  for (const std::uint32_t joint : other.dofs) all.dofs.push_back(shifted(joint, joints));
  return all;
}

RobotModel withoutArm(const RobotModel& robot, std::span<const RobotArm> arms, std::size_t arm) {
  const std::vector<std::uint32_t> owners = armsOfLinks(robot, arms);
  std::vector<bool> keptLinks, keptJoints;
  for (std::uint32_t l = 0; l < robot.links.size(); ++l) keptLinks.push_back(owners[l] != arm || l == robot.root);
  for (const Joint& joint : robot.joints) keptJoints.push_back(keptLinks[joint.child]);
  const std::vector<std::uint32_t> links = numbersOf(keptLinks), joints = numbersOf(keptJoints);
  RobotModel rest;
  rest.name = robot.name;
  rest.shapes = robot.shapes;
  for (std::uint32_t l = 0; l < robot.links.size(); ++l) {
    if (!keptLinks[l]) continue;
    Link link = robot.links[l];
    if (owners[l] == arm) link = {.name = {}, .parentJoint = kNone, .visuals = {}, .collisions = {}};
    if (link.parentJoint != kNone) link.parentJoint = joints[link.parentJoint];
    rest.links.push_back(std::move(link));
  }
  rest.root = links[robot.root];
  if (Link& root = rest.links[rest.root]; root.name.empty()) root.name = freeLinkName(rest, "world");
  std::vector<std::uint32_t> dofs(robot.dofs.size(), kNone);
  for (std::size_t dof = 0; dof < robot.dofs.size(); ++dof) {
    if (joints[robot.dofs[dof]] == kNone) continue;
    dofs[dof] = static_cast<std::uint32_t>(rest.dofs.size());
    rest.dofs.push_back(joints[robot.dofs[dof]]);
  }
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    if (!keptJoints[j]) continue;
    Joint joint = robot.joints[j];
    joint.parent = links[joint.parent];
    joint.child = links[joint.child];
    if (joint.dof != kNone) joint.dof = dofs[joint.dof];
    rest.joints.push_back(std::move(joint));
  }
  for (const std::uint32_t j : robot.order) {
    if (keptJoints[j]) rest.order.push_back(joints[j]);
  }
  dropShapes(rest);
  return rest;
}

RobotModel withBaseAt(RobotModel robot, const RobotArm& arm, const Pose& base) {
  assert(arm.base != robot.root);
  robot.joints[robot.links[arm.base].parentJoint].origin = base;
  return robot;
}

std::string freeArmName(const RobotModel& robot, std::span<const RobotArm> arms, std::string_view preferred) {
  const std::string plain = plainName(preferred);
  const auto isTaken = [&](const std::string& name) {
    const auto begins = [&](const auto& each) { return each.name.starts_with(name + '_'); };
    return std::any_of(arms.begin(), arms.end(), [&](const RobotArm& arm) { return arm.name == name; }) ||
           std::any_of(robot.links.begin(), robot.links.end(), begins) ||
           std::any_of(robot.joints.begin(), robot.joints.end(), begins);
  };
  std::string name = plain;
  for (int number = 2; isTaken(name); ++number) name = plain + '_' + std::to_string(number);
  return name;
}

}  // namespace handwheel
