// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelityCurve.h"

namespace handwheel {

// The available amount of each budget.
struct FitLimits {
  double core = 1e6;             // µs per second
  double standardRate = 1000.0;  // rate of the servo loop if no setting chooses it, Hz
  double frame = 1000.0 / 60.0;  // ms
  double wait = 1000.0;  // ms; longer waits interrupt the user's thoughts (Miller, "Response time in man-computer
                         // conversational transactions", 1968)
};

// A setting with its error and cost curve. The values ascend. The error of a point is that of the worst case, in
// multiples of the error of the default; the cost is that of the costliest case, in the unit of the setting.
struct FitCandidate {
  FidelitySetting setting;
  std::vector<CurvePoint> curve;
};
FitCandidate fitCandidate(const FidelitySetting& setting, std::span<const FidelityRow> rows);

// A setting with the value chosen for it.
struct FittedSetting {
  FidelitySetting setting;
  CurvePoint point;
  double standardCost = 0.0;
  bool isOver = false;  // true: no value is within its part of the budget; this value costs least
};

// The predicted use and the limit of a budget, in the unit of the budget.
struct FitShare {
  FidelityBudget budget = FidelityBudget::None;
  double used = 0.0;
  double limit = 0.0;
};

// The settings that fit the time budgets of a machine.
struct FidelityFit {
  FidelityValues values{FidelityPreset::Balanced};  // Balanced for settings without a budget or a curve
  std::vector<FittedSetting> settings;
  std::vector<FitShare> shares;  // in the order of FidelityBudget
};

// Chooses the most accurate values that leave a third of each budget unused (kBudgetShare):
// - The rate of the servo loop is chosen first: its period is the time that settings with the budget Tick may use.
// - If n settings use the same budget, each gets an n-th of it.
// - If n settings use the budget Fill, whose costs multiply, each may lengthen the costliest fill by the n-th root of
//   the available factor.
//
// Among values with no larger error and hardly more cost, the value nearest to the default is chosen, as in
// derivedPresets().
FidelityFit chooseWithinBudgets(std::span<const FitCandidate> candidates, const FitLimits& limits = {});

}  // namespace handwheel
