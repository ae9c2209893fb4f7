// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"
#include "machining/program/ProgramWriter.h"

namespace handwheel {

// The passes of a workpiece as a program with its tools. The program makes the same part again.
struct PassesProgram {
  std::string text;
  ProgramTools tools;  // T1 is the tool of the first pass
};

// Returns the mean spindle speed of the recorded passes, r/min. It is the default for a program of these passes.
double recordedSpindle(const WorkpieceSnapshot& workpiece);

// Writes the passes of a workpiece as a program. Errors: NoPasses, OtherTools.
Result<PassesProgram> passesProgram(const WorkpieceSnapshot& workpiece, ProgramDialect dialect, const PassProgram& how);

}  // namespace handwheel
