// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/TrainedForceModel.h"
#include "machining/force/training/NetworkTraining.h"

#include <functional>

namespace handwheel {

// The relative errors of a law on cuts that it was not fitted to. As shares of their force.
struct HeldOutErrors {
  std::size_t cuts = 0;
  double mean = 0.0, median = 0.0, worst = 0.0;
};

// A model with the account of its training.
struct ForceTraining {
  TrainedForceModel model;     // trained on all cuts
  std::vector<double> errors;  // mean squared, in scaled units: before, and after each epoch
  bool isGoalReached = false;
  std::size_t conditions = 0;  // different depths, feeds and speeds
  double seconds = 0.0;        // CPU time of the training
  // Of networks and power laws that were each fitted without a fifth of the conditions, on that fifth.
  HeldOutErrors network, powerLaw;

  std::size_t epochs() const { return errors.size() - 1; }
};

// Different conditions that a model needs at least.
inline constexpr std::size_t kLeastConditions = 8;

// Trains a network and fits the power law that takes its place outside. Trains five times more, each time without
// another fifth of the conditions, to judge both; the seed deals them out. material: id, or empty. Errors: TooFewCuts,
// Cancelled.
Result<ForceTraining> trainForceModel(const ForceSamples& samples, const TrainingOptions& options,
                                      const std::string& material, Progress progress = {});

// The errors of a law, which gives the force in N, on samples.
HeldOutErrors errorsOf(const std::function<double(const CutConditions&)>& law, std::span<const ForceSample> samples);

}  // namespace handwheel
