// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelitySweep.h"

#include <array>
#include <optional>

namespace handwheel {

// The error and the cost of one value of a setting.
struct CurvePoint {
  double value = 0.0;
  double error = 0.0;  // infinite: no result
  double cost = 0.0;
  bool operator==(const CurvePoint&) const = default;
};

// Computes the error and cost curve of a setting from its measurements. Values ascend; each has the largest error and
// the largest cost of all cases, so that a prediction from the curve holds for each of them.
std::vector<CurvePoint> curveOf(std::span<const FidelityRow> rows);

// Computes the error and cost curve of a setting relative to its default. Both are in multiples of those of the default
// in the same case, so that all cases have equal weight; values are chosen by this curve. If the default has no error,
// the largest error of the case is used instead. Empty if a case was not measured at the default.
std::vector<CurvePoint> relativeCurveOf(const FidelitySetting& setting, std::span<const FidelityRow> rows);

// Computes the Pareto front of a curve, in order of rising cost. It holds the points that no other one beats or equals
// in both error and cost; the error falls. Points without a result are left out. Of equal points the first stays.
// O(n log n).
std::vector<CurvePoint> paretoFront(std::vector<CurvePoint> curve);

// Finds the knee of a Pareto front, beyond which more cost gains little. It is the point that lies furthest below the
// line through the ends, both axes scaled to 0…1 (Satopää, Albrecht, Irwin, Raghavan, "Finding a 'Kneedle' in a
// Haystack", 2011, offline and without smoothing). Where error falls as 1 / cost, that is the geometric mean of the
// costs at the ends. None where no point lies below the line.
std::optional<std::size_t> kneeOf(std::span<const CurvePoint> front);

// Derives the presets of a setting from its relative curve:
//  - Balanced is the knee of its front; without one, the point of the front nearest to the default.
//  - Exact is the most accurate of the front that costs at most kExactCost times as much as Balanced.
//  - Draft is the cheapest of the front with at most kDraftError times the error of Balanced.
// Where other values have no larger error and at most kCostNoise more cost, the one nearest to the default is taken: a
// difference below the accuracy of the measurement is no reason for a change. None where no value gives a result.
std::optional<std::array<double, 3>> derivedPresets(const FidelitySetting& setting, std::span<const CurvePoint> curve);
inline constexpr double kExactCost = 100.0;
inline constexpr double kDraftError = 10.0;
inline constexpr double kCostNoise = 0.05;

// Finds, among values about as good as `goal`, the nearest to the default. These have no larger error and at most
// kCostNoise more cost.
double valueNearestDefault(const FidelitySetting& setting, std::span<const CurvePoint> curve, const CurvePoint& goal);

// Finds the most accurate value that leaves a third of the budget unused. None where all cost more.
std::optional<CurvePoint> fitToBudget(std::span<const CurvePoint> curve, double budget);
inline constexpr double kBudgetShare = 2.0 / 3.0;

}  // namespace handwheel
