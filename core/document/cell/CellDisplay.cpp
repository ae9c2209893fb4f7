// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/CellDisplay.h"

#include "document/cell/BodyCarriers.h"
#include "document/scene/BodyDisplay.h"
#include "robot/Kinematics.h"

#include <algorithm>
#include <set>

namespace handwheel {

DisplayModel displayOf(const CellRobot& robot, const JointValues& joints) {
  const RobotModel& model = robot.model;
  const std::vector<Pose> poses = linkPoses(model, joints);
  const auto isSeen = [&](const PlacedShape& placed) { return robot.surfaces[placed.shape] != nullptr; };
  // Robots that have a visual shape, as far as it could be read; the others are drawn by their collision shapes.
  const std::vector<std::uint32_t> owners = armsOfLinks(model, robot.arms);
  std::set<std::uint32_t> seen;
  for (std::size_t l = 0; l < model.links.size(); ++l) {
    if (std::ranges::any_of(model.links[l].visuals, isSeen)) seen.insert(owners[l]);
  }
  DisplayModel display;
  for (std::size_t l = 0; l < model.links.size(); ++l) {
    const Link& link = model.links[l];
    const bool isDrawn = link.visuals.empty() ? seen.contains(owners[l]) : std::ranges::any_of(link.visuals, isSeen);
    const auto& shapes = isDrawn ? link.visuals : link.collisions;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      if (!robot.surfaces[shapes[i].shape]) continue;
      DisplayPart part;
      part.name = link.name + '/' + std::to_string(i);
      part.soup = robot.surfaces[shapes[i].shape];
      part.pose = poses[l] * shapes[i].origin;
      if (shapes[i].colour) part.colour = *shapes[i].colour;
      display.parts.push_back(std::move(part));
    }
  }
  return display;
}

DisplayModel displayOf(const CellRobot& robot, const JointValues& joints, const BodySet& bodies) {
  DisplayModel display = displayOf(robot, joints);
  for (DisplayPart& part : displayPartsOf(inFrameOfBase(bodies, robot.model, joints)))
    display.parts.push_back(std::move(part));
  return display;
}

std::uint32_t linkOfPart(const CellRobot& robot, std::string_view part) {
  const std::size_t slash = part.rfind('/');
  return slash == part.npos ? kNone : linkNamed(robot.model, part.substr(0, slash));
}

}  // namespace handwheel
