// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/ControllerBaseFrame.h"

#include "robot/dh/DhTable.h"

#include <string>
#include <string_view>

namespace handwheel {

namespace {

constexpr std::string_view kControllersLink = "base";

// Returns "left_base" for "left_base_link". A world link may carry that: then its own name is used.
std::string controllersLinkBeside(std::string_view base) {
  for (const std::string_view ending : {std::string_view("base_link"), kControllersLink, std::string_view("world")}) {
    if (base.ends_with(ending))
      return std::string(base.substr(0, base.size() - ending.size())) + std::string(kControllersLink);
  }
  return std::string(kControllersLink);
}

}  // namespace

std::optional<Pose> controllerBaseFrame(const RobotModel& robot, const RobotArm& arm) {
  if (libraryRobot(arm.title)) return Pose::Identity();
  std::uint32_t link = linkNamed(robot, controllersLinkBeside(robot.links[arm.base].name));
  if (link == kNone) return std::nullopt;
  Pose pose = Pose::Identity();
  while (link != arm.base) {
    const std::uint32_t above = robot.links[link].parentJoint;
    if (above == kNone || robot.joints[above].kind != JointKind::Fixed) return std::nullopt;
    pose = robot.joints[above].origin * pose;
    link = robot.joints[above].parent;
  }
  return pose;
}

}  // namespace handwheel
