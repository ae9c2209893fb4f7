// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelityCurve.h"

namespace handwheel {

// The available amount of each budget.
struct FitLimits {
  double core = 1e6;             // µs per second
  double standardRate = 1000.0;  // Hz, where no setting chooses the rate of the servo loop
  double frame = 1000.0 / 60.0;  // ms
  double wait = 1000.0;          // ms: later, a train of thought is broken (Miller, "Response time in man-computer
                                 // conversational transactions", 1968)
};

// A setting with its error and cost curve. Values ascend; the error is that of the worst case in multiples of the
// default's, the cost that of the costliest case in its own unit.
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
  bool isOver = false;  // no value stays within its part of the budget; this one costs least
};

// The predicted use of a budget and its limit, in its unit.
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
//  - the rate of the servo loop is chosen first: its period is the budget of a tick, and stiffness costs time per tick;
//  - n settings that share a budget get an n-th of it each;
//  - those of Fill, where costs multiply, may each lengthen the costliest fill by the n-th root of what is available.
// Of values with no larger error and hardly more cost, the one nearest to the default is taken, as by derivedPresets().
FidelityFit chooseWithinBudgets(std::span<const FitCandidate> candidates, const FitLimits& limits = {});

}  // namespace handwheel
