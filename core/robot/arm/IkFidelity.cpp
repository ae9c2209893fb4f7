// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/arm/IkFidelity.h"

#include "base/Translatable.h"
#include "robot/arm/NumericalIk.h"

namespace handwheel {

FidelitySetting ikToleranceSetting() {
  FidelitySetting s;
  s.id = "ik.tolerance";
  s.label = translatable("Fidelity", "Tolerance of inverse kinematics by iteration");
  s.unit = "rad";
  s.scale = FidelityScale::Logarithmic;
  s.least = 1e-9;
  s.largest = 1e-2;
  s.standard = NumericalIkSettings().tolerance;
  s.presets = {1e-5, 1e-5, 1e-9};
  s.error = {translatable("Fidelity", "largest distance of the flange from its pose"), "mm"};
  s.cost = {translatable("Fidelity", "CPU time of a solution"), "us"};
  return s;
}

}  // namespace handwheel
