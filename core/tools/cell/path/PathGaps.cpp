// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/PathGaps.h"

#include "robot/arm/NumericalIk.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

constexpr int kMostLooks = 4'000;     // at one corner
constexpr double kFinest = 1e-4;      // rad: triangles whose joints differ less are not divided
constexpr double kMillimetres = 1e3;  // slides: this travel counts as a radian

// Proves triangles of joint values free, each by its middle and the largest deviation of its corners.
class CornerProof {
 public:
  CornerProof(const CellScene& scene, double clearance, const Progress& progress)
      : m_scene(scene), m_clearance(clearance), m_progress(progress) {}

  // Returns true if all joint values between these three are free.
  bool isFree(const ArmValues& before, const ArmValues& at, const ArmValues& after) {
    using Triangle = std::array<ArmValues, 3>;
    std::vector<Triangle> open{{before, at, after}};
    for (int looks = 0; !open.empty(); ++looks) {
      if (looks >= kMostLooks || m_progress.cancelled()) return false;
      const Triangle triangle = std::move(open.back());
      open.pop_back();
      const ArmValues middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
      if (m_scene.scene.isFreeAround(middle, spreadOf(triangle, middle), m_clearance, 0.0)) continue;
      const std::size_t side = longestSide(triangle);
      const ArmValues &first = triangle[side], &second = triangle[(side + 1) % 3], &third = triangle[(side + 2) % 3];
      if (sizeOf(second - first) < kFinest) return false;
      const ArmValues halfway = 0.5 * (first + second);
      open.push_back({first, halfway, third});
      open.push_back({halfway, second, third});
    }
    return true;
  }

  // Returns true if the arm is free wherever its tool is in the triangle of these three poses, turned by the turns from
  // the middle one towards the others.
  bool isFreeInSpace(const Pose& tool, const ArmValues& before, const ArmValues& at, const ArmValues& after) {
    const auto poseAt = [&](const ArmValues& values) { return Pose(m_scene.arm.tipPose(values) * tool); };
    const Pose a = poseAt(before), b = poseAt(at), c = poseAt(after);
    const auto turnTo = [&](const Pose& other) {
      const Eigen::AngleAxisd turn(Eigen::Matrix3d(b.linear().transpose() * other.linear()));
      return Vec3(turn.angle() * turn.axis());
    };
    const Vec3 turnA = turnTo(a), turnC = turnTo(c);
    struct Corner {
      double toA, toC;  // shares of the ways from the middle pose
      ArmValues values;
    };
    const auto cornerAt = [&](double toA, double toC, const ArmValues& near) -> std::optional<Corner> {
      const Vec3 turn = toA * turnA + toC * turnC;
      Pose pose(Eigen::Translation3d(b.translation() + toA * (a.translation() - b.translation()) +
                                     toC * (c.translation() - b.translation())));
      pose.linear() = turn.norm() > 0.0
                          ? Eigen::Matrix3d(b.linear() * Eigen::AngleAxisd(turn.norm(), turn.normalized()))
                          : Eigen::Matrix3d(b.linear());
      NumericalIkSettings ik;
      ik.mostStarts = 1;
      ik.tolerance = 1e-7;
      const NumericalIkResult found = solvedNumerically(m_scene.arm, pose * tool.inverse(Eigen::Isometry), near, ik);
      constexpr double kReached = 1e-3;  // mm, rad
      if (found.distance > kReached || found.angle > kReached) return std::nullopt;
      return Corner{toA, toC, found.values};
    };
    using Triangle = std::array<Corner, 3>;
    std::vector<Triangle> open{{Corner{1.0, 0.0, before}, Corner{0.0, 0.0, at}, Corner{0.0, 1.0, after}}};
    for (int looks = 0; !open.empty(); ++looks) {
      if (looks >= kMostLooks || m_progress.cancelled()) return false;
      const Triangle triangle = std::move(open.back());
      open.pop_back();
      const std::array<ArmValues, 3> values{triangle[0].values, triangle[1].values, triangle[2].values};
      const ArmValues mean = (values[0] + values[1] + values[2]) / 3.0;
      const auto middle = cornerAt((triangle[0].toA + triangle[1].toA + triangle[2].toA) / 3.0,
                                   (triangle[0].toC + triangle[1].toC + triangle[2].toC) / 3.0, mean);
      if (!middle) return false;
      // Between the corners the values deviate from their plane in joint space, more so in larger triangles.
      constexpr double kCurved = 1.5, kMostBent = 0.25, kRounding = 1e-6;
      const ArmValues spread = kCurved * spreadOf(values, middle->values).array() + kRounding;
      const bool isFlat = sizeOf(middle->values - mean) <= kMostBent * sizeOf(spread);
      if (isFlat && m_scene.scene.isFreeAround(middle->values, spread, m_clearance, 0.0)) continue;
      const std::size_t side = longestSide(values);
      const Corner &first = triangle[side], &second = triangle[(side + 1) % 3], &third = triangle[(side + 2) % 3];
      if (sizeOf(second.values - first.values) < kFinest) return false;
      const auto halfway = cornerAt(0.5 * (first.toA + second.toA), 0.5 * (first.toC + second.toC),
                                    0.5 * (first.values + second.values));
      if (!halfway) return false;
      open.push_back({first, *halfway, third});
      open.push_back({*halfway, second, third});
    }
    return true;
  }

