// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/training/NetworkTraining.h"

#include "machining/force/training/NetworkProblem.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr double kMomentum = 0.9;

void train(NetworkTrainer trainer, NetworkProblem& problem, TrainingRecord& record) {
  switch (trainer) {
    case NetworkTrainer::LevenbergMarquardt:
      return trainByLevenbergMarquardt(problem, record);
    case NetworkTrainer::Bfgs:
      return trainByBfgs(problem, record);
    case NetworkTrainer::ScaledConjugateGradient:
      return trainByScaledConjugateGradient(problem, record);
    case NetworkTrainer::Momentum:
      return trainByGradientDescent(problem, record, kMomentum);
    case NetworkTrainer::GradientDescent:
      return trainByGradientDescent(problem, record, 0.0);
  }
}

}  // namespace

const char* wordFor(NetworkTrainer trainer) {
  constexpr std::array kWords{"lm", "bfgs", "scg", "gdm", "gd"};
  return kWords[static_cast<std::size_t>(trainer)];
}

std::size_t mostEpochs(NetworkTrainer trainer) {
  constexpr std::array<std::size_t, 5> kEpochs{1'000, 2'000, 4'000, 20'000, 20'000};
  return kEpochs[static_cast<std::size_t>(trainer)];
}

double TrainedNetwork::error() const {
  return *std::min_element(errors.begin(), errors.end());
}

Result<TrainedNetwork> trainNetwork(std::span<const ForceSample> samples, const TrainingOptions& options,
                                    Progress progress) {
  TrainedNetwork trained;
  trained.network = ForceNetwork::untrained(samples, options.hidden, options.seed);
  NetworkProblem problem(trained.network, samples, progress);
  Eigen::VectorXd weights = Eigen::Map<const Eigen::VectorXd>(
      trained.network.weights.data(), static_cast<Eigen::Index>(trained.network.weights.size()));
  const double error = problem.error(weights);
  TrainingRecord record(options, progress, std::move(weights), error);
  if (!record.hasEnded()) train(options.trainer, problem, record);
  if (problem.isCancelled() || progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  std::copy(record.best().begin(), record.best().end(), trained.network.weights.begin());
  trained.errors = record.errors();
  trained.isGoalReached = record.isAtGoal();
  return trained;
}

}  // namespace handwheel
