// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/ProximityFidelity.h"

#include "base/Translatable.h"
#include "collision/DistanceForce.h"

namespace handwheel {

FidelitySetting proximityToleranceSetting() {
  FidelitySetting s;
  s.id = "proximity.tolerance";
  s.label = translatable("Fidelity", "Tolerance of the distances that are felt");
  s.unit = "mm";
  s.scale = FidelityScale::Logarithmic;
  s.least = 1e-5;
  s.largest = 0.3;
  s.standard = DistanceForceSettings().tolerance;
  s.presets = {0.3, 0.13, 1e-3};
  s.error = {translatable("Fidelity", "largest error of a distance"), "mm"};
  s.cost = {translatable("Fidelity", "CPU time of a query"), "us"};
  return s;
}

}  // namespace handwheel
