// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/ForceSamples.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace handwheel {

// A neural network for the cutting force (He 2008, 3.1). It has depth, feed and speed as inputs, one hidden layer of
// sigmoid neurons and a linear output. Its inputs are scaled from the range of the training set to -1…1, its output
// from 0…1.
//
// weights: for each hidden neuron three for the inputs, its bias and its weight in the output; then the bias of the
// output.
struct ForceNetwork {
  static constexpr std::size_t kInputs = 3, kPerNeuron = kInputs + 2;
  static constexpr std::size_t kMostHidden = 64;
  using Inputs = std::array<double, kInputs>;

  std::vector<double> weights;
  Inputs least{}, largest{};                    // mm, mm/rev, m/min
  double leastForce = 0.0, largestForce = 0.0;  // N

  static constexpr std::size_t weightCount(std::size_t hidden) { return kPerNeuron * hidden + 1; }
  std::size_t hidden() const { return weights.size() / kPerNeuron; }

  // Returns an untrained network for samples (at least one): scaled to their range, its weights chosen by the seed
  // (Nguyen and Widrow, "Improving the learning speed of 2-layer neural networks", IJCNN 1990).
  static ForceNetwork untrained(std::span<const ForceSample> samples, std::size_t hidden, std::uint64_t seed);

  Inputs scaled(const CutConditions& cut) const noexcept;
  double scaledForce(double force) const noexcept;

  // Returns the cutting force, N; not negative. O(hidden), no allocation.
  double at(const CutConditions& cut) const noexcept;
};

// Returns the output for scaled inputs.
double networkOutput(std::span<const double> weights, const ForceNetwork::Inputs& inputs) noexcept;
// The same; also writes its derivatives with respect to the weights.
double networkOutput(std::span<const double> weights, const ForceNetwork::Inputs& inputs, double* gradient) noexcept;

}  // namespace handwheel
