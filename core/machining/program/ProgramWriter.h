// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/program/ProgramSetup.h"
#include "machining/program/ToolPath.h"

#include <span>
#include <string>

namespace handwheel {

// Writes moves as a lathe program. The interpreter reads it as the same path to 1e-4 mm, and so does a machine. The
// program uses millimetres, diameters, and arcs with I and K. A move with another tool number changes the tool;
// unchanged words are not repeated. comments: the lines that follow the title.
std::string programText(std::span<const ToolMove> moves, ProgramDialect dialect, const std::string& title,
                        std::span<const std::string> comments = {});

// The mean speed of the spindle in passes, weighted by time.
class MeanSpindle {
 public:
  static constexpr double kUsual = 500.0;  // r/min, for passes that do not record their spindle speed
  void add(const TurningPass& pass);
  double speed() const;  // r/min, a whole number

 private:
  double m_turns = 0.0, m_seconds = 0.0;
};

// Options of the conversion of recorded passes to a program.
struct PassProgram {
  double spindle = 0.0;     // r/min; 0: the mean speed of the passes (MeanSpindle)
  double tolerance = 1e-3;  // mm; a point nearer than this to the line between its neighbours is left out
  double clearance = 2.0;   // mm, distance from the part between passes
  ProgramPost post;
};

// A tool of a program for recorded passes.
struct PassTool {
  int number = 1;                              // the number of the T word
  double noseRadius = 0.0;                     // mm
  std::shared_ptr<const LatheTool> tool = {};  // null: a round nose alone
  TurningSide side = TurningSide::Outside;     // side that the tool cuts
  int orientationIn(ProgramDialect dialect) const;
};

// Returns the tools of passes in the order of their first use, numbered from T1. Noses of different radius are
// different tools.
std::vector<PassTool> toolsOf(std::span<const TurningPass> passes);
// Returns a description for the head of a program, for example "T2: CNMG 120408, nose 0.8, orientation 2".
std::string descriptionOf(const PassTool& tool, ProgramDialect dialect);
// The reason why a program cannot repeat a pass.
enum class PassRefusal {
  Abrasive,    // a file, paper or disk follows the hand
  ThreadEdge,  // the edge of the thread is not the point of 60° that programs cut with
  WrongSide,   // the tool cut on a side that it is not made for
};
// Returns the reason why no program can repeat a pass, or nothing if one can. A programmable pass turns, grooves, parts
// off, forms, bores, drills or cuts a thread.
std::optional<PassRefusal> refusalToProgram(const TurningPass& pass);
const char* sentenceOf(PassRefusal refusal);  // English text, translated in the context "LathePart"

// Sets the sense in which the spindle turns for the tools of a post. Threads keep theirs, and drills cut with M3.
// tools: the tool table of the moves.
void setSpins(std::span<ToolMove> moves, const ProgramTools& tools, const ProgramPost& post);

// Returns the moves that repeat recorded passes, each with its tool of toolsOf(). The tool approaches a pass from
// above, or a bore from in front, follows the pass, and leaves the part. Each move has the feed per revolution of the
// pass, independently of the spindle speed. A pass that does not record its spindle speed has its mean feed per minute.
// A program moves the tip of a tool. The tip of a round nose alone is the corner of its tangents towards the chuck and
// the axis, or in a bore away from the axis. stock: the bar of the first pass; its position does not matter. zero: the
// height of z = 0 above the lower end of the part, mm.
std::vector<ToolMove> movesOf(std::span<const TurningPass> passes, const StockCylinder& stock, double zero,
                              const PassProgram& how);

}  // namespace handwheel
