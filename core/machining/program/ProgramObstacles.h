// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheCollisions.h"
#include "machining/program/ProgramSetup.h"

#include <map>

namespace handwheel {

// The obstacles of the tools of a program besides the material that they cut. Chuck, jaws and tailstock can hit the
// whole tool, its post and its slide; the work can hit all but the edge. The same contacts as on the manual lathe
// (LatheRun).
class ProgramObstacles {
 public:
  // part: in the state in which the chuck gripped it.
  ProgramObstacles(const ProgramSetup& setup, const TurnedProfile& part);

  // Returns the contact of a tool whose tip is at this position in the part, (r, z), or nothing. O(sections, samples
  // below them).
  std::optional<LatheCollision> contact(const LatheTool& tool, const ProfilePoint& tip, const TurnedProfile& part);

 private:
  std::map<const LatheTool*, std::vector<LatheSolid>> m_solids;  // cache, by tool
  std::vector<LatheSolid> m_standing;                            // chuck and tailstock
  double m_within = 0.0;                                         // mm; largest distance of material from the axis
};

// Returns the tip of a tool's body from the centre of the nose that a program moves.
ProfilePoint bodyTipFrom(const LatheTool& body, const ProfilePoint& centre, double nose);

}  // namespace handwheel
