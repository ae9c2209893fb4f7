// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/step/StepFidelity.h"

#include "base/Translatable.h"
#include "document/formats/MeshFormat.h"

namespace handwheel {

FidelitySetting stepChordSetting() {
  FidelitySetting s;
  s.id = "step.chord";
  s.label = translatable("Fidelity", "Deviation of triangles from the surfaces of a STEP file to aim at");
  s.unit = translatable("Fidelity", "share of the diagonal");
  s.scale = FidelityScale::Logarithmic;
  s.least = 1e-5;
  s.largest = 1e-2;
  s.standard = ReadOptions().stepChord;
  s.presets = {1e-3, 2e-4, 1.8e-5};
  s.error = {translatable("Fidelity", "largest distance from the surface, in diagonals"), "%"};
  s.cost = {translatable("Fidelity", "triangles of the mesh"), translatable("Fidelity", "triangles")};
  return s;
}

}  // namespace handwheel
