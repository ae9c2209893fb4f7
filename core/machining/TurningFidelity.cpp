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

}  // namespace handwheel
