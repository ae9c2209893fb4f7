// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelityCurve.h"
#include "plot/Plot.h"

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace handwheel {

// The measurements of one setting and the values derived from them.
struct MeasuredSetting {
  MeasuredSetting(const FidelitySetting& of, std::vector<FidelityRow> measured);

  // Returns the point of the curve at a measured value.
  const CurvePoint& at(double value) const;

  FidelitySetting setting;
  std::vector<FidelityRow> rows;
  std::vector<CurvePoint> curve;  // costs and errors of the worst case
  std::vector<CurvePoint> front;  // Pareto front of relativeCurveOf()
  std::optional<double> knee;     // value at the knee of the front (kneeOf()); none: no knee
};

// The largest permitted cost of a setting, by unit of cost. An example is {"ms", 16}.
using FidelityBudgets = std::map<std::string, double>;

// The cells of a row of a table.
using TableRow = std::vector<std::string>;
// Formats rows as a table. Columns are as wide as their widest cell; the first two are left-aligned, the others
// right-aligned.
std::string alignedTable(const std::vector<TableRow>& rows);

// Formats the measurements and the derived values for people. Numbers have three digits.
std::string readableText(const MeasuredSetting& measured, const FidelityBudgets& budgets);
// Returns the measurements and the derived values as JSON.
nlohmann::ordered_json toJson(const MeasuredSetting& measured, const FidelityBudgets& budgets);

// Returns a plot of error over cost with one series per case. Presets are marked at the case with the largest cost.
Plot plotOf(const MeasuredSetting& measured);

}  // namespace handwheel
