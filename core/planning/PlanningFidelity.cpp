// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/PlanningFidelity.h"

#include "base/Translatable.h"
#include "planning/PathVerification.h"
#include "planning/RoutePlanning.h"

namespace handwheel {

FidelitySetting planResolutionSetting() {
  FidelitySetting s;
  s.id = "plan.resolution";
  s.label = translatable("Fidelity", "Resolution of the proof that a motion is free");
  s.unit = "mm";
  s.scale = FidelityScale::Logarithmic;
  s.least = 1e-3;
  s.largest = 1.0;
  s.standard = MotionCheckSettings().resolution;
  s.presets = {1.0, 0.056, 0.0032};
  s.error = {translatable("Fidelity", "collision-free motions near obstacles that are rejected"), "%"};
  s.cost = {translatable("Fidelity", "CPU time to prove a motion free"), "us"};
  return s;
}

FidelitySetting planShortcutsSetting() {
  FidelitySetting s;
  s.id = "plan.shortcuts";
  s.label = translatable("Fidelity", "Attempts to make a planned path shorter");
  s.scale = FidelityScale::Logarithmic;
  s.least = 1.0;
  s.largest = 500.0;
  s.whole = true;
  s.standard = RouteSettings().shortcuts;
  s.presets = {5.0, 38.0, 500.0};
  s.error = {translatable("Fidelity", "mean length of paths beyond the shortest one known"), "%"};
  s.cost = {translatable("Fidelity", "CPU time to plan a path and make it shorter"), "ms"};
  return s;
}

FidelitySetting verifyStepSetting() {
  FidelitySetting s;
  s.id = "verify.step";
  s.label = translatable("Fidelity", "Step of the checks of motions that are not proven free");
  s.unit = "rad";
  s.scale = FidelityScale::Logarithmic;
  s.least = 1e-3;
  s.largest = 0.3;
  s.standard = kVerificationStep;
  s.presets = {0.3, 0.072, 0.011};
  s.error = {translatable("Fidelity", "colliding motions that checks at this step alone miss"), "%"};
  s.cost = {translatable("Fidelity", "CPU time to check a motion"), "us"};
  return s;
}

}  // namespace handwheel
