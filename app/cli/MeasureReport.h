// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelityCurve.h"
#include "plot/Plot.h"

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace handwheel {

// What was measured of one setting, and what follows from it.
struct MeasuredSetting {
  MeasuredSetting(const FidelitySetting& of, std::vector<FidelityRow> measured);

  // The point of the curve at a value that was measured.
  const CurvePoint& at(double value) const;

  FidelitySetting setting;
  std::vector<FidelityRow> rows;
  std::vector<CurvePoint> curve;  // of the worst of the cases
  std::vector<CurvePoint> front;  // of the relative curve
  std::optional<double> knee;
};

// How much a scene can afford, by the unit of the cost: {"ms", 16}.
using FidelityBudgets = std::map<std::string, double>;

// Columns as wide as their widest cell; the first two to the left, numbers to the right.
using TextRow = std::vector<std::string>;
std::string alignedTable(const std::vector<TextRow>& rows);

// The table and what follows from it, for people. Numbers have three digits.
std::string readableText(const MeasuredSetting& measured, const FidelityBudgets& budgets);
nlohmann::ordered_json toJson(const MeasuredSetting& measured, const FidelityBudgets& budgets);

// Error over cost, a series for each case; presets are marked where they cost most.
Plot plotOf(const MeasuredSetting& measured);

}  // namespace handwheel
