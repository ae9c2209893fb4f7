// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/FidelityCurve.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace handwheel {

std::vector<CurvePoint> curveOf(std::span<const FidelityRow> rows) {
  std::map<double, CurvePoint> byValue;
  for (const FidelityRow& row : rows) {
    CurvePoint& p = byValue.try_emplace(row.value, CurvePoint{row.value, row.error, row.cost}).first->second;
    p.error = std::max(p.error, row.error);
    p.cost = std::max(p.cost, row.cost);
  }
  std::vector<CurvePoint> curve;
  curve.reserve(byValue.size());
  for (const auto& entry : byValue) curve.push_back(entry.second);
  return curve;
}

std::vector<CurvePoint> relativeCurveOf(const FidelitySetting& setting, std::span<const FidelityRow> rows) {
  struct Unit {
    double error = 0.0, cost = 0.0, largestError = 0.0;
    bool isKnown = false;
  };
  std::map<std::string, Unit> units;  // by case
  for (const FidelityRow& row : rows) {
    Unit& unit = units[row.testCase];
    if (std::isfinite(row.error)) unit.largestError = std::max(unit.largestError, row.error);
    if (row.value != setting.standard) continue;
    unit.error = row.error;
    unit.cost = row.cost;
    unit.isKnown = std::isfinite(row.error);
  }
  std::vector<FidelityRow> relative(rows.begin(), rows.end());
  for (FidelityRow& row : relative) {
    const Unit& unit = units[row.testCase];
    if (!unit.isKnown) return {};
    const double error = unit.error > 0.0 ? unit.error : unit.largestError;
    if (error > 0.0) row.error /= error;
    if (unit.cost > 0.0) row.cost /= unit.cost;
  }
  return curveOf(relative);
}

std::vector<CurvePoint> paretoFront(std::vector<CurvePoint> curve) {
  std::erase_if(curve, [](const CurvePoint& p) { return !std::isfinite(p.error) || !std::isfinite(p.cost); });
  std::stable_sort(curve.begin(), curve.end(), [](const CurvePoint& a, const CurvePoint& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.error < b.error;
  });
  std::vector<CurvePoint> front;
  for (const CurvePoint& p : curve) {
    if (front.empty() || p.error < front.back().error) front.push_back(p);
  }
  return front;
}

std::optional<std::size_t> kneeOf(std::span<const CurvePoint> front) {
  if (front.size() < 3) return std::nullopt;
  const double costs = front.back().cost - front.front().cost;
  const double errors = front.front().error - front.back().error;
  std::optional<std::size_t> knee;
  double deepest = 0.0;
  for (std::size_t i = 1; i + 1 < front.size(); ++i) {
    const double x = (front[i].cost - front.front().cost) / costs;
    const double y = (front[i].error - front.back().error) / errors;
    const double depth = 1.0 - x - y;  // below the line from (0, 1) to (1, 0), times √2
    if (depth <= deepest) continue;
    deepest = depth;
    knee = i;
  }
  return knee;
}

double valueNearestDefault(const FidelitySetting& setting, std::span<const CurvePoint> curve, const CurvePoint& goal) {
  const double standard = scalePositionOf(setting, setting.standard);
  const auto distance = [&](double value) { return std::abs(scalePositionOf(setting, value) - standard); };
  double best = goal.value;
  for (const CurvePoint& p : curve) {
    const bool isAsGood = p.error <= goal.error && p.cost <= (1.0 + kCostNoise) * goal.cost;
    if (isAsGood && distance(p.value) < distance(best)) best = p.value;
  }
  return best;
}

std::optional<std::array<double, 3>> derivedPresets(const FidelitySetting& setting, std::span<const CurvePoint> curve) {
  const std::vector<CurvePoint> front = paretoFront({curve.begin(), curve.end()});
  if (front.empty()) return std::nullopt;
  const auto isNearer = [&](const CurvePoint& a, const CurvePoint& b) {
    const double standard = scalePositionOf(setting, setting.standard);
    return std::abs(scalePositionOf(setting, a.value) - standard) <
           std::abs(scalePositionOf(setting, b.value) - standard);
  };
  const std::optional<std::size_t> knee = kneeOf(front);
  const CurvePoint balanced = knee ? front[*knee] : *std::min_element(front.begin(), front.end(), isNearer);
  const auto draft = std::find_if(front.begin(), front.end(),
                                  [&](const CurvePoint& p) { return p.error <= kDraftError * balanced.error; });
  const auto exact = std::find_if(front.rbegin(), front.rend(),
                                  [&](const CurvePoint& p) { return p.cost <= kExactCost * balanced.cost; });
  return std::array{valueNearestDefault(setting, curve, *draft), valueNearestDefault(setting, curve, balanced),
                    valueNearestDefault(setting, curve, *exact)};
}

std::optional<CurvePoint> fitToBudget(std::span<const CurvePoint> curve, double budget) {
  std::optional<CurvePoint> best;
  for (const CurvePoint& p : paretoFront({curve.begin(), curve.end()})) {
    if (p.cost <= kBudgetShare * budget) best = p;  // the later, the more accurate
  }
  return best;
}

}  // namespace handwheel
