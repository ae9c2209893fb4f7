// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelitySweep.h"

#include <array>
#include <optional>

namespace handwheel {

// What one value of a setting costs and errs.
struct CurvePoint {
  double value = 0.0;
  double error = 0.0;  // infinite: no result
  double cost = 0.0;
  bool operator==(const CurvePoint&) const = default;
};

// The rows of one setting as a curve, values ascending: at each value the largest error and the largest cost of all
// cases, so that what is predicted by it holds for each of them.
std::vector<CurvePoint> curveOf(std::span<const FidelityRow> rows);

// The same in multiples of what the default errs and costs in the same case, so that each case has the same say: what
// values are chosen by. Where the default errs not at all, the largest error of the case takes its place. Empty where a
// case was not measured at the default.
std::vector<CurvePoint> relativeCurveOf(const FidelitySetting& setting, std::span<const FidelityRow> rows);

// The points that no other one beats or equals in both error and cost, in order of rising cost (and falling error).
// Points without a result have no part in it. Of equal points the first stays. O(n log n).
std::vector<CurvePoint> paretoFront(std::vector<CurvePoint> curve);

// Where paying more begins to bring little: the point of a front that lies furthest below the line through its ends,
// both axes scaled to 0…1 (Satopää, Albrecht, Irwin, Raghavan, "Finding a 'Kneedle' in a Haystack", 2011, offline and
// without smoothing). Where error falls as 1 / cost, that is the geometric mean of the costs at the ends. None where no
// point lies below the line.
std::optional<std::size_t> kneeOf(std::span<const CurvePoint> front);

// The presets that follow from a relative curve:
//  - Balanced is the knee of its front; without one, the point of the front nearest to the default.
//  - Exact is the most accurate of the front that costs at most kExactCost times as much as Balanced.
//  - Draft is the cheapest of the front that errs at most kDraftError times as much as Balanced.
// Where other values err no more and cost no more than kCostNoise above, the one nearest to the default is taken: what
// the measurement cannot tell apart is no reason to change anything. None where no value gives a result.
std::optional<std::array<double, 3>> derivedPresets(const FidelitySetting& setting, std::span<const CurvePoint> curve);
inline constexpr double kExactCost = 100.0;
inline constexpr double kDraftError = 10.0;
inline constexpr double kCostNoise = 0.05;

// Of the points that err no more than `goal` and cost no more than kCostNoise above it, the value nearest to the
// default.
double settledValue(const FidelitySetting& setting, std::span<const CurvePoint> curve, const CurvePoint& goal);

// The most accurate value whose cost keeps the budget with a third to spare; none where all cost more.
std::optional<CurvePoint> fitToBudget(std::span<const CurvePoint> curve, double budget);
inline constexpr double kBudgetShare = 2.0 / 3.0;

}  // namespace handwheel
