// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/ForceSamples.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace handwheel {

// A neural network for the cutting force (He 2008, section 3.1). It has depth, feed and speed as inputs, one hidden
// layer of sigmoid neurons and a linear output. Its inputs are scaled from the range of the training set to -1…1; its
// output is scaled from 0…1 to the range of the forces.
//
// weights: five for each hidden neuron (three for the inputs, its bias, and its weight in the output), followed by the
// bias of the output.
struct ForceNetwork {
  static constexpr std::size_t kInputs = 3, kPerNeuron = kInputs + 2;
  static constexpr std::size_t kMostHidden = 64;
  using Inputs = std::array<double, kInputs>;

  std::vector<double> weights;
  Inputs least{}, largest{};                    // range of the training set; mm, mm/rev, m/min
  double leastForce = 0.0, largestForce = 0.0;  // N

  static constexpr std::size_t weightCount(std::size_t hidden) { return kPerNeuron * hidden + 1; }
  std::size_t hidden() const { return weights.size() / kPerNeuron; }

  // Returns an untrained network for samples (at least one). It is scaled to the range of the samples, and its weights
  // are random numbers from the seed (Nguyen and Widrow, "Improving the learning speed of 2-layer neural networks",
  // IJCNN 1990).
  static ForceNetwork untrained(std::span<const ForceSample> samples, std::size_t hidden, std::uint64_t seed);

  Inputs scaled(const CutConditions& cut) const noexcept;
  double scaledForce(double force) const noexcept;

  // Returns the cutting force, N, which is never negative. O(hidden); allocates nothing.
  double at(const CutConditions& cut) const noexcept;
};

// Returns the scaled output of a network for scaled inputs.
double networkOutput(std::span<const double> weights, const ForceNetwork::Inputs& inputs) noexcept;
// Returns the scaled output of a network, and writes its derivatives with respect to the weights to `gradient`.
double networkOutput(std::span<const double> weights, const ForceNetwork::Inputs& inputs, double* gradient) noexcept;

}  // namespace handwheel
