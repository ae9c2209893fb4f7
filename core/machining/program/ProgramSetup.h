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

// An entry of a machine's tool table.
struct ProgramTool {
  double noseRadius = 0.0;    // mm; 0: an ideal point
  int orientation = 0;        // 0…9, in the numbers of the dialect
  ProfilePoint offset{0, 0};  // mm, (r, z), offset of the tip
  // The lathe tool of the entry: its holder, its post and its slide must not touch anything. Null: it is not known, and
  // only the tip is checked. The nose cuts in both cases.
  std::shared_ptr<const LatheTool> body = {};
};

// The lathe parts that the body of a tool may hit besides the work. Positions are from the lower end of the part.
struct ProgramLathe {
  LatheChuck chuck;
  LatheTailstock tailstock;
  std::shared_ptr<const LatheTool> drill;  // in the tailstock; null: none
};

// Returns the vector from the centre of the nose to the point that a program controls, in radii of the nose: (r, z),
// each -1, 0 or 1. Orientations outside 0…9 are treated as 0.
ProfilePoint tipDirection(ProgramDialect dialect, int orientation);
// Returns the orientation of a tool that turns the outside towards the chuck.
int outsideOrientation(ProgramDialect dialect);
// Returns the orientation of a tool that bores towards the chuck.
int boreOrientation(ProgramDialect dialect);
// Returns the orientation of a lathe tool.
int orientationOf(const LatheTool& tool, ProgramDialect dialect);
// Returns the table entry of a lathe tool; the nose of a drill has its diameter.
ProgramTool programToolOf(std::shared_ptr<const LatheTool> tool, ProgramDialect dialect);

using ProgramTools = std::map<int, ProgramTool>;  // by number

// Returns the same tools in the numbers of another dialect: their tips keep their directions.
ProgramTools inDialect(ProgramTools tools, ProgramDialect from, ProgramDialect to);

// The machine on which a program runs.
struct ProgramSetup {
  ProgramDialect dialect = ProgramDialect::LinuxCnc;
  ProgramTools tools;
  ProgramTool standard;                    // the tool of any other number
  ProfilePoint reference{0, 0};            // mm, (r, z): machine zero, in the coordinates of the part
  double grip = 0.0;                       // mm of the part, from its lower end, in the chuck
  double allowance = 0.0;                  // mm of the bar beyond z = 0, to be faced
  std::optional<ProgramLathe> lathe = {};  // for the bodies of tools; none: they can only hit the work
  double rapidSpeed = 5000.0;              // mm/min
  double toolChange = 2.0;                 // s
  std::uint64_t mostBlocks = 5'000'000;
  std::size_t mostMoves = 2'000'000;
  bool skipsMarked = false;  // skips blocks that begin with '/'

  const ProgramTool& tool(int number) const;
  const ProgramTool& toolOf(const ToolMove& move) const { return tool(move.shape != 0 ? move.shape : move.tool); }
};

// Returns the machine for a bar that extends beyond z = 0 by this allowance (mm), and whose lower end is in the chuck
// over this length (mm): every tool turns the outside with this nose (mm; 0: an ideal point), and machine zero is 100
// mm above and beside the bar.
ProgramSetup usualSetup(ProgramDialect dialect, const StockCylinder& stock, double grip, double nose,
                        double allowance = 0.0);

// Reads the tools from the text of a LinuxCNC tool table: "T1 P1 X0 Z0 D0.8 Q2" (mm, D is a diameter). If the comment
// of a line begins with the id of one of the bodies, ";right-roughing", the tool gets that body, and its nose and
// orientation if the line does not give them. Error: Refused.
Result<ProgramTools> readToolTable(std::string_view text, const LatheTools& bodies = {},
                                   ProgramDialect dialect = ProgramDialect::LinuxCnc);
// Returns the tools as text of such a table.
std::string toolTableText(const ProgramTools& tools);

}  // namespace handwheel
