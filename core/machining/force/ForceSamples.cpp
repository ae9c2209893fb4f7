// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/ForceSamples.h"

#include "base/NumberText.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

namespace handwheel {

namespace {

bool isLighterCut(const CutConditions& a, const CutConditions& b) {
  return std::tie(a.depth, a.feed, a.speed) < std::tie(b.depth, b.feed, b.speed);
}

std::vector<CutConditions> conditionsOf(std::span<const ForceSample> samples) {
  std::vector<CutConditions> conditions;
  for (const ForceSample& sample : samples) conditions.push_back(sample.cut);
  std::sort(conditions.begin(), conditions.end(), isLighterCut);
  conditions.erase(std::unique(conditions.begin(), conditions.end()), conditions.end());
  return conditions;
}

// Returns value i of a geometric series from least to largest.
double geometric(double least, double largest, int i, int count) {
  return least * std::pow(largest / least, static_cast<double>(i) / (count - 1));
}

}  // namespace

SplitSamples splitByConditions(std::span<const ForceSample> samples, std::size_t fold, std::size_t folds,
                               std::uint64_t seed) {
  std::vector<CutConditions> all = conditionsOf(samples), conditions;
  // The standard does not specify the result of std::shuffle.
  std::mt19937_64 random(seed);
  for (std::size_t i = all.size(); i > 1; --i) std::swap(all[i - 1], all[random() % i]);
  for (std::size_t i = fold; i < all.size() && all.size() > 1; i += folds) conditions.push_back(all[i]);
  std::sort(conditions.begin(), conditions.end(), isLighterCut);
  SplitSamples split;
  for (const ForceSample& sample : samples) {
    const bool isHeld = std::binary_search(conditions.begin(), conditions.end(), sample.cut, isLighterCut);
    (isHeld ? split.heldOut : split.training).push_back(sample);
  }
  return split;
}

std::size_t conditionCount(std::span<const ForceSample> samples) {
  return conditionsOf(samples).size();
}

ForceSamples syntheticSamples(const WorkMaterial& material, const KosilovaTables& tables) {
  constexpr int kDepths = 8, kFeeds = 6, kSpeeds = 6;
  const std::unique_ptr<KosilovaModel> kosilova = kosilovaModel(tables, material, {});
  const bool isByHandbook = kosilova && kosilova->isVerified();
  const std::unique_ptr<KienzleModel> kienzle = kienzleModel(material, {});
  const CuttingForceModel& law = isByHandbook ? static_cast<const CuttingForceModel&>(*kosilova) : *kienzle;
  ForceSamples made;
  made.isSynthetic = true;
  made.origin = "Calculated for " + material.id + " by ";
  if (isByHandbook)
    made.origin += "Kosilova's law, row " + kosilovaRowFor(tables, material, ToolMaterial::Carbide)->id +
                   ", with the tensile strength of " + roundedText(material.strength) + " MPa (" +
                   kosilovaRowFor(tables, material, ToolMaterial::Carbide)->source + "; " + material.source + ")";
  else
    made.origin += "Kienzle's law with kc1.1 " + roundedText(material.kienzle.kc11, 4) + " N/mm², mc " +
                   roundedText(material.kienzle.mc, 3) + " (" + material.source + ")";
  for (int d = 0; d < kDepths; ++d) {
    for (int f = 0; f < kFeeds; ++f) {
      for (int v = 0; v < kSpeeds; ++v) {
        const CutConditions cut{geometric(0.2, 3.0, d, kDepths), geometric(0.05, 0.4, f, kFeeds),
                                geometric(30.0, 200.0, v, kSpeeds)};
        made.samples.push_back({cut, law.at(cut).cutting});
      }
    }
  }
  made.rows = made.samples.size();
  return made;
}

PowerLaw fittedPowerLaw(std::span<const ForceSample> samples) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixX3d logs(n, 3);
  Eigen::VectorXd forces(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const ForceSample& sample = samples[static_cast<std::size_t>(i)];
    logs.row(i) << std::log(sample.cut.depth), std::log(sample.cut.feed), std::log(sample.cut.speed);
    forces[i] = std::log(sample.force);
  }
  const Eigen::RowVector3d middle = logs.colwise().mean();
  const double level = forces.mean();
  // The shortest solution: a column without spread is zero but for rounding, and gets no exponent.
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixX3d> solver;
  solver.setThreshold(1e-9);
  solver.compute(logs.rowwise() - middle);
  const Eigen::Vector3d exponents =
      solver.solve((forces.array() - level).matrix()).cwiseMax(-kMostExponent).cwiseMin(kMostExponent);
  return {level - middle.dot(exponents), exponents[0], exponents[1], exponents[2]};
}

}  // namespace handwheel
