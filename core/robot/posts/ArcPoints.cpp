// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/ArcPoints.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kLeastDistance = 0.1;  // mm between two of the three positions
constexpr double kLeastSine = 1e-3;     // sine of the angle between the directions to the others
constexpr std::size_t kMostParts = 10'000;

}  // namespace

std::optional<ArcPoints> pointsOfArc(const Pose& from, const Vec3& through, const Pose& to, double deviation) {
  const Vec3 start = from.translation(), a = through - start, b = to.translation() - start;
  const Vec3 normal = a.cross(b);
  const bool isApart = a.norm() >= kLeastDistance && b.norm() >= kLeastDistance && (a - b).norm() >= kLeastDistance;
  if (!isApart || normal.norm() < kLeastSine * a.norm() * b.norm()) return std::nullopt;
  // The centre is equally far from the three positions, in their plane.
  const Vec3 toCentre =
      (a.squaredNorm() * b.cross(normal) + b.squaredNorm() * normal.cross(a)) / (2.0 * normal.squaredNorm());
  const Vec3 centre = start + toCentre, axis = normal.normalized(), radial = -toCentre;
  const double radius = radial.norm();
  const auto angleOf = [&](const Vec3& position) {
    const Vec3 at = position - centre;
    const double angle = std::atan2(axis.dot(radial.cross(at)), radial.dot(at));
    return angle < 0.0 ? angle + 2.0 * M_PI : angle;
  };
  // The axis is that of the turn from the start over the middle to the end, so the angles rise along the arc.
  ArcPoints arc;
  arc.angle = angleOf(to.translation());
  const double step = 2.0 * std::acos(std::clamp(1.0 - deviation / radius, -1.0, 1.0));
  const auto parts = static_cast<std::size_t>(
      std::clamp(std::ceil(arc.angle / std::max(step, 1e-9)), 2.0, static_cast<double>(kMostParts)));
  arc.chord = 2.0 * radius * std::sin(0.5 * arc.angle / static_cast<double>(parts));
  Eigen::AngleAxisd relative(Eigen::Matrix3d(from.linear().transpose() *
                                             Eigen::AngleAxisd(-arc.angle, axis).toRotationMatrix() * to.linear()));
  // After half a turn both directions are as short. The tool then turns against the path, as on shorter arcs.
  constexpr double kSameAngle = 1e-6;  // rad
  if (relative.angle() > M_PI - kSameAngle && axis.dot(from.linear() * relative.axis()) > 0.0)
    relative = Eigen::AngleAxisd(relative.angle() - 2.0 * M_PI, relative.axis());
  const auto poseAt = [&](double share) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(share * arc.angle, axis).toRotationMatrix();
    Pose pose(Eigen::Translation3d(centre + turn * radial));
    pose.linear() =
        turn * from.linear() * Eigen::AngleAxisd(share * relative.angle(), relative.axis()).toRotationMatrix();
    return pose;
  };
  arc.turn = 2.0 * Eigen::AngleAxisd(Eigen::Matrix3d(from.linear().transpose() * poseAt(0.5).linear())).angle();
  for (std::size_t i = 1; i < parts; ++i)
    arc.poses.push_back(poseAt(static_cast<double>(i) / static_cast<double>(parts)));
  arc.poses.push_back(to);
  return arc;
}

}  // namespace handwheel
