// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/TrainedForceModel.h"
#include "machining/force/training/NetworkTraining.h"

#include <functional>

namespace handwheel {

// The relative errors of a law on cuts that it was not fitted to. Fractions of the force.
struct HeldOutErrors {
  std::size_t cuts = 0;
  double mean = 0.0, median = 0.0, worst = 0.0;
};

// A model with the report of its training.
struct ForceTraining {
  TrainedForceModel model;     // trained on all cuts
  std::vector<double> errors;  // mean squared error in scaled units: before training, and after each epoch
  bool isGoalReached = false;
  std::size_t conditions = 0;  // different depths, feeds and speeds
  double seconds = 0.0;        // CPU time of the training
  // Errors of five networks and power laws, each fitted without a fifth of the conditions, on that fifth.
  HeldOutErrors network, powerLaw;

  std::size_t epochs() const { return errors.size() - 1; }
};

// Least number of different conditions for a model.
inline constexpr std::size_t kLeastConditions = 8;

// Trains a network and fits the power law that replaces it outside of the data. Trains five times more, each time
// without another fifth of the conditions, to judge both; the seed distributes them. material: id, or empty. Errors:
// TooFewCuts, Cancelled.
Result<ForceTraining> trainForceModel(const ForceSamples& samples, const TrainingOptions& options,
                                      const std::string& material, Progress progress = {});

// Returns the errors of a law, which gives the force in N, on samples.
HeldOutErrors errorsOf(const std::function<double(const CutConditions&)>& law, std::span<const ForceSample> samples);

}  // namespace handwheel