 private:
  static ArmValues spreadOf(const std::array<ArmValues, 3>& corners, const ArmValues& middle) {
    ArmValues spread = ArmValues::Zero(middle.size());
    for (const ArmValues& corner : corners) spread = spread.cwiseMax((corner - middle).cwiseAbs());
    return spread;
  }

  // Returns the largest change of a joint, rad.
  double sizeOf(const ArmValues& change) const {
    double largest = 0.0;
    for (Eigen::Index i = 0; i < change.size(); ++i)
      largest = std::max(largest, std::abs(change[i]) / (m_scene.scene.joint(i).isPrismatic ? kMillimetres : 1.0));
    return largest;
  }

  std::size_t longestSide(const std::array<ArmValues, 3>& corners) const {
    std::array<double, 3> sizes;
    for (std::size_t i = 0; i < 3; ++i) sizes[i] = sizeOf(corners[(i + 1) % 3] - corners[i]);
    return static_cast<std::size_t>(std::ranges::max_element(sizes) - sizes.begin());
  }

  const CellScene& m_scene;
  double m_clearance;
  const Progress& m_progress;
};

}  // namespace

std::vector<ProofGap> gapsOf(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                             const ResolvedPath& resolvedPath, double clearance, const Progress& progress) {
  std::vector<ProofGap> gaps;
  if (resolvedPath.stopsAt) return gaps;
  CornerProof proof(scene, clearance, progress);
  for (std::size_t i = 1; i + 1 < path.waypoints.size(); ++i) {
    const Waypoint &at = path.waypoints[i], &next = path.waypoints[i + 1];
    if (at.corner <= 0.0) continue;
    const auto isOf = [&](ProgramMotion::Kind kind) { return at.motion == kind || next.motion == kind; };
    const auto valuesAt = [&](std::size_t index) { return resolvedPath.joints[resolvedPath.valueOf[index]]; };
    const ArmValues before = valuesAt(i - 1), here = valuesAt(i), after = valuesAt(i + 1);
    const bool isFree = (!isOf(ProgramMotion::Kind::Joint) || proof.isFree(before, here, after)) &&
                        (!isOf(ProgramMotion::Kind::Linear) || proof.isFreeInSpace(plans.tool, before, here, after));
    if (!isFree) gaps.push_back({.kind = ProofGap::Kind::Corner, .waypoint = i});
  }
  for (std::size_t i = 0; i + 1 < path.waypoints.size(); ++i) {
    const ProgramLine* line = path.waypoints[i].gripping();
    if (i == 0 && !line && !path.waypoints[0].keepsCarried) {
      const auto found = std::ranges::find_if(path.head, &ProgramLine::mayGrip);
      if (found != path.head.end()) line = &*found;
    }
    if (!line) continue;
    gaps.push_back({.kind = ProofGap::Kind::Carried, .waypoint = i, .text = line->text, .line = line->line});
    break;
  }
  return gaps;
}

}  // namespace handwheel
