// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/RobotModel.h"

namespace handwheel {

// Returns the position of a joint; rad, mm.
double jointPosition(const Joint& joint, const JointValues& values);

// Computes the pose of every link in the frame of the root (forward kinematics). O(joints).
std::vector<Pose> linkPoses(const RobotModel& robot, const JointValues& values);

// A Jacobian with one column per degree of freedom. Rows 0–2: linear velocity; rows 3–5: angular velocity.
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;
// Computes the Jacobian of a point that is fixed to a link. Rows 0–2 are the velocity of the point (mm/rad, mm/mm),
// rows 3–5 the angular velocity of the link (rad/rad, rad/mm), all in the frame of the root (He 2008, equations 6-6 and
// 6-7). poses: the poses of all links. point: its position in the frame of the root. O(joints of the chain).
Jacobian jacobian(const RobotModel& robot, const std::vector<Pose>& poses, std::uint32_t link, const Vec3& point);

}  // namespace handwheel
