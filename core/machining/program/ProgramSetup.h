// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "machining/lathe/LatheSetup.h"
#include "machining/program/ToolPath.h"
#include "nurbs/BezierArc.h"
#include "nurbs/StockCylinder.h"

#include <ctime>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

enum class ProgramDialect { LinuxCnc, Fanuc };

// The position of the tool post and the side of the inserts. They decide how the spindle has to turn. M3 is clockwise,
// seen from the spindle towards the tailstock: the work comes down on a tool in front of the axis, between axis and
// operator, and comes up on a tool behind it. By default M3 cuts behind the axis with the insert facing down, as on
// most slant-bed lathes.
//
// The numbers of a program do not depend on the post. X+ points to the post, and G2, G3, G41 and G42 are seen along the
// axis Y, which points down if the post is in front. Seen from above, they then appear reversed.
struct ProgramPost {
  bool isInFront = false;
  bool isInsertUp = false;

  // Returns 1 if the tools of the post cut with M3, or -1 if they cut with M4.
  int cuttingSpin() const { return isInFront == isInsertUp ? 1 : -1; }
  bool operator==(const ProgramPost&) const = default;
};

// An entry of a machine's tool table.
struct ProgramTool {
  double noseRadius = 0.0;    // mm; 0: an ideal point
  int orientation = 0;        // 0…9, number of the orientation in the dialect
  ProfilePoint offset{0, 0};  // mm, (r, z), offset of the tip
  // The lathe tool of the entry. Its holder, its post and its slide must not touch anything. If the pointer is null,
  // the tool is not known, and only the tip is checked. The nose cuts in both cases.
  std::shared_ptr<const LatheTool> body = {};
  bool isTurnedOver = false;  // the insert faces the other side than those of the machine do
};

// The parts of a lathe that the body of a tool may hit besides the work. Positions count from the lower end of the
// part.
struct ProgramLathe {
  LatheChuck chuck;
  LatheTailstock tailstock;
  std::shared_ptr<const LatheTool> drill;  // drill in the tailstock; null: none
};

// Returns the vector (r, z) from the centre of the nose to the point that a program controls. Its unit is the radius of
// the nose; each component is -1, 0 or 1. Orientations outside 0…9 are treated as 0.
ProfilePoint tipDirection(ProgramDialect dialect, int orientation);
// Returns the orientation of a tool that turns the outside towards the chuck.
int outsideOrientation(ProgramDialect dialect);
// Returns the orientation of a tool that bores towards the chuck.
int boreOrientation(ProgramDialect dialect);
// Returns the orientation of a lathe tool.
int orientationOf(const LatheTool& tool, ProgramDialect dialect);
// Returns the table entry of a lathe tool. The nose of a drill has the diameter of the drill.
ProgramTool programToolOf(std::shared_ptr<const LatheTool> tool, ProgramDialect dialect);

using ProgramTools = std::map<int, ProgramTool>;  // tools, by their number

// Converts the orientations of tools to the numbers of another dialect. The tips keep their directions.
ProgramTools inDialect(ProgramTools tools, ProgramDialect from, ProgramDialect to);

// The machine on which a program runs.
struct ProgramSetup {
  ProgramDialect dialect = ProgramDialect::LinuxCnc;
  ProgramTools tools;
  ProgramTool standard;                    // the tool of all numbers that are not in `tools`
  ProfilePoint reference{0, 0};            // mm, (r, z); machine zero in the coordinates of the part
  double grip = 0.0;                       // mm, length of the part in the chuck, from its lower end
  double allowance = 0.0;                  // mm, length of the bar beyond z = 0, which is faced off
  std::optional<ProgramLathe> lathe = {};  // obstacles for the bodies of tools; none: only the work
  double rapidSpeed = 5000.0;              // mm/min
  double toolChange = 2.0;                 // s
  std::uint64_t mostBlocks = 5'000'000;
  std::size_t mostMoves = 2'000'000;
  std::time_t begin = 0;  // time at which the run begins, for the calendar of a Fanuc; 0: the present
  // Bit n skips what follows /n, for n from 1 to 9; / is /1. LinuxCNC has only /.
  std::uint16_t skips = 0;
  // A length without a decimal point counts in least increments, 0.001 mm or 0.0001 inch (Fanuc), not in mm or inch.
  bool hasIncrements = false;
  ProgramPost post;

  const ProgramTool& tool(int number) const;
  const ProgramTool& toolOf(const ToolMove& move) const { return tool(move.shape != 0 ? move.shape : move.tool); }
};

// Returns a machine for a bar that extends beyond z = 0 by the allowance (mm). Every tool turns the outside. Machine
// zero is 100 mm above and beside the bar. grip: the length of the lower end in the chuck, mm. nose: the radius of the
// nose of every tool, mm; 0: an ideal point.
ProgramSetup usualSetup(ProgramDialect dialect, const StockCylinder& stock, double grip, double nose,
                        double allowance = 0.0);

// Reads the tools from the text of a LinuxCNC tool table with lines such as "T1 P1 X0 Z0 D0.8 Q2" (mm; D is a
// diameter). The word upside-down in the comment of a line turns the tool over. If the comment of a line begins with
// the id of one of the bodies, for example ";right-roughing", the tool gets that body, and also its nose and
// orientation if the line does not give them. Orientations have the numbers of the dialect. notes: gets a note for each
// line whose comment begins with a word that is nearly such an id; may be null. Errors: Refused.
Result<ProgramTools> readToolTable(std::string_view text, const LatheTools& bodies = {},
                                   ProgramDialect dialect = ProgramDialect::LinuxCnc,
                                   std::vector<ToolPath::Note>* notes = nullptr);
// Returns the text of a LinuxCNC tool table with these tools.
std::string toolTableText(const ProgramTools& tools);

}  // namespace handwheel
