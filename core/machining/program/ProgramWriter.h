// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/program/ProgramSetup.h"
#include "machining/program/ToolPath.h"

#include <span>
#include <string>

namespace handwheel {

// Writes moves as a program that the interpreter, and a machine, reads as the same path to 1e-4 mm. Millimetres,
// diameters, arcs with I and K. A tool of another number is changed to; what does not change is not repeated.
std::string programText(std::span<const ToolMove> moves, ProgramDialect dialect, const std::string& title);

// How recorded passes become a program.
struct PassProgram {
  double spindle = 500.0;   // r/min
  double tolerance = 1e-3;  // mm: points nearer than this to the line between their neighbours are left out
  double clearance = 2.0;   // mm, above the part between passes
};

// The moves that repeat recorded passes with a tool for the outside and their nose: to each pass from above, along it
// at its mean speed, and away. length: mm, of the part, whose upper end is z = 0.
std::vector<ToolMove> movesOf(std::span<const TurningPass> passes, double radius, double length,
                              const PassProgram& how);

}  // namespace handwheel
