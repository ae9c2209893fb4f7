// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelityRegistry.h"

#include <span>

namespace handwheel {

// One measurement of a setting. It is a row of the table, of the CSV file and of the stored curves.
struct FidelityRow {
  std::string setting;
  double value = 0.0;
  std::string testCase;
  double error = 0.0;
  std::string errorUnit;
  double cost = 0.0;  // median over the repeats
  std::string costUnit;
  double spread = 0.0;  // median absolute deviation of the cost from its median
  int repeats = 0;
  std::uint64_t seed = 0;
  std::string truth;
};

// Options of sweep().
struct SweepOptions {
  int steps = 9;  // number of values over the range, spread by its scale; the default and the presets are added
  int repeats = 5;
  std::uint64_t seed = 1;
};

// Computes the values at which a sweep measures a setting. They ascend, and each occurs once. They are all choices of a
// setting with choices; otherwise steps over the range (rounded to two digits if the scale is logarithmic), the default
// and the presets.
std::vector<double> sweepValues(const FidelitySetting& setting, int steps);

// Measures every test case at every value of a setting. Each repeat measures all values in turn, so that a machine that
// becomes slow affects all of them alike. The rows are sorted by case, and then by value. Errors: Cancelled.
Result<std::vector<FidelityRow>> sweep(const FidelitySetting& setting, std::span<const FidelityCase> cases,
                                       const SweepOptions& options, Progress progress = {});

// Returns the median of at least one value. The median of an even number of values is the mean of the middle two.
double median(std::vector<double> values);
double medianDeviation(const std::vector<double>& values);  // median absolute deviation from the median

// Formats measurements as comma-separated values (RFC 4180). Numbers are written as in the C locale. The first line is
// kFidelityCsvHeader.
std::string csvOf(const FidelitySetting& setting, std::span<const FidelityRow> rows);
inline constexpr std::string_view kFidelityCsvHeader =
    "setting,value,case,error,error_unit,cost,cost_unit,spread,repeats,seed,truth\n";

}  // namespace handwheel
