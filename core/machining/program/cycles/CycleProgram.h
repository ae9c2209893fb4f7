// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/TurnedProfile.h"
#include "machining/program/ProgramSetup.h"
#include "machining/program/cycles/RoughAndFinish.h"

#include <string>

namespace handwheel {

// The task of making cycles: a target and the part that it is cut from.
struct CycleTask {
  const TargetProfile& target;
  const StockCylinder& stock;              // the bar
  const TurnedProfile& part;               // the bar, or the part cut from it so far
  double base = 0.0;                       // mm, z of the part's lower end in the coordinates of the target
  double grip = 0.0;                       // mm of the part, from its lower end, in the chuck
  LatheTools tools = {};                   // tools of the lathe, for bores
  std::optional<ProgramLathe> lathe = {};  // the lathe that makes it; none: a chuck with this grip
  double allowance = 0.0;                  // mm of the part beyond z = 0 of the program
};

// The most material that cycles leave over their target, above its lower end.
struct CycleRest {
  static constexpr double kConsiderable = 0.5;  // mm; a nose leaves less in a corner

  double height = 0.0;  // mm
  double z = 0.0;       // z of the program
  bool isInBore = false;

  bool isConsiderable() const { return height > kConsiderable; }
};

// A program of cycles, and the tools with which it was simulated. The tools that turn the outside are a nose alone.
struct CycleProgram {
  std::string text;
  ProgramTools tools;
  CycleRest rest = {};
};

// Returns the cycles of faceCuts(), if the part extends beyond the face of the target, of drillAndBore(), if there is a
// drill, and of roughAndFinish() as a program whose z = 0 is the upper end of the part but for the allowance. It is
// simulated before it is returned: it collides nowhere, not with the chuck either, and cuts no more than 0.005 mm into
// the target. Errors: CyclesCollide, CyclesGouge, Cancelled, those of both.
Result<CycleProgram> cycleProgram(const CycleTask& task, ProgramDialect dialect, const CycleSettings& settings,
                                  Progress progress = {});

}  // namespace handwheel
