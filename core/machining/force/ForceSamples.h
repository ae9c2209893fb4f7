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
  double force = 0.0;  // N, cutting force
  bool operator==(const ForceSample&) const = default;
};

// Cuts that a law of forces is fitted to. Rows of one cut with the same force are one sample.
struct ForceSamples {
  std::vector<ForceSample> samples;
  std::string origin;        // a sentence: where the rows are from
  bool isSynthetic = false;  // calculated from tables, and not measured
  std::size_t rows = 0;      // of the table
  std::size_t wornRows = 0;  // left out, because the tool was worn
  std::size_t gapRows = 0;   // left out, because a value is missing ("na")
};

// Two parts of the samples. Those of the same depth, feed and speed are in the same part: a replica of a cut that was
// trained on would flatter the error.
struct SplitSamples {
  std::vector<ForceSample> training, heldOut;
};

// Deals the conditions out to so many folds, by the seed, and holds one of them out. A fold may be empty; where there
// is one condition only, nothing is held out. folds: at least 2. O(n log n).
SplitSamples splitByConditions(std::span<const ForceSample> samples, std::size_t fold, std::size_t folds,
                               std::uint64_t seed);

// How many different conditions there are. O(n log n).
std::size_t conditionCount(std::span<const ForceSample> samples);

// At least 240 cuts of a material, calculated from the cited tables over what a student's lathe does: depths of 0.2 to
// 3 mm, feeds of 0.05 to 0.4 mm, speeds of 30 to 200 m/min. By the handbook's law where its row for the material is
// verified, else by Kienzle's; the origin says so.
ForceSamples syntheticSamples(const WorkMaterial& material, const KosilovaTables& tables);

// The power law that comes nearest to the samples, in logarithms and by least squares. What all samples have in common
// gets the exponent 0; exponents stay within ±kMostExponent. There must be a sample. O(n).
PowerLaw fittedPowerLaw(std::span<const ForceSample> samples);
inline constexpr double kMostExponent = 10.0;

}  // namespace handwheel
