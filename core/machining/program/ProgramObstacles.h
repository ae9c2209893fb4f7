// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheCollisions.h"
#include "machining/program/ProgramSetup.h"

#include <map>

namespace handwheel {

// The obstacles that the tools of a program can hit. Chuck, jaws and tailstock are obstacles to the whole tool, its
// post and its slide. The work is an obstacle to the holder, the post and the slide, but not to the cutting edge. The
// contacts are judged as on the manual lathe (LatheRun).
class ProgramObstacles {
 public:
  // part: the part in the state in which the chuck gripped it.
  ProgramObstacles(const ProgramSetup& setup, const TurnedProfile& part);

  // Returns a contact of a tool whose tip is at this position in the part, (r, z), or nothing if the tool touches
  // nothing. O(sections + samples below them).
  std::optional<LatheCollision> contact(const LatheTool& tool, const ProfilePoint& tip, const TurnedProfile& part);

 private:
  std::map<const LatheTool*, std::vector<LatheSolid>> m_solids;  // cached sections of each tool
  std::vector<LatheSolid> m_standing;                            // chuck and tailstock
  double m_within = 0.0;                                         // mm; largest distance of material from the axis
};

// Returns the tip of the body of a tool. centre: the centre of the nose that the program moves. nose: the radius of
// that nose, mm.
ProfilePoint bodyTipFrom(const LatheTool& body, const ProfilePoint& centre, double nose);

}  // namespace handwheel
