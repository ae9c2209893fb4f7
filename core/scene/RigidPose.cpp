// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/RigidPose.h"

#include <Eigen/SVD>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kOrthonormal = 1e-9;     // Rounding error of each dot product
constexpr double kLargestScaling = 1e-3;  // Scaling of a rotation in few digits
constexpr double kGimbalLock = 1e-9;      // cosine of the pitch

bool isWithinReach(const Pose& pose) {
  return pose.matrix().allFinite() && pose.translation().cwiseAbs().maxCoeff() <= kFarthestBody;
}

}  // namespace

bool isRigid(const Pose& pose) {
  if (!isWithinReach(pose)) return false;
  const Eigen::Matrix3d rotation = pose.linear();
  const Eigen::Matrix3d difference = rotation.transpose() * rotation - Eigen::Matrix3d::Identity();
  return difference.cwiseAbs().maxCoeff() <= kOrthonormal && rotation.determinant() > 0.0;
}

std::optional<Pose> nearestRigid(const Pose& pose) {
  if (!isWithinReach(pose)) return std::nullopt;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(pose.linear(), Eigen::ComputeFullU | Eigen::ComputeFullV);
  const bool isNear = (svd.singularValues().array() - 1.0).abs().maxCoeff() <= kLargestScaling;
  const Eigen::Matrix3d rotation = svd.matrixU() * svd.matrixV().transpose();
  if (!isNear || rotation.determinant() < 0.0) return std::nullopt;
  Pose rigid = Pose::Identity();
  rigid.linear() = rotation;
  rigid.translation() = pose.translation();
  return rigid;
}

Vec3 rollPitchYaw(const Pose& pose) {
  const Eigen::Matrix3d r = pose.linear();
  const double cosine = std::hypot(r(0, 0), r(1, 0));
  const double pitch = std::atan2(0.0 - r(2, 0), cosine);  // 0.0: no negative zero
  if (cosine < kGimbalLock) return {std::atan2(0.0 - r(1, 2), r(1, 1)), pitch, 0.0};
  return {std::atan2(r(2, 1), r(2, 2)), pitch, std::atan2(r(1, 0), r(0, 0))};
}

Pose poseOf(const Vec3& position, const Vec3& angles) {
  Pose pose = Pose::Identity();
  pose.linear() = (Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
                   Eigen::AngleAxisd(angles.x(), Vec3::UnitX()))
                      .toRotationMatrix();
  pose.translation() = position;
  return pose;
}

}  // namespace handwheel
