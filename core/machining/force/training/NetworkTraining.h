// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/force/ForceNetwork.h"

namespace handwheel {

// The five training methods for a network.
enum class NetworkTrainer {
  LevenbergMarquardt,       // least squares from the derivatives of the errors (He 2008, eq. 3-8 and 3-9)
  Bfgs,                     // quasi-Newton method with a line search
  ScaledConjugateGradient,  // Møller, "A scaled conjugate gradient algorithm for fast supervised learning", 1993
  Momentum,                 // batch gradient descent with momentum
  GradientDescent,          // batch gradient descent
};
inline constexpr std::array kNetworkTrainers{NetworkTrainer::LevenbergMarquardt, NetworkTrainer::Bfgs,
                                             NetworkTrainer::ScaledConjugateGradient, NetworkTrainer::Momentum,
                                             NetworkTrainer::GradientDescent};
const char* wordFor(NetworkTrainer trainer);  // "lm", "bfgs", "scg", "gdm", "gd"

struct TrainingOptions {
  NetworkTrainer trainer = NetworkTrainer::LevenbergMarquardt;
  std::size_t hidden = 4;  // 1 to ForceNetwork::kMostHidden
  double goal = 1e-3;      // mean squared error in scaled units at which training ends; 0: it ends at the last epoch
  std::uint64_t seed = 1;
  std::size_t epochs = 0;  // largest number of epochs; 0: mostEpochs(), the number that the trainer usually needs
};
std::size_t mostEpochs(NetworkTrainer trainer);

struct TrainedNetwork {
  ForceNetwork network;        // the network with the least error of all epochs
  std::vector<double> errors;  // mean squared error in scaled units: before training, and after each epoch
  bool isGoalReached = false;

  std::size_t epochs() const { return errors.size() - 1; }
  double error() const;  // error of the network
};

// Trains a network on samples (at least one). The same samples and options give the same network, bit for bit.
// Cancelling takes effect within about 1,000 rows. Errors: Cancelled. Cost of an epoch: O(rows · weights), for
// Levenberg-Marquardt O(rows · weights²).
Result<TrainedNetwork> trainNetwork(std::span<const ForceSample> samples, const TrainingOptions& options,
                                    Progress progress = {});

}  // namespace handwheel
