// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/FidelityFit.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

double costAt(std::span<const CurvePoint> curve, double value) {
  const auto at = std::find_if(curve.begin(), curve.end(), [&](const CurvePoint& p) { return p.value == value; });
  return at == curve.end() ? 0.0 : at->cost;
}

FittedSetting fitted(const FitCandidate& candidate, double part) {
  const FidelitySetting& setting = candidate.setting;
  FittedSetting result{setting, {}, costAt(candidate.curve, setting.standard), false};
  std::vector<CurvePoint> affordable = candidate.curve;
  std::erase_if(affordable, [part](const CurvePoint& p) { return !(p.cost <= kBudgetShare * part); });
  if (const auto best = fitToBudget(affordable, part)) {
    const double value = valueNearestDefault(setting, affordable, *best);
    result.point =
        *std::find_if(affordable.begin(), affordable.end(), [&](const CurvePoint& p) { return p.value == value; });
  } else {
    result.point = paretoFront(candidate.curve).front();
    result.isOver = true;
  }
  return result;
}

// All candidates of one budget, with their total use.
class Sharing {
 public:
  Sharing(FidelityBudget budget, double limit, std::span<const FitCandidate> candidates)
      : m_budget(budget), m_limit(limit) {
    for (const FitCandidate& c : candidates) {
      if (c.setting.budget == budget && !paretoFront(c.curve).empty()) m_candidates.push_back(&c);
    }
  }

  void addTo(FidelityFit& fit) const {
    if (m_candidates.empty()) return;
    const std::size_t first = fit.settings.size();
    for (const FitCandidate* c : m_candidates) {
      fit.settings.push_back(fitted(*c, partOf(*c)));
      [[maybe_unused]] const Status set = fit.values.set(c->setting, fit.settings.back().point.value);
    }
    fit.shares.push_back(
        {m_budget, used({fit.settings.begin() + static_cast<std::ptrdiff_t>(first), fit.settings.end()}), m_limit});
  }

 private:
  double partOf(const FitCandidate& candidate) const {
    const double n = static_cast<double>(m_candidates.size());
    if (m_budget != FidelityBudget::Fill) return m_limit / n;
    double costliest = 0.0;
    for (const FitCandidate* c : m_candidates) costliest = std::max(costliest, costAt(c->curve, c->setting.standard));
    if (!(costliest > 0.0)) return m_limit / n;
    const double own = costAt(candidate.curve, candidate.setting.standard);
    return own / kBudgetShare * std::pow(kBudgetShare * m_limit / costliest, 1.0 / n);
  }

  double used(std::span<const FittedSetting> settings) const {
    double sum = 0.0, costliest = 0.0, product = 1.0;
    for (const FittedSetting& s : settings) {
      sum += s.point.cost;
      costliest = std::max(costliest, s.standardCost);
      if (s.standardCost > 0.0) product *= s.point.cost / s.standardCost;
    }
    return m_budget == FidelityBudget::Fill ? costliest * product : sum;
  }

  FidelityBudget m_budget;
  double m_limit;
  std::vector<const FitCandidate*> m_candidates;
};

}  // namespace

FitCandidate fitCandidate(const FidelitySetting& setting, std::span<const FidelityRow> rows) {
  FitCandidate candidate{setting, curveOf(rows)};
  const std::vector<CurvePoint> relative = relativeCurveOf(setting, rows);
  for (std::size_t i = 0; i < relative.size(); ++i) candidate.curve[i].error = relative[i].error;
  return candidate;
}

FidelityFit chooseWithinBudgets(std::span<const FitCandidate> candidates, const FitLimits& limits) {
  FidelityFit fit;
  Sharing(FidelityBudget::Core, limits.core, candidates).addTo(fit);
  const double rate = fit.settings.empty() ? limits.standardRate : fit.settings.front().point.value;
  const std::pair<FidelityBudget, double> others[] = {{FidelityBudget::Tick, 1e6 / rate},
                                                      {FidelityBudget::Rate, rate},
                                                      {FidelityBudget::Frame, limits.frame},
                                                      {FidelityBudget::Wait, limits.wait},
                                                      {FidelityBudget::Fill, limits.wait}};
  for (const auto& [budget, limit] : others) Sharing(budget, limit, candidates).addTo(fit);
  return fit;
}

}  // namespace handwheel
