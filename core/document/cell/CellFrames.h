// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "robot/RobotModel.h"
#include "robot/program/RobotPath.h"
#include "scene/BodySet.h"

#include <span>

namespace handwheel {

inline constexpr double kShownFrameAxis = 80.0;  // mm of each axis of a named frame that is shown

// Where the frames and targets of a cell are. All poses are in the frame of the root, unless it is said.

// What that depends on.
struct CellPlacement {
  const CellPlans& plans;
  const BodySet& bodies;
  const RobotModel& robot;
  const JointValues& joints;
};

// The pose of a frame, and of the one with this name; of an empty name that of the root. Errors: FrameMissing {name};
// FrameStray where what carries it is missing.
Result<Pose> poseOfFrame(const NamedFrame& frame, const CellPlacement& cell);
Result<Pose> poseOfFrame(std::string_view name, const CellPlacement& cell);

// Whether a frame moves with one of these degrees of freedom.
bool movesWith(const NamedFrame& frame, const BodySet& bodies, const RobotModel& robot,
               std::span<const std::uint32_t> dofs);

// The frame where it is, carried by this body or link, or with neither by nothing. Errors: FrameStray; ReferenceMissing
// {"the body", number}, {"the link", name}; ValueOutOfRange of the new pose.
Result<NamedFrame> carriedFrame(NamedFrame frame, std::uint32_t body, const std::string& link,
                                const CellPlacement& cell);

// The frame at another pose, carried by what carries it; by nothing, where that is missing.
NamedFrame frameAt(NamedFrame frame, const Pose& pose, const CellPlacement& cell);

// The pose of a target. Errors: TargetStray {target}, those of poseOfFrame().
Result<Pose> poseOfTarget(const NamedTarget& target, const CellPlacement& cell);

// The target at another pose, on what it is on; on nothing, where that is missing.
NamedTarget targetAt(NamedTarget target, const Pose& pose, const CellPlacement& cell);

// A target at a pose in the frame of the root, on this body from now on.
NamedTarget onBody(NamedTarget target, const Body& body, const RobotModel& robot, const JointValues& joints);

// The target where it is, belonging to this frame from now on; an empty name: to none. Errors: those of poseOfTarget()
// and poseOfFrame().
Result<NamedTarget> targetInFrame(NamedTarget target, const std::string& frame, const CellPlacement& cell);

// The pose of a target as it is shown: in CellPlans::workFrame; without that, or where it is not known, in what the
// target is on.
Pose shownPose(const NamedTarget& target, const CellPlacement& cell);
// The name of the frame or body that this pose is in; empty: it is in the frame of the root.
std::string shownIn(const NamedTarget& target, const CellPlacement& cell);
// The target at another pose, in the same frame as that.
NamedTarget targetShownAt(NamedTarget target, const Pose& shown, const CellPlacement& cell);

// The plans with another name for a frame, which must be free, or without one of their frames. Its targets stay where
// they are: on the body that carried the frame, or else on nothing.
CellPlans withFrameRenamed(CellPlans plans, const std::string& name, const std::string& wanted);
CellPlans withoutFrame(const std::string& name, const CellPlacement& cell);

// The plans with another name for a target, which must be free, also of the places of paths that were planned to it; or
// without one of their targets: then these places are given by their joint values alone.
CellPlans withTargetRenamed(CellPlans plans, const std::string& name, const std::string& wanted);
CellPlans withoutTarget(CellPlans plans, const std::string& name);

}  // namespace handwheel
