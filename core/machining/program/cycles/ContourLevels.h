// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/cycles/ContourSegment.h"
#include "machining/program/cycles/CycleBudget.h"

namespace handwheel {

// Roughs the region outside of a contour in levels, downwards from its start. ContourCycle uses this class. The contour
// must run in the direction -z. A level is cut from its entry into the material to its end at the contour. A pocket of
// the contour is cut when the contour has been followed to the pocket.
class ContourLevels {
 public:
  // depth: the depth of a level. retract: the length of the escape of 45 degrees at the end of a level. Throws
  // ProgramRefusal if there would be too many levels.
  ContourLevels(const std::vector<ContourSegment>& contour, double depth, double retract,
                const SourceLocation& location, CycleBudget& work);

  // Cuts the levels. mode: 0 cuts everything, 1 all but the pockets, 2 only the pockets and the material that mode 1
  // leaves.
  void cut(int mode, const CycleOutput& out);

 private:
  using Index = std::size_t;
  enum class Dive { Moved, Climbs };

  // Each of these functions moves along one segment from m_at. The result Climbs means that the segment does not go
  // down at m_at.
  Dive dive(const ContourSegment& segment, double level, bool isIn);
  Dive diveLine(const ContourSegment& line, double level, bool isIn);
  Dive diveArc(const ContourSegment& arc, double level);
  bool climb(const ContourSegment& segment);  // false: the segment goes down at m_at, or from the position reached
  void climbOnly(const ContourSegment& segment);
  void climbRest(const ContourSegment& arc);
  // Cuts the level at m_at, and advances p if the level begins at a later segment.
  void cutLevel(Index& p, double& level);
  // Follows the contour from p to the next pocket. Returns false at the end of the contour.
  bool follow(Index& p, int mode);
  void spend();

  const std::vector<ContourSegment>& m_contour;
  double m_depth, m_retract;
  SourceLocation m_location;
  CycleBudget& m_work;
  const CycleOutput* m_out = nullptr;
  PlanePoint m_at;
  std::vector<PlanePoint> m_pockets;  // start of the levels of each pocket
  int m_steps = 0;
};

}  // namespace handwheel
