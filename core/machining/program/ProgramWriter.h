// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/program/ProgramSetup.h"
#include "machining/program/ToolPath.h"

#include <span>
#include <string>

namespace handwheel {

// Writes moves as a lathe program. The interpreter, and a machine, reads it as the same path to 1e-4 mm. Millimetres,
// diameters, arcs with I and K. A move with another tool number changes the tool; unchanged words are not repeated.
// comments: separate lines after the title.
std::string programText(std::span<const ToolMove> moves, ProgramDialect dialect, const std::string& title,
                        std::span<const std::string> comments = {});

// The mean speed of the spindle in passes, by time.
class MeanSpindle {
 public:
  static constexpr double kUsual = 500.0;  // r/min, for passes that do not record theirs
  void add(const TurningPass& pass);
  double speed() const;  // r/min, a whole number

 private:
  double m_turns = 0.0, m_seconds = 0.0;
};

// Options of the conversion of recorded passes to a program.
struct PassProgram {
  double spindle = 0.0;     // r/min; 0: the mean of the passes (MeanSpindle)
  double tolerance = 1e-3;  // mm; points nearer than this to the line between their neighbours are left out
  double clearance = 2.0;   // mm, above the part between passes
};

// A tool of a program for recorded passes.
struct PassTool {
  int number = 1;                              // T
  double noseRadius = 0.0;                     // mm
  std::shared_ptr<const LatheTool> tool = {};  // null: a round nose alone
  TurningSide side = TurningSide::Outside;     // the side that it cuts
  int orientationIn(ProgramDialect dialect) const;
};

// Returns the tools of these passes, in the order of their first use, from T1. Noses of different radius are different
// tools.
std::vector<PassTool> toolsOf(std::span<const TurningPass> passes);
// Returns a description for the head of a program: "T2: CNMG 120408, nose 0.8, orientation 2".
std::string descriptionOf(const PassTool& tool, ProgramDialect dialect);
// Returns true if a program can repeat the pass: it turns, bores or drills, or cuts a thread on the outside.
bool isProgrammable(const TurningPass& pass);

// Returns the moves that repeat recorded passes, each with its tool of toolsOf(): to each pass from above, or to a bore
// from in front, along it, and away. The feed per revolution is that of the pass, move by move, whatever the spindle
// speed; for a pass that does not record its spindle speed it is the mean in a minute. A program moves the tip of a
// tool; for a round nose alone, the corner of its tangents towards the chuck and the axis, in a bore away from the
// axis. stock: bar of the first pass; its position does not matter. zero: mm, height of z = 0 above the lower end of
// the part.
std::vector<ToolMove> movesOf(std::span<const TurningPass> passes, const StockCylinder& stock, double zero,
                              const PassProgram& how);

}  // namespace handwheel
