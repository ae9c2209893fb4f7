// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/CellFrames.h"

#include "base/NumberText.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/CellErrors.h"
#include "robot/Kinematics.h"
#include "scene/RigidPose.h"

#include <algorithm>

namespace handwheel {

namespace {

Pose bodyInRoot(const Body& body, const RobotModel& robot, const JointValues& joints) {
  return carrierPose(body, robot, linkPoses(robot, joints)) * body.pose;
}

// Returns the pose of a frame's carrier; nothing if it is missing.
std::optional<Pose> frameCarrierPose(const NamedFrame& frame, const CellPlacement& cell) {
  if (frame.body != 0) {
    const BodyPointer body = cell.bodies.withId(frame.body);
    return body ? std::optional(bodyInRoot(*body, cell.robot, cell.joints)) : std::nullopt;
  }
  if (frame.link.empty()) return Pose(Pose::Identity());
  const std::uint32_t link = linkNamed(cell.robot, frame.link);
  return link == kNone ? std::nullopt : std::optional(linkPoses(cell.robot, cell.joints)[link]);
}

// Returns the pose of the frame or body that a target belongs to.
Result<Pose> targetBasePose(const NamedTarget& target, const CellPlacement& cell) {
  if (target.body == 0) return poseOfFrame(target.frame, cell);
  const BodyPointer body = cell.bodies.withId(target.body);
  if (!body) return Error{CellError::TargetStray, {target.name}, {}, {}};
  return bodyInRoot(*body, cell.robot, cell.joints);
}

// A pose that could not be read again.
Error tooFar(const std::string& name, const Pose& pose) {
  const std::string most = shownText(kFarthestBody);
  const std::string farthest = shownText(pose.translation().cwiseAbs().maxCoeff());
  return {ErrorCode::ValueOutOfRange, {name, farthest, "-" + most, most}, {}, {}};
}

}  // namespace

Result<Pose> poseOfFrame(const NamedFrame& frame, const CellPlacement& cell) {
  const std::optional<Pose> carrier = frameCarrierPose(frame, cell);
  if (!carrier) return Error{CellError::FrameStray, {frame.name}, {}, {}};
  return Pose(*carrier * frame.pose);
}

Result<Pose> poseOfFrame(std::string_view name, const CellPlacement& cell) {
  if (name.empty()) return Pose(Pose::Identity());
  const NamedFrame* const frame = cell.plans.frame(name);
  if (!frame) return Error{CellError::FrameMissing, {std::string(name)}, {}, {}};
  return poseOfFrame(*frame, cell);
}

bool movesWith(const NamedFrame& frame, const BodySet& bodies, const RobotModel& robot,
               std::span<const std::uint32_t> dofs) {
  const BodyPointer body = frame.body == 0 ? nullptr : bodies.withId(frame.body);
  std::uint32_t link = body ? carrierOf(*body, robot) : frame.link.empty() ? kNone : linkNamed(robot, frame.link);
  while (link != kNone && robot.links[link].parentJoint != kNone) {
    const Joint& joint = robot.joints[robot.links[link].parentJoint];
    if (joint.dof != kNone && std::find(dofs.begin(), dofs.end(), joint.dof) != dofs.end()) return true;
    link = joint.parent;
  }
  return false;
}

Result<NamedFrame> carriedFrame(NamedFrame frame, std::uint32_t body, const std::string& link,
                                const CellPlacement& cell) {
  const Result<Pose> pose = poseOfFrame(frame, cell);
  if (!pose) return pose.error();
  if (body != 0 && !cell.bodies.withId(body))
    return Error{ErrorCode::ReferenceMissing, {"the body", std::to_string(body)}, {}, {}};
  if (body == 0 && !link.empty() && linkNamed(cell.robot, link) == kNone)
    return Error{ErrorCode::ReferenceMissing, {"the link", link}, {}, {}};
  frame.body = body;
  frame.link = body == 0 ? link : std::string();
  frame = frameAt(std::move(frame), *pose, cell);
  if (isRigid(frame.pose)) return frame;
  return tooFar(frame.name, frame.pose);
}

NamedFrame frameAt(NamedFrame frame, const Pose& pose, const CellPlacement& cell) {
  const std::optional<Pose> carrier = frameCarrierPose(frame, cell);
  frame.pose = carrier ? Pose(carrier->inverse(Eigen::Isometry) * pose) : pose;
  if (carrier) return frame;
  frame.body = 0;
  frame.link.clear();
  return frame;
}

Result<Pose> poseOfTarget(const NamedTarget& target, const CellPlacement& cell) {
  const Result<Pose> base = targetBasePose(target, cell);
  return base ? Result<Pose>(Pose(*base * target.pose)) : base.error();
}

NamedTarget targetAt(NamedTarget target, const Pose& pose, const CellPlacement& cell) {
  const Result<Pose> base = targetBasePose(target, cell);
  target.pose = base ? Pose(base->inverse(Eigen::Isometry) * pose) : pose;
  if (base) return target;
  target.body = 0;
  target.frame.clear();
  return target;
}

NamedTarget onBody(NamedTarget target, const Body& body, const RobotModel& robot, const JointValues& joints) {
  target.pose = bodyInRoot(body, robot, joints).inverse(Eigen::Isometry) * target.pose;
  target.body = body.id;
  target.frame.clear();
  return target;
}

Result<NamedTarget> targetInFrame(NamedTarget target, const std::string& frame, const CellPlacement& cell) {
  const Result<Pose> pose = poseOfTarget(target, cell), base = poseOfFrame(frame, cell);
  if (!pose || !base) return pose ? base.error() : pose.error();
  target.body = 0;
  target.frame = frame;
  target.pose = base->inverse(Eigen::Isometry) * *pose;
  if (isRigid(target.pose)) return target;
  return tooFar(target.name, target.pose);
}

Pose shownPose(const NamedTarget& target, const CellPlacement& cell) {
  if (cell.plans.workFrame.empty() || cell.plans.workFrame == target.frame) return target.pose;
  const Result<Pose> pose = poseOfTarget(target, cell), work = poseOfFrame(cell.plans.workFrame, cell);
  return pose && work ? Pose(work->inverse(Eigen::Isometry) * *pose) : target.pose;
}

std::string shownIn(const NamedTarget& target, const CellPlacement& cell) {
  const std::string& work = cell.plans.workFrame;
  const bool isInWork = !work.empty() && poseOfTarget(target, cell) && poseOfFrame(work, cell);
  if (isInWork || work == target.frame) {
    if (!work.empty()) return work;
  } else if (!target.frame.empty()) {
    return target.frame;
  }
  const BodyPointer body = target.body == 0 ? nullptr : cell.bodies.withId(target.body);
  return body ? body->name : std::string();
}

NamedTarget targetShownAt(NamedTarget target, const Pose& shown, const CellPlacement& cell) {
  const bool isOwn = cell.plans.workFrame.empty() || cell.plans.workFrame == target.frame;
  const Result<Pose> base = targetBasePose(target, cell), work = poseOfFrame(cell.plans.workFrame, cell);
  target.pose = isOwn || !base || !work ? shown : Pose(base->inverse(Eigen::Isometry) * *work * shown);
  return target;
}

CellPlans withFrameRenamed(CellPlans plans, const std::string& name, const std::string& wanted) {
  const auto rename = [&](std::string& each) {
    if (each == name) each = wanted;
  };
  for (NamedFrame& frame : plans.frames) rename(frame.name);
  for (NamedTarget& target : plans.targets) rename(target.frame);
  for (RobotPath& path : plans.paths) {
    for (Waypoint& waypoint : path.waypoints) {
      if (waypoint.frame) rename(waypoint.frame->name);
    }
  }
  rename(plans.workFrame);
  return plans;
}

CellPlans withoutFrame(const std::string& name, const CellPlacement& cell) {
  CellPlans plans = cell.plans;
  const NamedFrame* const frame = cell.plans.frame(name);
  if (!frame) return plans;
  // In what the targets are from now on: the body, also one that is missing, or the root.
  const Result<Pose> pose = frame->body == 0 ? poseOfFrame(*frame, cell) : Result<Pose>(frame->pose);
  for (NamedTarget& target : plans.targets) {
    if (target.frame != name) continue;
    target.frame.clear();
    target.body = frame->body;
    target.pose = (pose ? *pose : frame->pose) * target.pose;
  }
  std::erase_if(plans.frames, [&](const NamedFrame& each) { return each.name == name; });
  if (plans.workFrame == name) plans.workFrame.clear();
  for (RobotPath& path : plans.paths) {
    for (Waypoint& waypoint : path.waypoints) {
      if (waypoint.frame && waypoint.frame->name == name) waypoint.frame.reset();
    }
  }
  return plans;
}

CellPlans withTargetRenamed(CellPlans plans, const std::string& name, const std::string& wanted) {
  for (NamedTarget& target : plans.targets) {
    if (target.name == name) target.name = wanted;
  }
  for (RobotPath& path : plans.paths) {
    for (Waypoint& waypoint : path.waypoints) {
      if (!waypoint.target || waypoint.target->name != name) continue;
      waypoint.target->name = wanted;
      if (waypoint.name == name) waypoint.name = wanted;
    }
  }
  return plans;
}

CellPlans withoutTarget(CellPlans plans, const std::string& name) {
  std::erase_if(plans.targets, [&](const NamedTarget& each) { return each.name == name; });
  for (RobotPath& path : plans.paths) {
    for (Waypoint& waypoint : path.waypoints) {
      if (waypoint.target && waypoint.target->name == name) waypoint.target.reset();
    }
  }
  return plans;
}

}  // namespace handwheel
