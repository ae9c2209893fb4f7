// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/TurnedProfile.h"
#include "machining/program/ProgramSetup.h"
#include "machining/program/cycles/RoughAndFinish.h"

#include <string>

namespace handwheel {

// The task of making cycles: a target, and the part that it is cut from.
struct CycleTask {
  const TargetProfile& target;
  const StockCylinder& stock;              // the bar
  const TurnedProfile& part;               // the bar, or the part cut from it so far
  double base = 0.0;                       // mm, z of the part's lower end in the coordinates of the target
  double grip = 0.0;                       // mm, length of the part in the chuck, from its lower end
  LatheTools tools = {};                   // tools of the lathe, for bores
  std::optional<ProgramLathe> lathe = {};  // the lathe; none: a chuck with this grip
  double allowance = 0.0;                  // mm, length of the part beyond z = 0 of the program
};

// The largest height of material that cycles leave on their target, above its lower end.
struct CycleRest {
  static constexpr double kConsiderable = 0.5;  // mm; a nose leaves less in a corner

  double height = 0.0;  // mm
  double z = 0.0;       // z of the program
  bool isInBore = false;

  bool isConsiderable() const { return height > kConsiderable; }
};

// A program of cycles, with the tools of its simulation. The tools that turn the outside consist of a nose alone.
struct CycleProgram {
  std::string text;
  ProgramTools tools;
  CycleRest rest = {};
  double drill = 0.0;  // mm, diameter of its drill; 0: none
};

// Returns a program that makes the target. It consists of faceCuts() if the part extends beyond the face of the target,
// drillAndBore() if the settings have a drill, and roughAndFinish(). Its z = 0 is below the upper end of the part by
// the allowance. The program is simulated before it is returned: it collides nowhere, not even with the chuck, and cuts
// at most 0.005 mm into the target. Errors: CyclesCollide, CyclesGouge, Cancelled, and the errors of the three
// functions.
Result<CycleProgram> cycleProgram(const CycleTask& task, ProgramDialect dialect, const CycleSettings& settings,
                                  Progress progress = {});

// Returns the program with the largest drill of the lathe that makes the bore of the target, or without a drill if the
// target has no bore. Errors: those of cycleProgram() with the largest drill that fits, whyNoDrill().
Result<CycleProgram> cycleProgramWithDrill(const CycleTask& task, ProgramDialect dialect, CycleSettings settings,
                                           Progress progress = {});

}  // namespace handwheel
