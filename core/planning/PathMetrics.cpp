// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/PathMetrics.h"

#include "planning/PathShortcuts.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kMetre = 1e-3;  // metres per mm

double limitMarginOf(const RobotScene& scene, const ArmValues& values) {
  double least = 0.5;
  for (Eigen::Index i = 0; i < scene.size(); ++i) {
    const ArmJoint& joint = scene.joint(i);
    const double range = joint.upper - joint.lower;
    if (!std::isfinite(range)) continue;
    const double margin = std::min(values[i] - joint.lower, joint.upper - values[i]);
    least = std::min(least, range > 0.0 ? std::max(0.0, margin / range) : 0.0);
  }
  return least;
}

// Returns the largest move of a joint in a motion.
double largestMove(const RobotScene& scene, const ArmValues& from, const ArmValues& to) {
  double most = 0.0;
  for (Eigen::Index i = 0; i < scene.size(); ++i)
    most = std::max(most, std::abs(to[i] - from[i]) * (scene.joint(i).isPrismatic ? kMetre : 1.0));
  return most;
}

}  // namespace

double securityIndex(std::span<const double> clearances) {
  double sum = 0.0;
  for (const double clearance : clearances) {
    if (!(clearance > 0.0)) return 0.0;
    sum += 1.0 / clearance;
  }
  return sum > 0.0 ? static_cast<double>(clearances.size()) / sum : 0.0;
}

double manipulabilityOf(const SerialArm& arm, const ArmValues& values, double length) {
  ArmJacobian jacobian(6, arm.size());
  arm.tipPose(values, jacobian);
  jacobian.topRows<3>() /= length;
  for (Eigen::Index i = 0; i < arm.size(); ++i) {
    if (arm.joints()[static_cast<std::size_t>(i)].isPrismatic) jacobian.col(i) *= length;
  }
  const double square = arm.size() >= 6 ? (jacobian * jacobian.transpose()).eval().determinant()
                                        : Eigen::MatrixXd(jacobian.transpose() * jacobian).determinant();
  return std::sqrt(std::max(0.0, square));
}

PathMetrics metricsOf(const RobotScene& scene, const SerialArm& arm, const JointPath& path,
                      const PathMetricsSettings& settings, Progress progress) {
  PathMetrics metrics;
  if (path.empty()) return metrics;
  metrics.length = lengthOf(scene, path);
  for (std::size_t i = 1; i < path.size(); ++i) {
    double turned = 0.0, slid = 0.0;  // squared
    for (Eigen::Index k = 0; k < scene.size(); ++k) {
      const double moved = path[i][k] - path[i - 1][k];
      (scene.joint(k).isPrismatic ? slid : turned) += moved * moved;
    }
    metrics.turned += std::sqrt(turned);
    metrics.slid += std::sqrt(slid);
  }
  const double length = settings.length > 0.0 ? settings.length : std::max(arm.reach(), 1e-3);
  double moves = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) moves += largestMove(scene, path[i - 1], path[i]);
  const double step = std::max(settings.step, moves / static_cast<double>(settings.mostSamples));
  const auto add = [&](std::size_t motion, double share, const ArmValues& values, double at) {
    PathSample sample{at, motion, share, values};
    const bool isFolded = scene.tooNear(values, 0.0, 0.0).otherLink != kNone;  // the robot meets itself
    sample.clearance = isFolded ? 0.0 : scene.nearestObstacle(values, settings.farthest).distance;
    sample.manipulability = manipulabilityOf(arm, values, length);
    sample.limitMargin = limitMarginOf(scene, values);
    metrics.samples.push_back(std::move(sample));
    progress.set(at);
  };
  add(0, 0.0, path.front(), 0.0);
  double before = 0.0;
  for (std::size_t i = 1; i < path.size() && !progress.cancelled(); ++i) {
    const double own = lengthOf(scene, {path[i - 1], path[i]});
    const auto parts = static_cast<std::size_t>(std::ceil(largestMove(scene, path[i - 1], path[i]) / step));
    for (std::size_t k = 1; k <= std::max<std::size_t>(parts, 1) && !progress.cancelled(); ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(std::max<std::size_t>(parts, 1));
      const ArmValues values = k >= parts ? path[i] : ArmValues(path[i - 1] + share * (path[i] - path[i - 1]));
      add(i - 1, share, values, metrics.length > 0.0 ? (before + share * own) / metrics.length : 0.0);
    }
    before += own;
  }
  std::vector<double> clearances;
  metrics.leastClearance = settings.farthest;
  metrics.leastManipulability = metrics.samples.front().manipulability;
  for (const PathSample& sample : metrics.samples) {
    clearances.push_back(sample.clearance);
    metrics.leastClearance = std::min(metrics.leastClearance, sample.clearance);
    metrics.manipulability += sample.manipulability / static_cast<double>(metrics.samples.size());
    metrics.leastManipulability = std::min(metrics.leastManipulability, sample.manipulability);
    metrics.leastMargin = std::min(metrics.leastMargin, sample.limitMargin);
  }
  metrics.security = securityIndex(clearances);
  return metrics;
}

}  // namespace handwheel
