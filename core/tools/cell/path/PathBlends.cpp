// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/PathBlends.h"

#include "planning/CartesianLine.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// The way from a waypoint along one of its motions.
class ZoneSide {
 public:
  // stretch: the joint values starting at the waypoint.
  ZoneSide(const CellScene& scene, const Pose& tool, std::span<const ArmValues> stretch)
      : m_scene(scene), m_tool(tool), m_stretch(stretch) {
    for (std::size_t i = 1; i < stretch.size(); ++i) {
      constexpr int kParts = 16;
      Vec3 before = toolAt(stretch[i - 1]);
      double length = 1e-9;  // if the tool does not move, the index counts
      for (int k = 1; k <= kParts; ++k) {
        const Vec3 now = toolAt(stretch[i - 1] + static_cast<double>(k) / kParts * (stretch[i] - stretch[i - 1]));
        length += (now - before).norm();
        before = now;
      }
      m_along.push_back(m_along.back() + length);
    }
    for (int k = 1; k <= kSteps; ++k) m_reach.push_back(std::max(m_reach.back(), distanceAt(0.5 * k / kSteps)));
  }

  // Returns the largest distance of the tool from the waypoint in the first half of the way, mm.
  double reach() const { return m_reach.back(); }

  // Returns the share of the way at which the tool leaves the ball of a radius about the waypoint, as controllers see
  // zones; at most a half.
  double shareOf(double radius) const {
    const auto beyond = std::lower_bound(m_reach.begin() + 1, m_reach.end(), radius);
    if (beyond == m_reach.end()) return 0.5;
    double within = 0.5 * static_cast<double>(beyond - m_reach.begin() - 1) / kSteps, out = within + 0.5 / kSteps;
    constexpr int kHalvings = 12;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (within + out);
      (distanceAt(middle) < radius ? within : out) = middle;
    }
    return out;
  }

  double length() const { return m_along.back(); }  // mm, of the tool's way

  // Returns the values at a share of the way of the tool.
  ArmValues valuesAt(double share) const {
    const double wanted = share * length();
    const auto after = std::upper_bound(m_along.begin() + 1, m_along.end() - 1, wanted);
    const auto i = static_cast<std::size_t>(after - m_along.begin());
    return m_stretch[i - 1] +
           (wanted - m_along[i - 1]) / (m_along[i] - m_along[i - 1]) * (m_stretch[i] - m_stretch[i - 1]);
  }

  // Returns the largest change of each joint from the waypoint up to a share of the way.
  ArmValues spreadTo(double share) const {
    constexpr int kParts = 16;
    ArmValues spread = ArmValues::Zero(m_stretch[0].size());
    for (int k = 1; k <= kParts; ++k)
      spread = spread.cwiseMax((valuesAt(share * k / kParts) - m_stretch[0]).cwiseAbs());
    return spread;
  }

 private:
  static constexpr int kSteps = 16;  // samples in the first half

  Vec3 toolAt(const ArmValues& values) const { return (m_scene.arm.tipPose(values) * m_tool).translation(); }
  double distanceAt(double share) const { return (toolAt(valuesAt(share)) - toolAt(m_stretch[0])).norm(); }

  const CellScene& m_scene;
  const Pose& m_tool;
  std::span<const ArmValues> m_stretch;
  std::vector<double> m_along{0.0};  // mm
  std::vector<double> m_reach{0.0};  // mm, up to each step
};

// The proof of the triangle between a waypoint and the ends of its zone, in joint space or, if the tool goes along a
// line, in space: rows across it are proven free with as much room as lies between them.
class ZoneProof {
 public:
  ZoneProof(const CellScene& scene, const Pose& tool, bool hasLine, double clearance)
      : m_scene(scene), m_tool(tool), m_hasLine(hasLine) {
    m_check.clearance = clearance;
  }

