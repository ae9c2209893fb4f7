// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "machining/lathe/LatheSetup.h"
#include "machining/program/ToolPath.h"
#include "nurbs/BezierArc.h"
#include "nurbs/StockCylinder.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

enum class ProgramDialect { LinuxCnc, Fanuc };

// A tool as the table of a machine has it.
struct ProgramTool {
  double noseRadius = 0.0;    // mm; 0: an ideal point
  int orientation = 0;        // 0…9, in the numbers of the dialect
  ProfilePoint offset{0, 0};  // mm, (r, z), of the tip
  // The tool of the lathe that it is: its holder, the post and the slide behind it must meet nothing. Null: it is not
  // known, and only its tip is looked at. It cuts with its nose either way.
  std::shared_ptr<const LatheTool> body = {};
};

// What a body of a tool may meet besides the work. Places are from the lower end of the part.
struct ProgramLathe {
  LatheChuck chuck;
  LatheTailstock tailstock;
  std::shared_ptr<const LatheTool> drill;  // in the tailstock; null: none
};

// From the centre of the nose to the point that a program controls, in radii of the nose: (r, z), each -1, 0 or 1.
// Orientations outside 0…9 are as 0.
ProfilePoint tipDirection(ProgramDialect dialect, int orientation);
// The orientation of a tool that turns the outside towards the chuck.
int outsideOrientation(ProgramDialect dialect);
// Of one that bores towards the chuck.
int boreOrientation(ProgramDialect dialect);
// That of a tool of the lathe.
int orientationOf(const LatheTool& tool, ProgramDialect dialect);
// A tool of the lathe as the table of a machine has it; of a drill the nose has its diameter.
ProgramTool programToolOf(std::shared_ptr<const LatheTool> tool, ProgramDialect dialect);

using ProgramTools = std::map<int, ProgramTool>;  // by number

// The same tools: their tips point where they did, in the numbers of another dialect.
ProgramTools inDialect(ProgramTools tools, ProgramDialect from, ProgramDialect to);

// The machine on which a program runs.
struct ProgramSetup {
  ProgramDialect dialect = ProgramDialect::LinuxCnc;
  ProgramTools tools;
  ProgramTool standard;                    // what any other number has
  ProfilePoint reference{0, 0};            // mm, (r, z): machine zero, in the coordinates of the part
  double grip = 0.0;                       // mm of the part, from its lower end, that the chuck holds
  double allowance = 0.0;                  // mm of the bar beyond z = 0, to be faced
  std::optional<ProgramLathe> lathe = {};  // for the bodies of tools; none: they meet the work alone
  double rapidSpeed = 5000.0;              // mm/min
  double toolChange = 2.0;                 // s
  std::uint64_t mostBlocks = 5'000'000;
  std::size_t mostMoves = 2'000'000;
  bool skipsMarked = false;  // blocks that begin with '/'

  const ProgramTool& tool(int number) const;
  const ProgramTool& toolOf(const ToolMove& move) const { return tool(move.shape != 0 ? move.shape : move.tool); }
};

// The machine for a bar that goes beyond z = 0 by this allowance (mm), and whose lower end is in the chuck over this
// length (mm): every tool turns the outside with this nose (mm; 0: an ideal point), and machine zero is 100 mm above
// and beside the bar.
ProgramSetup usualSetup(ProgramDialect dialect, const StockCylinder& stock, double grip, double nose,
                        double allowance = 0.0);

// The tools in the text of a tool table of LinuxCNC: "T1 P1 X0 Z0 D0.8 Q2" (mm, D is a diameter). Where the comment of
// a line begins with the id of one of the bodies, ";right-roughing", the tool has it, and its nose and orientation
// where the line does not say them. Error: Refused.
Result<ProgramTools> readToolTable(std::string_view text, const LatheTools& bodies = {},
                                   ProgramDialect dialect = ProgramDialect::LinuxCnc);
// The same as text.
std::string toolTableText(const ProgramTools& tools);

}  // namespace handwheel
