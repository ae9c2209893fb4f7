// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/ForceNetwork.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace handwheel {

namespace {

constexpr std::size_t kBias = ForceNetwork::kInputs, kOutput = ForceNetwork::kInputs + 1;  // in a neuron's weights

double sigmoid(double x) noexcept {
  return 1.0 / (1.0 + std::exp(-x));
}

// Returns a number in -1…1; the standard does not specify the result of std::uniform_real_distribution.
double uniformWeight(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0;
}

ForceNetwork::Inputs inputsOf(const CutConditions& cut) {
  return {cut.depth, cut.feed, cut.speed};
}

}  // namespace

ForceNetwork ForceNetwork::untrained(std::span<const ForceSample> samples, std::size_t hidden, std::uint64_t seed) {
  ForceNetwork network;
  network.least = network.largest = inputsOf(samples[0].cut);
  network.leastForce = network.largestForce = samples[0].force;
  for (const ForceSample& sample : samples) {
    const Inputs inputs = inputsOf(sample.cut);
    for (std::size_t i = 0; i < kInputs; ++i) {
      network.least[i] = std::min(network.least[i], inputs[i]);
      network.largest[i] = std::max(network.largest[i], inputs[i]);
    }
    network.leastForce = std::min(network.leastForce, sample.force);
    network.largestForce = std::max(network.largestForce, sample.force);
  }
  std::mt19937_64 random(seed);
  // Twice the slope for a hyperbolic tangent, which the rule was made for.
  const double slope = 2.0 * 0.7 * std::pow(static_cast<double>(hidden), 1.0 / kInputs);
  network.weights.assign(weightCount(hidden), 0.0);
  for (std::size_t j = 0; j < hidden; ++j) {
    double* neuron = network.weights.data() + j * kPerNeuron;
    double norm = 0.0;
    for (std::size_t i = 0; i < kInputs; ++i) {
      neuron[i] = uniformWeight(random);
      norm += neuron[i] * neuron[i];
    }
    for (std::size_t i = 0; i < kInputs; ++i) neuron[i] *= slope / std::sqrt(std::max(norm, 1e-12));
    const double centre = hidden == 1 ? 0.0 : 2.0 * static_cast<double>(j) / static_cast<double>(hidden - 1) - 1.0;
    neuron[kBias] = slope * centre;
    neuron[kOutput] = 0.5 * uniformWeight(random);
  }
  network.weights.back() = 0.5 * uniformWeight(random);
  return network;
}

ForceNetwork::Inputs ForceNetwork::scaled(const CutConditions& cut) const noexcept {
  Inputs inputs = inputsOf(cut);
  for (std::size_t i = 0; i < kInputs; ++i) {
    const double span = largest[i] - least[i];
    inputs[i] = span > 0.0 ? 2.0 * (inputs[i] - least[i]) / span - 1.0 : 0.0;
  }
  return inputs;
}

double ForceNetwork::scaledForce(double force) const noexcept {
  const double span = largestForce - leastForce;
  return span > 0.0 ? (force - leastForce) / span : 0.0;
}

double ForceNetwork::at(const CutConditions& cut) const noexcept {
  return std::max(0.0, leastForce + networkOutput(weights, scaled(cut)) * (largestForce - leastForce));
}

double networkOutput(std::span<const double> weights, const ForceNetwork::Inputs& inputs) noexcept {
  double sum = weights.back();
  for (const double* neuron = weights.data(); neuron + 1 < weights.data() + weights.size();
       neuron += ForceNetwork::kPerNeuron) {
    const double x = neuron[0] * inputs[0] + neuron[1] * inputs[1] + neuron[2] * inputs[2] + neuron[kBias];
    sum += neuron[kOutput] * sigmoid(x);
  }
  return sum;
}

double networkOutput(std::span<const double> weights, const ForceNetwork::Inputs& inputs, double* gradient) noexcept {
  double sum = weights.back();
  std::size_t at = 0;
  for (; at + 1 < weights.size(); at += ForceNetwork::kPerNeuron) {
    const double* neuron = weights.data() + at;
    const double x = neuron[0] * inputs[0] + neuron[1] * inputs[1] + neuron[2] * inputs[2] + neuron[kBias];
    const double s = sigmoid(x), slope = neuron[kOutput] * s * (1.0 - s);
    for (std::size_t i = 0; i < ForceNetwork::kInputs; ++i) gradient[at + i] = slope * inputs[i];
    gradient[at + kBias] = slope;
    gradient[at + kOutput] = s;
    sum += neuron[kOutput] * s;
  }
  gradient[at] = 1.0;
  return sum;
}

}  // namespace handwheel
