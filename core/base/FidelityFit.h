// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelityCurve.h"

namespace handwheel {

// What there is of each budget.
struct FitLimits {
  double core = 1e6;             // us in a second
  double standardRate = 1000.0;  // Hz, where no setting chooses the rate of the servo loop
  double frame = 1000.0 / 60.0;  // ms
  double wait = 1000.0;          // ms: later, a train of thought is broken (Miller, "Response time in man-computer
                                 // conversational transactions", 1968)
};

// A setting with its curve, values ascending: what each value errs in multiples of the default in the worst case, and
// what it costs in its own unit where it costs most.
struct FitCandidate {
  FidelitySetting setting;
  std::vector<CurvePoint> curve;
};
FitCandidate fitCandidate(const FidelitySetting& setting, std::span<const FidelityRow> rows);

struct FittedSetting {
  FidelitySetting setting;
  CurvePoint point;
  double standardCost = 0.0;
  bool isOver = false;  // no value keeps its part of the budget; this one costs least
};

// What is left of a budget: so much of it is used, in its unit, as the curves predict.
struct FitShare {
  FidelityBudget budget = FidelityBudget::None;
  double used = 0.0;
  double limit = 0.0;
};

struct FidelityFit {
  FidelityValues values{FidelityPreset::Balanced};  // for what has no budget or no curve
  std::vector<FittedSetting> settings;
  std::vector<FitShare> shares;  // in the order of FidelityBudget
};

// The most accurate values that leave a third of each budget to spare (kBudgetShare):
//  - the rate of the servo loop first: its period is the budget of a tick, and stiffness has to be paid for in ticks;
//  - n settings that share a budget have an n-th of it each;
//  - those of Fill, where costs multiply, may each make the costliest fill longer by the n-th root of what there is.
// Of values that err no more and cost hardly more, the one nearest to the default is taken, as by derivedPresets().
FidelityFit fitToScene(std::span<const FitCandidate> candidates, const FitLimits& limits = {});

}  // namespace handwheel
