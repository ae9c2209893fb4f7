// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/cycles/ContourSegment.h"
#include "machining/program/cycles/CycleBudget.h"

namespace handwheel {

// Roughs the region outside of a contour in levels, from its start down. A part of ContourCycle. The contour goes on in
// -z. A level is cut from its entry into the material to its end at the contour; a pocket of the contour is cut when
// the contour has been followed to it.
class ContourLevels {
 public:
  // depth: depth of a level; retract: length of the escape of 45 degrees at its end. Refuses too many levels
  // (ProgramRefusal).
  ContourLevels(const std::vector<ContourSegment>& contour, double depth, double retract,
                const SourceLocation& location, CycleBudget& work);

  // mode: 0 all; 1 no pockets; 2 only the pockets, and what 1 leaves.
  void cut(int mode, const CycleOutput& out);

 private:
  using Index = std::size_t;
  enum class Dive { Moved, Climbs };

  // Each goes along one segment from m_at. Climbs: the segment does not go down here.
  Dive dive(const ContourSegment& segment, double level, bool isIn);
  Dive diveLine(const ContourSegment& line, double level, bool isIn);
  Dive diveArc(const ContourSegment& arc, double level);
  bool climb(const ContourSegment& segment);  // false: it goes down here, or from the position reached
  void climbOnly(const ContourSegment& segment);
  void climbRest(const ContourSegment& arc);
  // Cuts the level at m_at. Advances p if the level begins at a later segment.
  void cutLevel(Index& p, double& level);
  // Follows the contour from p on to the next pocket. Returns false at its end.
  bool follow(Index& p, int mode);
  void spend();

  const std::vector<ContourSegment>& m_contour;
  double m_depth, m_retract;
  SourceLocation m_location;
  CycleBudget& m_work;
  const CycleOutput* m_out = nullptr;
  PlanePoint m_at;
  std::vector<PlanePoint> m_pockets;  // begin of the levels of each pocket
  int m_steps = 0;
};

}  // namespace handwheel
