// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/training/NetworkProblem.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

// An epoch is one iteration of Møller's algorithm ("A scaled conjugate gradient algorithm for fast supervised
// learning", Neural Networks 6, 1993), even if it took no step. The names follow the paper, but for the letters.
void trainByScaledConjugateGradient(NetworkProblem& problem, TrainingRecord& record) {
  constexpr double kProbe = 1e-5, kFirstScale = 1e-6, kMostScale = 1e20, kLeastGradient = 1e-12;
  const Eigen::Index n = problem.weightCount();
  Eigen::VectorXd weights = record.best(), gradient, probed, next, nextGradient;
  double error = problem.error(weights, gradient), scale = kFirstScale, raised = 0.0, curvature = 0.0;
  Eigen::VectorXd downhill = -gradient, direction = downhill;
  bool isSuccess = true;
  for (Eigen::Index k = 1;; ++k) {
    const double length = direction.squaredNorm();
    if (!(length > kLeastGradient * kLeastGradient) || scale > kMostScale) return;
    if (isSuccess) {  // second-order information
      const double probe = kProbe / std::sqrt(length);
      problem.error(weights + probe * direction, probed);
      curvature = direction.dot(probed - gradient) / probe;
    }
    curvature += (scale - raised) * length;
    if (curvature <= 0.0) {  // make the Hessian positive definite
      raised = 2.0 * (scale - curvature / length);
      curvature = scale * length - curvature;
      scale = raised;
    }
    const double slope = direction.dot(downhill), step = slope / curvature;
    next = weights + step * direction;
    const double there = problem.error(next);
    if (problem.isCancelled()) return;
    const double comparison = 2.0 * curvature * (error - there) / (slope * slope);
    isSuccess = comparison >= 0.0;  // false for NaN
    if (isSuccess) {
      weights = next;
      error = problem.error(weights, nextGradient);
      raised = 0.0;
      if (k % n == 0) {
        direction = -nextGradient;
      } else {
        const double conjugate = (nextGradient.squaredNorm() + nextGradient.dot(downhill)) / slope;
        direction = conjugate * direction - nextGradient;
      }
      gradient = nextGradient;
      downhill = -gradient;
      if (direction.dot(downhill) <= 0.0) direction = downhill;
      if (comparison >= 0.75) scale *= 0.25;
    } else {
      raised = scale;
    }
    if (!(comparison >= 0.25)) {
      const double more = std::isfinite(comparison) ? curvature * (1.0 - comparison) / length : 3.0 * scale;
      scale = std::max(scale + more, 2.0 * scale);
    }
    if (!record.add(weights, error)) return;
  }
}

}  // namespace handwheel
