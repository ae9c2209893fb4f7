// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// A material to be drilled, with its force constants.
struct DrillMaterial {
  std::string id;           // stable, for files and the command line: "cortical-bone"
  std::string name;         // English
  double energy = 0.0;      // N/mm², kp of A-1: the work to a volume of chips
  double tangential = 0.0;  // ktc of A-5: the tangential force of the edges by the thrust
  std::string source;       // a sentence
  bool isVerified = false;  // measured, and the source was read
};

// Reads a table of materials as in resources/drilling/materials.json. Errors: those of parseJson(), ElementMalformed.
Result<std::vector<DrillMaterial>> drillMaterialsFromJson(std::string_view text);
// The materials that ship; the first is the usual one.
const std::vector<DrillMaterial>& drillMaterials();
// Null when unknown.
const DrillMaterial* drillMaterial(std::string_view id);

}  // namespace handwheel
