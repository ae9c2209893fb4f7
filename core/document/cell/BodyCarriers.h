// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Edit.h"
#include "document/Property.h"
#include "robot/RobotModel.h"
#include "scene/BodySet.h"

#include <memory>
#include <set>
#include <span>

namespace handwheel {

// Bodies that links of the robot carry: tools on its flange, parts in its gripper. They move with it.

// The link that carries a body; kNone: none, or one that the robot does not have, and the body stands still.
std::uint32_t carrierOf(const Body& body, const RobotModel& robot);

// The pose of what carries a body, in the frame of the robot's base. linkPoses: of all links there.
Pose carrierPose(const Body& body, const RobotModel& robot, std::span<const Pose> linkPoses);

// The bodies with their poses in the frame of the robot's base. The same set where nothing is carried.
BodySet inFrameOfBase(const BodySet& bodies, const RobotModel& robot, const JointValues& joints);

// Lets a link (kNone: nothing) carry bodies, which keep their places while the joints are there. Null when it does so
// already. Errors: ReferenceMissing {"the body", number}; ValueOutOfRange of a new pose.
Result<std::unique_ptr<Edit>> carryEdit(const BodySet& bodies, const std::set<BodyId>& ids, std::uint32_t link,
                                        const RobotModel& robot, const JointValues& joints);

// Mounts a body on a link: its origin and axes become those of the link. Null when it is there already. Errors: as
// above.
Result<std::unique_ptr<Edit>> mountEdit(const BodySet& bodies, BodyId id, std::uint32_t link, const RobotModel& robot);

// The property "body.NUMBER.carrier": which link carries the body, the first choice being none.
Property carrierProperty(const Body& body, const RobotModel& robot);

}  // namespace handwheel
