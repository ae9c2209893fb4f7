// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheCollisions.h"
#include "machining/program/ProgramSetup.h"

#include <map>

namespace handwheel {

// The obstacles of the tools of a program besides the material that they cut. Chuck, jaws and tailstock meet all of the
// tool, its post and its slide; the work all but the edge. The same contacts as on the manual lathe (LatheRun).
class ProgramObstacles {
 public:
  // part: as the chuck has gripped it.
  ProgramObstacles(const ProgramSetup& setup, const TurnedProfile& part);

  // With the tip of a tool at a place of the part, (r, z); none: it meets nothing. O(sections, samples below them).
  std::optional<LatheCollision> contact(const LatheTool& tool, const ProfilePoint& tip, const TurnedProfile& part);

 private:
  std::map<const LatheTool*, std::vector<LatheSolid>> m_solids;  // of the tools that were asked for
  std::vector<LatheSolid> m_standing;                            // chuck and tailstock
  double m_within = 0.0;                                         // mm: no material is further from the axis
};

// From the centre of the nose of a tool of a program to the tip of its body.
ProfilePoint bodyTipFrom(const LatheTool& body, const ProfilePoint& centre, double nose);

}  // namespace handwheel
