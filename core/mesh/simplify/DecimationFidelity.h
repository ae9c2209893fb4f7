// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "base/Translatable.h"
#include "mesh/simplify/Decimation.h"

namespace handwheel {

// Returns the setting mesh.decimation_method, for DecimationOptions::method. Its presets are derived from the
// measurements in resources/fidelity/mesh.decimation_method.json.
inline FidelitySetting decimationMethodSetting() {
  FidelitySetting s;
  s.id = "mesh.decimation_method";
  s.label = translatable("Fidelity", "Method of reducing triangles");
  setChoices(s, {translatable("Fidelity", "bounded"),
                 translatable("Fidelity", "quadric")});  // choices in the order of DecimationMethod
  s.standard = static_cast<double>(DecimationOptions().method);
  s.budget = FidelityBudget::Wait;
  s.presets = {0.0, 0.0, 0.0};
  s.error = {translatable("Fidelity", "largest distance from the mesh, in diagonals"), "%"};
  s.cost = {translatable("Fidelity", "CPU time to remove triangles"), "ms"};
  return s;
}

inline DecimationMethod decimationMethodOf(const FidelityValues& values) {
  return static_cast<DecimationMethod>(values.of(decimationMethodSetting()));
}

}  // namespace handwheel
