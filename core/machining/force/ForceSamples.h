// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "machining/force/WorkMaterials.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace handwheel {

// A measured or calculated cut and its cutting force. All values are finite and above zero.
struct ForceSample {
  CutConditions cut;
  double force = 0.0;  // N
  bool operator==(const ForceSample&) const = default;
};

// The cuts that a force law is fitted to. Table rows with the same conditions and the same force are one sample.
struct ForceSamples {
  std::vector<ForceSample> samples;
  std::string origin;        // the source of the rows, as a sentence
  bool isSynthetic = false;  // the samples were calculated from tables and not measured
  std::size_t rows = 0;      // number of rows of the table
  std::size_t wornRows = 0;  // rows left out because the tool was worn
  std::size_t gapRows = 0;   // rows left out because a value is missing ("na")
};

// The two parts into which samples are split. Samples of the same depth, feed and speed are in the same part, because a
// replica of a training cut would make the held-out error look too small.
struct SplitSamples {
  std::vector<ForceSample> training, heldOut;
};

// Distributes the conditions over folds at random, by the seed, and holds one fold out. A fold may be empty. If there
// is only one condition, nothing is held out. fold: the index of the fold that is held out. folds: the number of folds,
// at least 2. O(n log n).
SplitSamples splitByConditions(std::span<const ForceSample> samples, std::size_t fold, std::size_t folds,
                               std::uint64_t seed);

// Returns the number of different conditions (depth, feed and speed) in the samples. O(n log n).
std::size_t conditionCount(std::span<const ForceSample> samples);

// Returns at least 240 cuts of a material, calculated over the range of a student's lathe: depths of 0.2 to 3 mm, feeds
// of 0.05 to 0.4 mm, speeds of 30 to 200 m/min. They follow the handbook's law if its row for the material is verified,
// and Kienzle's law otherwise. `origin` names the law.
ForceSamples syntheticSamples(const WorkMaterial& material, const KosilovaTables& tables);

// Returns the power law nearest to the samples, by least squares of the logarithms. A quantity that is the same in all
// samples gets the exponent 0; exponents are within ±kMostExponent. There must be at least one sample. O(n).
PowerLaw fittedPowerLaw(std::span<const ForceSample> samples);
inline constexpr double kMostExponent = 10.0;

}  // namespace handwheel
