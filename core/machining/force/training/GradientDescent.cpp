// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/training/NetworkProblem.h"

#include <cmath>

namespace handwheel {

// An epoch is one step down the gradient of all samples (Rumelhart, Hinton, Williams 1986). The rate is chosen so that
// the curvature of the output's weights, at most 2 (1 + hidden), does not let the steps grow.
void trainByGradientDescent(NetworkProblem& problem, TrainingRecord& record, double momentum) {
  const double rate = 2.5 / static_cast<double>(problem.weightCount() + 4);
  Eigen::VectorXd weights = record.best(), gradient;
  Eigen::VectorXd step = Eigen::VectorXd::Zero(weights.size());
  problem.error(weights, gradient);
  for (bool goesOn = true; goesOn;) {
    step = momentum * step - rate * gradient;
    weights += step;
    const double error = problem.error(weights, gradient);
    if (problem.isCancelled() || !std::isfinite(error)) return;
    goesOn = record.add(weights, error);
  }
}

}  // namespace handwheel
