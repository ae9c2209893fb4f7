// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "machining/TurningFidelity.h"
#include "machining/TurningPass.h"
#include "machining/force/WorkMaterials.h"
#include "machining/program/ProgramSetup.h"
#include "nurbs/StockCylinder.h"

#include <filesystem>
#include <optional>
#include <string>

namespace handwheel {

// The arguments of 'handwheel turn'. Lengths are in mm.
struct TurnRequest {
  std::string input;                 // path of a file, or the word for a bar
  std::optional<StockCylinder> bar;  // the bar of `input`
  std::filesystem::path recording, program, tools, target, output;
  std::optional<double> noseRadius;  // mm
  double spacing = turnSpacingSetting().standard;
  double spindle = 500.0;               // r/min, for a recording
  std::optional<TurningMethod> method;  // for a recording; none: the method in the recording, or Trim
  std::optional<double> resolution;     // mm, for TurningMethod::Poles
  ProgramDialect dialect = ProgramDialect::LinuxCnc;
  std::uint16_t skips = 0;          // block skips of the program that are on, as of ProgramSetup
  bool hasIncrements = false;       // lengths without a decimal point count in least increments
  std::optional<ProgramPost> post;  // none: that of the document
  WorkMaterial material;
  bool isMaterialGiven = false;  // by --material
  bool isReplay = false;
  bool asJson = false;
};

// Reads the arguments of 'handwheel turn'. Returns a sentence about a problem, or an empty string.
std::string readTurnRequest(const Arguments& arguments, TurnRequest& request);

}  // namespace handwheel
