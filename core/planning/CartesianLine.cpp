// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/CartesianLine.h"

#include "robot/arm/NumericalIk.h"

#include <cmath>

namespace handwheel {

namespace {

Pose between(const Pose& from, const Pose& to, double share) {
  const Eigen::Quaterniond first(from.linear()), second(to.linear());
  Pose pose = Pose::Identity();
  pose.translation() = (1.0 - share) * from.translation() + share * to.translation();
  pose.linear() = first.slerp(share, second).toRotationMatrix();
  return pose;
}

class Following {
 public:
  Following(const SerialArm& arm, const Pose& tool, const ArmValues& from, const ArmValues& to,
            const LineSettings& settings)
      : m_arm(arm),
        m_tool(tool),
        m_settings(settings),
        m_begin(arm.tipPose(from) * tool),
        m_end(arm.tipPose(to) * tool) {
    m_ik.tolerance = 1e-9;
    m_ik.mostStarts = 1;
    m_ik.seconds = 0.1;
  }

  // Returns the joint values at a share of the line, next to those before; none if it cannot continue.
  std::optional<ArmValues> at(double share, const ArmValues& before) const {
    const Pose tip = between(m_begin, m_end, share) * m_tool.inverse(Eigen::Isometry);
    const NumericalIkResult found = solvedNumerically(m_arm, tip, before, m_ik);
    constexpr double kMostOff = 1e-4;  // mm, rad
    if (found.distance > kMostOff || found.angle > kMostOff) return std::nullopt;
    return found.values;
  }

  // Returns the deviation of the joints from the line between two of its waypoints if it is within the settings. The
  // motion and the line differ most about half way; the difference is computed there, and assumed to be at most half as
  // much again in between.
  std::optional<ArmValues> off(const ArmValues& a, double shareA, const ArmValues& b, double shareB) const {
    if ((a - b).cwiseAbs().maxCoeff() > m_settings.largestStep && !isShort(a, b)) return std::nullopt;
    const Pose wanted = between(m_begin, m_end, 0.5 * (shareA + shareB));
    const auto error = poseError(m_arm.tipPose(0.5 * (a + b)) * m_tool, wanted);
    const bool isNear = error.head<3>().norm() <= m_settings.deviation && error.tail<3>().norm() <= m_settings.angle;
    if (!isNear) return std::nullopt;
    const auto exact = at(0.5 * (shareA + shareB), 0.5 * (a + b));
    if (!exact) return std::nullopt;
    const ArmValues off = 1.5 * (*exact - 0.5 * (a + b)).cwiseAbs();
    for (Eigen::Index i = 0; i < off.size(); ++i) {
      const bool isSlide = m_arm.joints()[static_cast<std::size_t>(i)].isPrismatic;
      if (off[i] > m_settings.jointOff * (isSlide ? 1e3 : 1.0)) return std::nullopt;
    }
    return off;
  }

 private:
  // Slides count in mm.
  bool isShort(const ArmValues& a, const ArmValues& b) const {
    for (Eigen::Index i = 0; i < a.size(); ++i) {
      const bool isSlide = m_arm.joints()[static_cast<std::size_t>(i)].isPrismatic;
      if (!isSlide && std::abs(a[i] - b[i]) > m_settings.largestStep) return false;
    }
    return true;
  }

  const SerialArm& m_arm;
  const Pose& m_tool;
  const LineSettings& m_settings;
  Pose m_begin, m_end;
  NumericalIkSettings m_ik;
};

}  // namespace

FollowedLine followLine(const SerialArm& arm, const Pose& tool, const ArmValues& from, const ArmValues& to,
                        const LineSettings& settings, Progress progress) {
  constexpr double kLeastStep = 1e-5;  // share of the line; a smaller step means a leap of a joint
  constexpr double kSameEnd = 1e-3;    // rad, mm
  const Following following(arm, tool, from, to, settings);
  FollowedLine line{{from}, 0.0};
  double step = 0.1;
  while (line.reached < 1.0 && !progress.cancelled()) {
    const double share = std::min(1.0, line.reached + step);
    const ArmValues& before = line.path.back();
    std::optional<ArmValues> next = following.at(share, before);
    auto off = next ? following.off(before, line.reached, *next, share) : std::nullopt;
    if (off) {
      if (share == 1.0) {
        const ArmValues replaced = (*next - to).cwiseAbs();
        if (replaced.maxCoeff() > kSameEnd) return line;
        *off += replaced;
        next = to;
      }
      line.path.push_back(*next);
      line.offs.push_back(*off);
      line.reached = share;
      step *= 1.5;
    } else if ((step *= 0.5) < kLeastStep) {
      return line;
    }
    progress.set(line.reached);
  }
  return line;
}

}  // namespace handwheel
