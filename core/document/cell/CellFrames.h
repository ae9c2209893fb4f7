// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "robot/RobotModel.h"
#include "robot/program/RobotPath.h"
#include "scene/BodySet.h"

#include <span>

namespace handwheel {

inline constexpr double kShownFrameAxis = 80.0;  // Length of each axis of a named frame as it is shown, mm

// Poses of the frames and targets of a cell. They are in the frame of the root unless stated otherwise.

// The parts of a cell that the poses of its frames and targets depend on.
struct CellPlacement {
  const CellPlans& plans;
  const BodySet& bodies;
  const RobotModel& robot;
  const JointValues& joints;
};

// Returns the pose of a frame, given itself or by name; an empty name denotes the root. Errors: FrameMissing {name};
// FrameStray if the body or link that carries it is missing.
Result<Pose> poseOfFrame(const NamedFrame& frame, const CellPlacement& cell);
Result<Pose> poseOfFrame(std::string_view name, const CellPlacement& cell);

// Returns true if a frame moves with one of these degrees of freedom.
bool movesWith(const NamedFrame& frame, const BodySet& bodies, const RobotModel& robot,
               std::span<const std::uint32_t> dofs);

// Returns the frame at its present pose, carried by this body or link from now on; by nothing if neither is given.
// Errors: FrameStray; ReferenceMissing {"the body", number}, {"the link", name}; ValueOutOfRange of the new pose.
Result<NamedFrame> carriedFrame(NamedFrame frame, std::uint32_t body, const std::string& link,
                                const CellPlacement& cell);

// Returns the frame at another pose, with the same carrier; with none if the carrier is missing.
NamedFrame frameAt(NamedFrame frame, const Pose& pose, const CellPlacement& cell);

// Returns the pose of a target. Errors: TargetStray {target}, those of poseOfFrame().
Result<Pose> poseOfTarget(const NamedTarget& target, const CellPlacement& cell);

// Returns the target at another pose, in the same frame or on the same body; on nothing if that is missing.
NamedTarget targetAt(NamedTarget target, const Pose& pose, const CellPlacement& cell);

// Returns a target, whose pose is given in the frame of the root, attached to this body.
NamedTarget onBody(NamedTarget target, const Body& body, const RobotModel& robot, const JointValues& joints);

// Returns the target at its present pose, belonging to this frame from now on; to none for an empty name. Errors: those
// of poseOfTarget() and poseOfFrame().
Result<NamedTarget> targetInFrame(NamedTarget target, const std::string& frame, const CellPlacement& cell);

// Returns the pose of a target for display: relative to CellPlans::workFrame if that is set and known, else to the
// frame or body of the target.
Pose shownPose(const NamedTarget& target, const CellPlacement& cell);
// Returns the name of the frame or body that shownPose() is relative to; empty for the frame of the root.
std::string shownIn(const NamedTarget& target, const CellPlacement& cell);
// Returns the target at another pose, given relative to the same frame as shownPose().
NamedTarget targetShownAt(NamedTarget target, const Pose& shown, const CellPlacement& cell);

// Return the plans with another name for a frame, which must be free, or without one of their frames. The poses of its
// targets do not change: they then belong to the body that carried the frame, or to nothing.
CellPlans withFrameRenamed(CellPlans plans, const std::string& name, const std::string& wanted);
CellPlans withoutFrame(const std::string& name, const CellPlacement& cell);

// Return the plans with another name for a target, which must be free, or without one of their targets. Waypoints that
// were planned to it follow the new name, or keep only their joint values.
CellPlans withTargetRenamed(CellPlans plans, const std::string& name, const std::string& wanted);
CellPlans withoutTarget(CellPlans plans, const std::string& name);

}  // namespace handwheel
