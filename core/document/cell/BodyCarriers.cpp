// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/BodyCarriers.h"

#include "document/scene/BodyChanges.h"
#include "robot/Kinematics.h"

#include <QtGlobal>
#include <algorithm>

namespace handwheel {

std::uint32_t carrierOf(const Body& body, const RobotModel& robot) {
  return body.carrier.empty() ? kNone : linkNamed(robot, body.carrier);
}

Pose carrierPose(const Body& body, const RobotModel& robot, std::span<const Pose> linkPoses) {
  const std::uint32_t link = carrierOf(body, robot);
  return link == kNone ? Pose::Identity() : linkPoses[link];
}

BodySet inFrameOfBase(const BodySet& bodies, const RobotModel& robot, const JointValues& joints) {
  const auto isCarried = [&](const BodyPointer& body) { return carrierOf(*body, robot) != kNone; };
  if (std::none_of(bodies.begin(), bodies.end(), isCarried)) return bodies;
  const std::vector<Pose> poses = linkPoses(robot, joints);
  BodySet placed = bodies;
  for (const BodyPointer& body : bodies) {
    if (!isCarried(body)) continue;
    auto there = std::make_shared<Body>(*body);
    there->pose = carrierPose(*body, robot, poses) * body->pose;
    placed = placed.with(std::move(there));
  }
  return placed;
}

Result<std::unique_ptr<Edit>> carryEdit(const BodySet& bodies, const std::set<BodyId>& ids, std::uint32_t link,
                                        const RobotModel& robot, const JointValues& joints) {
  const std::vector<Pose> poses = linkPoses(robot, joints);
  std::vector<Body> changed;
  for (const BodyId id : ids) {
    const BodyPointer body = bodies.withId(id);
    if (!body) return Error{ErrorCode::ReferenceMissing, {"the body", std::to_string(id)}, {}, {}};
    if (carrierOf(*body, robot) == link) continue;
    Body carried = *body;
    carried.carrier = link == kNone ? std::string() : robot.links[link].name;
    carried.pose =
        carrierPose(carried, robot, poses).inverse(Eigen::Isometry) * carrierPose(*body, robot, poses) * body->pose;
    changed.push_back(std::move(carried));
  }
  return changeBodiesEdit(bodies, std::move(changed));
}

Result<std::unique_ptr<Edit>> mountEdit(const BodySet& bodies, BodyId id, std::uint32_t link, const RobotModel& robot) {
  const BodyPointer body = bodies.withId(id);
  if (!body) return Error{ErrorCode::ReferenceMissing, {"the body", std::to_string(id)}, {}, {}};
  Body mounted = *body;
  mounted.carrier = robot.links[link].name;
  mounted.pose = Pose::Identity();
  return changeBodyEdit(bodies, std::move(mounted));
}

Property carrierProperty(const Body& body, const RobotModel& robot) {
  Property property;
  property.id = "body." + std::to_string(body.id) + ".carrier";
  property.group = body.name;
  property.groupTranslated = false;
  property.label = QT_TRANSLATE_NOOP("Property", "Carried by");
  property.choices = {QT_TRANSLATE_NOOP("Property", "nothing")};
  for (const Link& link : robot.links) property.choices.push_back(link.name);
  const std::uint32_t link = carrierOf(body, robot);
  property.value = link == kNone ? 0.0 : 1.0 + link;
  property.least = 0.0;
  property.largest = static_cast<double>(robot.links.size());
  return property;
}

}  // namespace handwheel
