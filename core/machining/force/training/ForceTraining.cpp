// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/training/ForceTraining.h"

#include "base/FidelitySweep.h"
#include "base/ThreadClock.h"
#include "machining/force/ForceErrors.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::size_t kFolds = 5;

HeldOutErrors summaryOf(std::vector<double> errors) {
  HeldOutErrors summary;
  summary.cuts = errors.size();
  if (errors.empty()) return summary;
  for (const double error : errors) summary.mean += error / static_cast<double>(errors.size());
  summary.worst = *std::max_element(errors.begin(), errors.end());
  summary.median = median(std::move(errors));
  return summary;
}

double errorOn(const ForceSample& sample, double force) {
  return std::abs(force - sample.force) / sample.force;
}

Status judge(ForceTraining& training, const ForceSamples& samples, const TrainingOptions& options, Progress progress) {
  std::vector<double> networkErrors, lawErrors;
  for (std::size_t fold = 0; fold < kFolds; ++fold) {
    const auto share = [&](std::size_t n) { return static_cast<double>(n) / kFolds; };
    const SplitSamples split = splitByConditions(samples.samples, fold, kFolds, options.seed);
    const Result<TrainedNetwork> network =
        trainNetwork(split.training, options, progress.part(share(fold), share(fold + 1)));
    if (!network) return network.error();
    progress.set(share(fold + 1));  // the goal may be reached before the last epoch
    const PowerLaw law = fittedPowerLaw(split.training);
    // The model as it will be used: a held-out cut beyond the range of the others falls to the power law.
    const TrainedForceModel model(network->network, law, {});
    for (const ForceSample& sample : split.heldOut) {
      networkErrors.push_back(errorOn(sample, model.at(sample.cut).cutting));
      lawErrors.push_back(errorOn(sample, law.at(sample.cut)));
    }
  }
  training.network = summaryOf(std::move(networkErrors));
  training.powerLaw = summaryOf(std::move(lawErrors));
  return Done{};
}

}  // namespace

Result<ForceTraining> trainForceModel(const ForceSamples& samples, const TrainingOptions& options,
                                      const std::string& material, Progress progress) {
  const std::size_t conditions = conditionCount(samples.samples);
  if (conditions < kLeastConditions)
    return Error{ForceErrors::TooFewCuts, {std::to_string(conditions), std::to_string(kLeastConditions)}, {}, {}};
  std::optional<Result<TrainedNetwork>> trained;
  const double milliseconds =
      cpuMilliseconds([&] { trained = trainNetwork(samples.samples, options, progress.part(0.0, 0.3)); });
  if (!*trained) return trained->error();
  TrainedNetwork& network = trained->value();
  TrainedForceModel::Origin origin{samples.origin,           samples.isSynthetic, material,
                                   wordFor(options.trainer), options.seed,        network.epochs(),
                                   samples.samples.size(),   network.error()};
  ForceTraining training{{network.network, fittedPowerLaw(samples.samples), origin},
                         network.errors,
                         network.isGoalReached,
                         conditions,
                         milliseconds * 1e-3,
                         {},
                         {}};
  const Status judged = judge(training, samples, options, progress.part(0.3, 1.0));
  if (!judged) return judged.error();
  origin.heldOutError = training.network.mean;
  training.model = TrainedForceModel(std::move(network.network), training.model.powerLaw(), std::move(origin));
  return training;
}

HeldOutErrors errorsOf(const std::function<double(const CutConditions&)>& law, std::span<const ForceSample> samples) {
  std::vector<double> errors;
  for (const ForceSample& sample : samples) errors.push_back(errorOn(sample, law(sample.cut)));
  return summaryOf(std::move(errors));
}

}  // namespace handwheel
