// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/TurningFidelity.h"

#include "base/Translatable.h"

namespace handwheel {

FidelitySetting turnSpacingSetting() {
  FidelitySetting s;
  s.id = "turn.spacing";
  s.label = translatable("Fidelity", "Sample spacing of a turned profile");
  s.unit = "mm";
  s.scale = FidelityScale::Logarithmic;
  s.least = 1e-3;
  s.largest = 2.0;
  s.standard = 0.013;
  s.presets = {0.013, 0.013, 0.001};
  s.error = {translatable("Fidelity", "largest distance of the profile from the exact shape"), "mm"};
  s.cost = {translatable("Fidelity", "CPU time of cutting and of the triangles that change"), "ms"};
  s.budget = FidelityBudget::Frame;
  return s;
}

FidelitySetting turnMethodSetting() {
  FidelitySetting s;
  s.id = "turn.method";
  s.label = translatable("Fidelity", "Method of cutting a turned profile");
  setChoices(s, {"trim", "poles"});
  s.standard = 0.0;
  s.presets = {0.0, 0.0, 0.0};
  s.error = {translatable("Fidelity", "largest distance of the profile from the exact shape"), "mm"};
  s.cost = {translatable("Fidelity", "CPU time of cutting and of the triangles that change"), "ms"};
  s.budget = FidelityBudget::None;
  return s;
}

FidelitySetting turnResolutionSetting() {
  FidelitySetting s;
  s.id = "turn.resolution";
  s.label = translatable("Fidelity", "Distance of the control points of a turned profile");
  s.unit = "mm";
  s.scale = FidelityScale::Logarithmic;
  s.least = 0.05;
  s.largest = 10.0;
  s.standard = 0.5;
  s.presets = {0.5, 0.097, 0.05};
  s.error = {translatable("Fidelity", "largest distance of the profile from the exact shape"), "mm"};
  s.cost = {translatable("Fidelity", "CPU time of cutting and of the triangles that change"), "ms"};
  s.budget = FidelityBudget::None;
  return s;
}

FidelitySetting turnStepSetting() {
  FidelitySetting s;
  s.id = "turn.step";
  s.label = translatable("Fidelity", "Step of the simulation of a lathe");
  s.unit = "ms";
  s.scale = FidelityScale::Logarithmic;
  s.least = 1.0;
  s.largest = 32.0;
  s.standard = 2.0;
  s.presets = {24.0, 7.6, 1.3};
  s.error = {translatable("Fidelity", "largest distance of the profile from the exact shape"), "mm"};
  s.cost = {translatable("Fidelity", "CPU time of a second of cutting"), "ms"};
  s.budget = FidelityBudget::None;  // a few hundredths of a core of its own
  return s;
}

}  // namespace handwheel
