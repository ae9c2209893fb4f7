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

// Returns the link that carries a body; kNone if nothing carries it, or a link that the robot does not have: the body
// does not move.
std::uint32_t carrierOf(const Body& body, const RobotModel& robot);

// Returns the pose of the link that carries a body, in the frame of the robot's base. linkPoses: of all links, in that
// frame.
Pose carrierPose(const Body& body, const RobotModel& robot, std::span<const Pose> linkPoses);

// Returns the bodies with their poses in the frame of the robot's base. The same set if no body is carried.
BodySet inFrameOfBase(const BodySet& bodies, const RobotModel& robot, const JointValues& joints);

// Makes an edit after which a link (kNone: nothing) carries the bodies, whose poses at these joint values do not
// change. Null if it carries them already. Errors: ReferenceMissing {"the body", number}; ValueOutOfRange of a new
// pose.
Result<std::unique_ptr<Edit>> carryEdit(const BodySet& bodies, const std::set<BodyId>& ids, std::uint32_t link,
                                        const RobotModel& robot, const JointValues& joints);

// Makes an edit that mounts a body on a link: its origin and axes become those of the link. Null if it is mounted there
// already. Errors: as above.
Result<std::unique_ptr<Edit>> mountEdit(const BodySet& bodies, BodyId id, std::uint32_t link, const RobotModel& robot);

// Returns the property "body.NUMBER.carrier": the link that carries the body, where the first choice is no link.
Property carrierProperty(const Body& body, const RobotModel& robot);

}  // namespace handwheel
