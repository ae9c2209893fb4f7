// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/training/NetworkProblem.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace handwheel {

// An epoch is one step that lowers the error, with as many trials of the damping as needed. Marquardt 1963, with the
// damping constants of Hagan and Menhaj, "Training feedforward networks with the Marquardt algorithm", 1994.
void trainByLevenbergMarquardt(NetworkProblem& problem, TrainingRecord& record) {
  constexpr double kFirst = 1e-3, kFactor = 10.0, kLeast = 1e-15, kMost = 1e10;
  double damping = kFirst;
  Eigen::VectorXd weights = record.best(), gradient, next;
  Eigen::MatrixXd hessian, damped;
  for (bool goesOn = true; goesOn;) {
    const double error = problem.error(weights, hessian, gradient);
    for (;;) {
      if (problem.isCancelled() || damping > kMost) return;
      damped = hessian;
      damped.diagonal().array() += damping;
      next = weights - damped.selfadjointView<Eigen::Lower>().ldlt().solve(gradient);
      const double there = problem.error(next);
      if (there < error) {  // false for NaN
        weights = next;
        damping = std::max(damping / kFactor, kLeast);
        goesOn = record.add(weights, there);
        break;
      }
      damping *= kFactor;
    }
  }
}

}  // namespace handwheel
