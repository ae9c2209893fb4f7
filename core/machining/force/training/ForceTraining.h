// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/TrainedForceModel.h"
#include "machining/force/training/NetworkTraining.h"

#include <functional>

namespace handwheel {

// The relative errors of a law on cuts that it was not fitted to. They are fractions of the force.
struct HeldOutErrors {
  std::size_t cuts = 0;
  double mean = 0.0, median = 0.0, worst = 0.0;
};

// A model with the report of its training.
struct ForceTraining {
  TrainedForceModel model;     // trained on all cuts
  std::vector<double> errors;  // mean squared error in scaled units: before training, and after each epoch
  bool isGoalReached = false;
  std::size_t conditions = 0;  // number of combinations of depth, feed and speed
  double seconds = 0.0;        // CPU time of the training
  // Errors of a fivefold cross-validation: each network and power law is fitted without a fifth of the conditions, and
  // tested on that fifth.
  HeldOutErrors network, powerLaw;

  std::size_t epochs() const { return errors.size() - 1; }
};

// Least number of different conditions for a model.
inline constexpr std::size_t kLeastConditions = 8;

// Trains a network on all cuts, and fits the power law that replaces it outside of the data. To judge both, five
// more pairs of a network and a power law are fitted, each pair without a different fifth of the conditions; the seed
// determines the fifths. material: id of the material; empty: none. Errors: TooFewCuts, Cancelled.
Result<ForceTraining> trainForceModel(const ForceSamples& samples, const TrainingOptions& options,
                                      const std::string& material, Progress progress = {});

// Returns the errors of a law, which gives the force in N, on samples.
HeldOutErrors errorsOf(const std::function<double(const CutConditions&)>& law, std::span<const ForceSample> samples);

}  // namespace handwheel
