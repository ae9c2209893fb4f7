// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// A material that can be drilled, with its force constants.
struct DrillMaterial {
  std::string id;           // stable id for files and the command line, such as "cortical-bone"
  std::string name;         // English text
  double energy = 0.0;      // N/mm², kp of He 2008, A-1: the work per volume of chips
  double tangential = 0.0;  // ktc of He 2008, A-5: the tangential force of the edges divided by the thrust
  std::string source;       // source of the constants, a sentence
  bool isVerified = false;  // true if the constants were measured and the source was read
};

// Reads a table of materials in the form of resources/drilling/materials.json. Errors: the errors of parseJson(),
// ElementMalformed.
Result<std::vector<DrillMaterial>> drillMaterialsFromJson(std::string_view text);
// Returns the built-in materials; the first is the default.
const std::vector<DrillMaterial>& drillMaterials();
// Returns a built-in material, or null if the id is unknown.
const DrillMaterial* drillMaterial(std::string_view id);

}  // namespace handwheel
