// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/training/NetworkProblem.h"

#include <cmath>
#include <limits>

namespace handwheel {

namespace {

// Finds a step along a direction that meets both Wolfe conditions, by bisection (Nocedal and Wright, Numerical
// Optimization, 2006, 3.1). On success weights, gradient and error are those of its end.
bool searchLine(NetworkProblem& problem, const Eigen::VectorXd& direction, Eigen::VectorXd& weights,
                Eigen::VectorXd& gradient, double& error) {
  constexpr double kDecrease = 1e-4, kCurvature = 0.9;
  constexpr int kTrials = 50;
  const double slope = gradient.dot(direction);
  double least = 0.0, most = std::numeric_limits<double>::infinity(), step = 1.0;
  Eigen::VectorXd next, nextGradient;
  for (int trial = 0; trial < kTrials && !problem.isCancelled(); ++trial) {
    next = weights + step * direction;
    const double there = problem.error(next, nextGradient);
    if (!(there <= error + kDecrease * step * slope)) {
      most = step;
    } else if (nextGradient.dot(direction) < kCurvature * slope) {
      least = step;
    } else {
      weights = next;
      gradient = nextGradient;
      error = there;
      return true;
    }
    step = std::isinf(most) ? 2.0 * step : 0.5 * (least + most);
  }
  return false;
}

}  // namespace

// An epoch is one line search. The inverse Hessian begins as a multiple of the identity and is reset if the search
// fails (Nocedal and Wright, 6.1).
void trainByBfgs(NetworkProblem& problem, TrainingRecord& record) {
  const Eigen::Index n = problem.weightCount();
  Eigen::VectorXd weights = record.best(), gradient;
  double error = problem.error(weights, gradient);
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(n, n);
  bool isFresh = true;
  for (;;) {
    const Eigen::VectorXd before = weights, gradientBefore = gradient;
    if (!searchLine(problem, -(inverse * gradient), weights, gradient, error)) {
      if (isFresh || problem.isCancelled()) return;  // no descent, within rounding
      inverse.setIdentity();
      isFresh = true;
      continue;
    }
    if (!record.add(weights, error)) return;
    const Eigen::VectorXd step = weights - before, change = gradient - gradientBefore;
    const double curvature = step.dot(change);
    if (!(curvature > 0.0)) continue;
    if (isFresh) inverse *= curvature / change.squaredNorm();
    isFresh = false;
    const Eigen::VectorXd turned = inverse * change;
    inverse += ((curvature + change.dot(turned)) / (curvature * curvature)) * step * step.transpose() -
               (turned * step.transpose() + step * turned.transpose()) / curvature;
  }
}

}  // namespace handwheel
