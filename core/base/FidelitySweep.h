// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelityRegistry.h"

#include <span>

namespace handwheel {

// One measurement of a setting. A row of the table, of the CSV file and of the curves kept as data.
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
  int steps = 9;  // values over the range, spread by its scale; default and presets come on top
  int repeats = 5;
  std::uint64_t seed = 1;
};

// Computes the values at which a sweep measures a setting. They ascend, each occurring once: all choices; else steps
// over the range (in two digits where the scale is logarithmic), default and presets.
std::vector<double> sweepValues(const FidelitySetting& setting, int steps);

// Measures every test case at every value of a setting. Repeats cycle through all values, so that a machine that
// becomes slow affects all alike. Rows: case by case, values ascending. Errors: Cancelled.
Result<std::vector<FidelityRow>> sweep(const FidelitySetting& setting, std::span<const FidelityCase> cases,
                                       const SweepOptions& options, Progress progress = {});

double median(std::vector<double> values);  // values: at least one; of an even number the mean of the middle two
double medianDeviation(const std::vector<double>& values);  // median absolute deviation from the median

// Formats measurements as comma-separated values (RFC 4180). Numbers are written as in C; kFidelityCsvHeader is the
// header line.
std::string csvOf(const FidelitySetting& setting, std::span<const FidelityRow> rows);
inline constexpr std::string_view kFidelityCsvHeader =
    "setting,value,case,error,error_unit,cost,cost_unit,spread,repeats,seed,truth\n";

}  // namespace handwheel
