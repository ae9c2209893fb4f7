// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "robot/RobotModel.h"
#include "robot/program/RobotPath.h"
#include "scene/BodySet.h"

#include <span>

namespace handwheel {

inline constexpr double kShownFrameAxis = 80.0;  // Displayed length of each axis of a named frame, mm

// Poses of the frames and targets of a cell. They are in the frame of the root unless stated otherwise.

// The parts of a cell that the poses of its frames and targets depend on.
struct CellPlacement {
  const CellPlans& plans;
  const BodySet& bodies;
  const RobotModel& robot;
  const JointValues& joints;
};

// Return the pose of a frame, which is given itself or by its name. An empty name denotes the root. Errors:
// FrameMissing {name}; FrameStray if the body or link that carries the frame is missing.
Result<Pose> poseOfFrame(const NamedFrame& frame, const CellPlacement& cell);
Result<Pose> poseOfFrame(std::string_view name, const CellPlacement& cell);

// Returns true if a frame moves with one of these degrees of freedom.
bool movesWith(const NamedFrame& frame, const BodySet& bodies, const RobotModel& robot,
               std::span<const std::uint32_t> dofs);

// Returns the frame at its present pose with another carrier: this body, or else this link, or nothing. body: 0 for no
// body. link: empty for no link. Errors: FrameStray; ReferenceMissing {"the body", number}, {"the link", name};
// ValueOutOfRange of the new pose.
Result<NamedFrame> carriedFrame(NamedFrame frame, std::uint32_t body, const std::string& link,
                                const CellPlacement& cell);

// Returns the frame at another pose. It keeps its carrier, unless the carrier is missing.
NamedFrame frameAt(NamedFrame frame, const Pose& pose, const CellPlacement& cell);

// Returns the pose of a target. Errors: TargetStray {target}, the errors of poseOfFrame().
Result<Pose> poseOfTarget(const NamedTarget& target, const CellPlacement& cell);

// Returns the target at another pose. It stays in the same frame or on the same body, unless that is missing.
NamedTarget targetAt(NamedTarget target, const Pose& pose, const CellPlacement& cell);

// Returns a target, whose pose is given in the frame of the root, attached to this body.
NamedTarget onBody(NamedTarget target, const Body& body, const RobotModel& robot, const JointValues& joints);

// Returns the target at its present pose, but belonging to this frame; empty: to no frame. Errors: the errors of
// poseOfTarget() and poseOfFrame(), ValueOutOfRange of the new pose.
Result<NamedTarget> targetInFrame(NamedTarget target, const std::string& frame, const CellPlacement& cell);

// Returns the pose of a target for display: relative to CellPlans::workFrame if that is set and known, or else relative
// to the frame or body of the target.
Pose shownPose(const NamedTarget& target, const CellPlacement& cell);
// Returns the name of the frame or body that shownPose() is relative to; the result is empty for the frame of the root.
std::string shownIn(const NamedTarget& target, const CellPlacement& cell);
// Returns the target at another pose. shown: the pose, relative to the same frame as shownPose().
NamedTarget targetShownAt(NamedTarget target, const Pose& shown, const CellPlacement& cell);

// Return the plans with a frame renamed, or without a frame. wanted: the new name, which must be free. The poses of
// targets do not change: without their frame, they belong to the body that carried the frame, or to nothing.
CellPlans withFrameRenamed(CellPlans plans, const std::string& name, const std::string& wanted);
CellPlans withoutFrame(const std::string& name, const CellPlacement& cell);

// Return the plans with a target renamed, or without a target. wanted: the new name, which must be free. Waypoints that
// were planned to the target get the new name, or keep only their joint values.
CellPlans withTargetRenamed(CellPlans plans, const std::string& name, const std::string& wanted);
CellPlans withoutTarget(CellPlans plans, const std::string& name);

}  // namespace handwheel
