// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/PathBlends.h"

#include "robot/arm/NumericalIk.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// The part of a motion that is within a zone, starting at the waypoint.
struct ZoneSide {
  ArmValues spread;  // Change of each joint from the waypoint
  ArmValues end;     // Values at the end of the zone
};

// stretch: the joint values starting at the waypoint. Controllers give a zone half of a motion at most.
ZoneSide sideOf(const CellScene& scene, const Pose& tool, std::span<const ArmValues> stretch, double radius) {
  constexpr int kParts = 64;
  const auto toolAt = [&](const ArmValues& values) { return Vec3((scene.arm.tipPose(values) * tool).translation()); };
  // Position of each value along the motion: by the path of the tool, or, if it does not move, by index.
  std::vector<double> along{0.0};
  for (std::size_t i = 1; i < stretch.size(); ++i)
    along.push_back(along.back() + (toolAt(stretch[i]) - toolAt(stretch[i - 1])).norm() + 1e-9);
  const auto valuesAt = [&](double share) {
    const double wanted = share * along.back();
    const auto after = std::upper_bound(along.begin() + 1, along.end() - 1, wanted);
    const auto i = static_cast<std::size_t>(after - along.begin());
    return ArmValues(stretch[i - 1] +
                     (wanted - along[i - 1]) / (along[i] - along[i - 1]) * (stretch[i] - stretch[i - 1]));
  };
  const Vec3 centre = toolAt(stretch[0]);
  const auto isOutside = [&](double share) { return (toolAt(valuesAt(share)) - centre).norm() > radius; };
  constexpr double kMost = 0.5;
  double end = kMost;
  for (int k = 1; k <= kParts; ++k) {
    if (!isOutside(kMost * k / kParts)) continue;
    double inside = kMost * (k - 1) / kParts;
    end = kMost * k / kParts;
    for (int halving = 0; halving < 10; ++halving)
      (isOutside(0.5 * (inside + end)) ? end : inside) = 0.5 * (inside + end);
    break;
  }
  // Up to the first share that is outside, so that the zone ends before.
  ZoneSide side{ArmValues::Zero(stretch[0].size()), valuesAt(end)};
  for (int k = 1; k <= kParts; ++k)
    side.spread = side.spread.cwiseMax((valuesAt(end * k / kParts) - stretch[0]).cwiseAbs());
  return side;
}

Pose halfway(const Pose& a, const Pose& b) {
  Pose pose(Eigen::Translation3d(0.5 * (a.translation() + b.translation())));
  pose.linear() = Eigen::Quaterniond(a.linear()).slerp(0.5, Eigen::Quaterniond(b.linear())).toRotationMatrix();
  return pose;
}

// Returns true if the arm is within the spread while the tool cuts the corner: midway between both ends of the zone,
// and between these and the waypoint.
bool coversCorner(const CellScene& scene, const ArmValues& at, const ArmValues& in, const ArmValues& out,
                  const ArmValues& spread) {
  const Pose middle = scene.arm.tipPose(at), before = scene.arm.tipPose(in), after = scene.arm.tipPose(out);
  const Pose across = halfway(before, after);
  NumericalIkSettings ik;
  ik.mostStarts = 1;
  ik.tolerance = 1e-7;
  for (const Pose& pose : {across, halfway(middle, across), halfway(before, across), halfway(across, after)}) {
    const NumericalIkResult found = solvedNumerically(scene.arm, pose, at, ik);
    constexpr double kMostOff = 1e-3;  // mm, rad
    if (found.distance > kMostOff || found.angle > kMostOff) return false;
    if (((found.values - at).cwiseAbs().array() > spread.array()).any()) return false;
  }
  return true;
}

}  // namespace

std::vector<double> certifiedBlends(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                                    const ResolvedPath& resolvedPath, double clearance, const Progress& progress) {
  std::vector<double> blends(path.waypoints.size(), 0.0);
  if (resolvedPath.stopsAt) return blends;
  // Index in joints of the first value of each waypoint.
  std::vector<std::size_t> valueOf(path.waypoints.size(), 0);
  for (std::size_t i = 0; i < resolvedPath.waypointOf.size(); ++i) valueOf[resolvedPath.waypointOf[i]] = i + 1;
  for (std::size_t i = 1; i + 1 < path.waypoints.size() && !progress.cancelled(); ++i) {
    const Waypoint &waypoint = path.waypoints[i], &next = path.waypoints[i + 1];
    if (waypoint.blend <= 0.0) continue;
    const bool hasLine = waypoint.motion == ProgramMotion::Kind::Linear || next.motion == ProgramMotion::Kind::Linear;
    JointPath before(resolvedPath.joints.begin() + static_cast<std::ptrdiff_t>(valueOf[i - 1]),
                     resolvedPath.joints.begin() + static_cast<std::ptrdiff_t>(valueOf[i]) + 1);
    std::reverse(before.begin(), before.end());
    const std::span<const ArmValues> after(resolvedPath.joints.data() + valueOf[i], valueOf[i + 1] - valueOf[i] + 1);
    const ArmValues& at = before.front();
    for (double radius = waypoint.blend; radius > 0.05 * waypoint.blend; radius *= 0.7) {
      const ZoneSide in = sideOf(scene, plans.tool, before, radius), out = sideOf(scene, plans.tool, after, radius);
      constexpr double kRounding = 1e-6;  // rad, mm: of joints that stand still, as inverse kinematics finds them
      const ArmValues spread = ((hasLine ? 1.5 : 1.0) * (in.spread + out.spread)).array() + kRounding;
      if (!scene.scene.isFreeAround(at, spread, clearance, 0.0)) continue;
      if (hasLine && !coversCorner(scene, at, in.end, out.end, spread)) continue;
      blends[i] = radius;
      break;
    }
  }
  return blends;
}

}  // namespace handwheel
