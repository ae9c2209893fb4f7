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

// Bodies that links of the robot carry. Examples are a tool on its flange and parts in its gripper. The bodies move
// with their links.

// Returns the link that carries a body. The result is kNone if nothing carries the body, or a link that the robot does
// not have; such a body does not move.
std::uint32_t carrierOf(const Body& body, const RobotModel& robot);

// Returns the pose of the link that carries a body, in the frame of the robot's base. linkPoses: the poses of all
// links, in that frame.
Pose carrierPose(const Body& body, const RobotModel& robot, std::span<const Pose> linkPoses);

// Returns the bodies with their poses in the frame of the robot's base. The result is the same set if no body is
// carried.
BodySet inFrameOfBase(const BodySet& bodies, const RobotModel& robot, const JointValues& joints);

// Makes an edit after which a link carries the bodies, or nothing for kNone. The poses of the bodies at these joint
// values do not change. Returns null if the link already carries the bodies. Errors: ReferenceMissing {"the body",
// number}; ValueOutOfRange of a new pose.
Result<std::unique_ptr<Edit>> carryEdit(const BodySet& bodies, const std::set<BodyId>& ids, std::uint32_t link,
                                        const RobotModel& robot, const JointValues& joints);

// Makes an edit that mounts a body on a link: the origin and the axes of the body become those of the link. Returns
// null if the body is already mounted so. Errors: ReferenceMissing {"the body", number}.
Result<std::unique_ptr<Edit>> mountEdit(const BodySet& bodies, BodyId id, std::uint32_t link, const RobotModel& robot);

// Returns the property "body.NUMBER.carrier", the link that carries the body. The first choice is no link.
Property carrierProperty(const Body& body, const RobotModel& robot);

}  // namespace handwheel