  bool isFree(const ZoneSide& in, const ZoneSide& out, double shareIn, double shareOut,
              const Progress& progress) const {
    // In joint space the lines of the tool are curved.
    const ArmValues spread =
        (m_hasLine ? 1.5 : 1.0) * in.spreadTo(shareIn).cwiseMax(out.spreadTo(shareOut)).array() + kRounding;
    constexpr int kMostRows = 16;
    for (int rows = 1; rows <= kMostRows && !progress.cancelled(); rows *= 2) {
      bool isFree = true;
      for (int row = rows; row >= 1 && isFree; --row) {
        const double share = (row - 0.5) / rows;
        isFree =
            isRowFree(in.valuesAt(share * shareIn), out.valuesAt(share * shareOut), spread / (2.0 * rows), progress);
      }
      if (isFree) return true;
      if (!m_mayHelp) return false;
    }
    return false;
  }

 private:
  static constexpr double kRounding = 1e-6;  // rad, mm: of joints that stand still, as inverse kinematics finds them

  bool isRowFree(const ArmValues& from, const ArmValues& to, const ArmValues& spread, const Progress& progress) const {
    m_mayHelp = true;
    if (!m_hasLine) return isMotionFree(from, to, spread, progress);
    const FollowedLine row = followLine(m_scene.arm, m_tool, from, to, {}, progress);
    m_mayHelp = row.reached >= 1.0;
    if (!m_mayHelp) return false;
    for (std::size_t i = 1; i < row.path.size(); ++i) {
      const ArmValues off = spread + row.offs[i - 1];
      if (!isMotionFree(row.path[i - 1], row.path[i], off, progress)) return false;
    }
    return true;
  }

  // More rows help where the motion itself is free.
  bool isMotionFree(const ArmValues& from, const ArmValues& to, const ArmValues& spread,
                    const Progress& progress) const {
    const double off = m_scene.scene.travelBound(from, to, spread);
    if (MotionCheck(m_scene.scene, from, to, widened(m_check, off)).run(progress) == MotionCheck::State::Free)
      return true;
    m_mayHelp = isFreeAt(m_scene.scene, 0.5 * (from + to), m_check);
    return false;
  }

  const CellScene& m_scene;
  const Pose& m_tool;
  bool m_hasLine;
  MotionCheckSettings m_check;
  mutable bool m_mayHelp = true;  // more rows may prove what one row did not
};

}  // namespace

std::vector<double> certifiedBlends(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                                    const ResolvedPath& resolvedPath, double clearance, const Progress& progress,
                                    std::vector<std::size_t>* reduced) {
  std::vector<double> blends(path.waypoints.size(), 0.0);
  if (resolvedPath.stopsAt) return blends;
  const std::vector<std::size_t>& valueOf = resolvedPath.valueOf;
  for (std::size_t i = 1; i + 1 < path.waypoints.size() && !progress.cancelled(); ++i) {
    const Waypoint &waypoint = path.waypoints[i], &next = path.waypoints[i + 1];
    if (waypoint.blend <= 0.0) continue;
    const bool hasLine = waypoint.motion == ProgramMotion::Kind::Linear || next.motion == ProgramMotion::Kind::Linear;
    JointPath before(resolvedPath.joints.begin() + static_cast<std::ptrdiff_t>(valueOf[i - 1]),
                     resolvedPath.joints.begin() + static_cast<std::ptrdiff_t>(valueOf[i]) + 1);
    std::reverse(before.begin(), before.end());
    const std::span<const ArmValues> after(resolvedPath.joints.data() + valueOf[i], valueOf[i + 1] - valueOf[i] + 1);
    const ZoneSide in(scene, plans.tool, before), out(scene, plans.tool, after);
    const ZoneProof proof(scene, plans.tool, hasLine, clearance);
    // Controllers give a zone half of a motion at most.
    const double wanted = std::min({waypoint.blend, in.reach(), out.reach()});
    constexpr double kLeast = 1e-3;  // mm: languages write no smaller zone
    for (double radius = wanted; radius > std::max(kLeast, 0.05 * wanted); radius *= 0.7) {
      if (!proof.isFree(in, out, in.shareOf(radius), out.shareOf(radius), progress)) continue;
      blends[i] = radius;
      break;
    }
    if (reduced && blends[i] < wanted && wanted > kLeast) reduced->push_back(i);
  }
  return blends;
}

}  // namespace handwheel
