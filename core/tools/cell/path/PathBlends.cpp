// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/PathBlends.h"

#include "robot/arm/NumericalIk.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// The part of a motion that is within a zone, from the place on.
struct ZoneSide {
  ArmValues spread;  // how far each joint gets from where it is at the place
  ArmValues end;     // where the motion leaves the zone
};

// way: the joint values from the place on. Controllers give a zone half of a motion at most.
ZoneSide sideOf(const CellScene& scene, const Pose& tool, std::span<const ArmValues> way, double radius) {
  constexpr int kParts = 64;
  const auto toolAt = [&](const ArmValues& values) { return Vec3((scene.arm.tipPose(values) * tool).translation()); };
  // How far along the motion each value is: by the way of the tool, or, where that stands still, by their number.
  std::vector<double> along{0.0};
  for (std::size_t i = 1; i < way.size(); ++i)
    along.push_back(along.back() + (toolAt(way[i]) - toolAt(way[i - 1])).norm() + 1e-9);
  const auto valuesAt = [&](double share) {
    const double wanted = share * along.back();
    const auto after = std::upper_bound(along.begin() + 1, along.end() - 1, wanted);
    const auto i = static_cast<std::size_t>(after - along.begin());
    return ArmValues(way[i - 1] + (wanted - along[i - 1]) / (along[i] - along[i - 1]) * (way[i] - way[i - 1]));
  };
  const Vec3 place = toolAt(way[0]);
  const auto isOutside = [&](double share) { return (toolAt(valuesAt(share)) - place).norm() > radius; };
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
  ZoneSide side{ArmValues::Zero(way[0].size()), valuesAt(end)};
  for (int k = 1; k <= kParts; ++k)
    side.spread = side.spread.cwiseMax((valuesAt(end * k / kParts) - way[0]).cwiseAbs());
  return side;
}

Pose halfway(const Pose& a, const Pose& b) {
  Pose pose(Eigen::Translation3d(0.5 * (a.translation() + b.translation())));
  pose.linear() = Eigen::Quaterniond(a.linear()).slerp(0.5, Eigen::Quaterniond(b.linear())).toRotationMatrix();
  return pose;
}

// Whether the arm is within the spread where the tool cuts the corner: half way between both ends of the zone, and
// between these and the place.
bool coversCorner(const CellScene& scene, const ArmValues& at, const ArmValues& in, const ArmValues& out,
                  const ArmValues& spread) {
  const Pose place = scene.arm.tipPose(at), before = scene.arm.tipPose(in), after = scene.arm.tipPose(out);
  const Pose across = halfway(before, after);
  NumericalIkSettings ik;
  ik.mostStarts = 1;
  ik.tolerance = 1e-7;
  for (const Pose& pose : {across, halfway(place, across), halfway(before, across), halfway(across, after)}) {
    const NumericalIkResult found = solvedNumerically(scene.arm, pose, at, ik);
    constexpr double kMostOff = 1e-3;  // mm, rad
    if (found.distance > kMostOff || found.angle > kMostOff) return false;
    if (((found.values - at).cwiseAbs().array() > spread.array()).any()) return false;
  }
  return true;
}

}  // namespace

std::vector<double> certifiedBlends(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                                    const ResolvedPath& way, double clearance, const Progress& progress) {
  std::vector<double> blends(path.places.size(), 0.0);
  if (way.stopsAt) return blends;
  // The first value in way.joints that is of each place.
  std::vector<std::size_t> valueOf(path.places.size(), 0);
  for (std::size_t i = 0; i < way.placeOf.size(); ++i) valueOf[way.placeOf[i]] = i + 1;
  for (std::size_t i = 1; i + 1 < path.places.size() && !progress.cancelled(); ++i) {
    const Waypoint &place = path.places[i], &next = path.places[i + 1];
    if (place.blend <= 0.0) continue;
    const bool hasLine = place.motion == ProgramMotion::Kind::Linear || next.motion == ProgramMotion::Kind::Linear;
    JointPath before(way.joints.begin() + static_cast<std::ptrdiff_t>(valueOf[i - 1]),
                     way.joints.begin() + static_cast<std::ptrdiff_t>(valueOf[i]) + 1);
    std::reverse(before.begin(), before.end());
    const std::span<const ArmValues> after(way.joints.data() + valueOf[i], valueOf[i + 1] - valueOf[i] + 1);
    const ArmValues& at = before.front();
    for (double radius = place.blend; radius > 0.05 * place.blend; radius *= 0.7) {
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
