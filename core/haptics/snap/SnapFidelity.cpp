// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/snap/SnapFidelity.h"

#include "base/Translatable.h"
#include "haptics/snap/SnapSum.h"

namespace handwheel {

FidelitySetting snapRadiusSetting() {
  FidelitySetting s;
  s.id = "snap.radius";
  s.label = translatable("Fidelity", "Snap distance");
  s.unit = translatable("Fidelity", "distances between features");
  s.scale = FidelityScale::Logarithmic;
  s.least = 0.3;  // smaller features are hardly ever hit
  s.largest = 3.0;
  s.standard = 0.4;
  s.presets = {0.4, 0.4, 0.4};
  s.error = {translatable("Fidelity", "features missed by a trembling hand"), "%"};
  s.cost = {translatable("Fidelity", "CPU time of a tick"), "us"};
  s.budget = FidelityBudget::Tick;
  return s;
}

FidelitySetting snapFeaturesSetting() {
  FidelitySetting s;
  s.id = "snap.features";
  s.label = translatable("Fidelity", "Features that attract at the same time");
  s.scale = FidelityScale::Logarithmic;
  s.least = 16.0;  // a corner of a mesh, its edges and its faces are 13
  s.largest = static_cast<double>(SnapSum::kLargest);
  s.whole = true;
  s.standard = static_cast<double>(SnapSum::kMost);
  s.presets = {64.0, 64.0, 1024.0};
  s.error = {translatable("Fidelity", "RMS difference from the sum of all forces"), "%"};
  s.cost = {translatable("Fidelity", "CPU time of a tick"), "us"};
  s.budget = FidelityBudget::Tick;
  return s;
}

}  // namespace handwheel
