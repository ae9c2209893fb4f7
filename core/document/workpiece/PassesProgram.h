// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"
#include "machining/program/ProgramWriter.h"

namespace handwheel {

// A pass that a program leaves out.
struct LeftOutPass {
  std::size_t number = 1;                      // number of the pass, from 1
  std::shared_ptr<const LatheTool> tool = {};  // null: a round nose alone
  PassRefusal reason = PassRefusal::Abrasive;
};

// The passes of a workpiece as a program with its tools. The program makes the same part again, but for the passes that
// it leaves out.
struct PassesProgram {
  std::string text;
  ProgramTools tools;                // T1 is the tool of the first pass
  std::vector<LeftOutPass> leftOut;  // in the order of the passes
};

// Returns a sentence on a pass that was left out, such as "Pass 3, P120: A file, paper or a disk follows …". English.
std::string textOf(const LeftOutPass& pass);

// Returns the mean spindle speed of the recorded passes, r/min. It is the default for a program of these passes.
double recordedSpindle(const WorkpieceSnapshot& workpiece);

// Writes the passes of a workpiece as a program. Passes that no program can repeat are left out, and named in comments
// of the program. Errors: NoPasses, OtherTools if no pass is left.
Result<PassesProgram> passesProgram(const WorkpieceSnapshot& workpiece, ProgramDialect dialect, const PassProgram& how);

}  // namespace handwheel
