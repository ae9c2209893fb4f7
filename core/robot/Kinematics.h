// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/RobotModel.h"

namespace handwheel {

// Where a joint stands; rad, mm.
double jointPosition(const Joint& joint, const JointValues& values);

// The pose of every link in the frame of the root. O(joints).
std::vector<Pose> linkPoses(const RobotModel& robot, const JointValues& values);

// How a point that is fixed to a link moves with the degrees of freedom: rows 0–2 its velocity (mm/rad, mm/mm), rows
// 3–5 the link's angular velocity (rad/rad, rad/mm), all in the frame of the root (He 2008, equations 6-6 and 6-7).
// poses: of all links; point: in the frame of the root. O(joints of the chain).
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;
Jacobian jacobian(const RobotModel& robot, const std::vector<Pose>& poses, std::uint32_t link, const Vec3& point);

}  // namespace handwheel
