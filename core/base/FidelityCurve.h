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

// Computes the error and cost curve of a setting from its measurements. The values ascend. Each point has the largest
// error and the largest cost of all cases, so that a prediction from the curve holds for every case.
std::vector<CurvePoint> curveOf(std::span<const FidelityRow> rows);

// Computes the error and cost curve of a setting relative to its default. Errors and costs are multiples of the error
// and cost of the default in the same case, so that all cases have equal weight. If the default has no error, the
// largest error of the case is used instead. Values are chosen by this curve. The result is empty if a case was not
// measured at the default.
std::vector<CurvePoint> relativeCurveOf(const FidelitySetting& setting, std::span<const FidelityRow> rows);

// Computes the Pareto front of a curve, in order of rising cost and falling error. It consists of the points for which
// no other point has at most the same error and at most the same cost. Points without a result are omitted. Of equal
// points, only the first is kept. O(n log n).
std::vector<CurvePoint> paretoFront(std::vector<CurvePoint> curve);

// Finds the knee of a Pareto front, beyond which more cost gains little. It is the point that lies furthest below the
// line through the ends, with both axes scaled to 0…1 (Satopää, Albrecht, Irwin, Raghavan, "Finding a 'Kneedle' in a
// Haystack", 2011, offline and without smoothing). If the error is proportional to 1 / cost, the cost at the knee is
// the geometric mean of the costs at the ends. Returns nothing if no point lies below the line.
std::optional<std::size_t> kneeOf(std::span<const CurvePoint> front);

// Derives the presets of a setting from its relative curve:
// - Balanced is the knee of the front; without a knee, the point of the front nearest to the default.
// - Exact is the most accurate point of the front that costs at most kExactCost times as much as Balanced.
// - Draft is the cheapest point of the front with at most kDraftError times the error of Balanced.
//
// For each of these, if other values have no larger error and at most kCostNoise more cost, the value nearest to the
// default is chosen: a difference below the accuracy of the measurement does not justify a change. Returns nothing if
// no value gives a result.
std::optional<std::array<double, 3>> derivedPresets(const FidelitySetting& setting, std::span<const CurvePoint> curve);
inline constexpr double kExactCost = 100.0;
inline constexpr double kDraftError = 10.0;
inline constexpr double kCostNoise = 0.05;

// Finds the value nearest to the default among the values that are about as good as `goal`. These have no larger error
// and at most kCostNoise more cost.
double valueNearestDefault(const FidelitySetting& setting, std::span<const CurvePoint> curve, const CurvePoint& goal);

// Finds the most accurate value that leaves a third of the budget unused. Returns nothing if all values cost more.
std::optional<CurvePoint> fitToBudget(std::span<const CurvePoint> curve, double budget);
inline constexpr double kBudgetShare = 2.0 / 3.0;

}  // namespace handwheel
