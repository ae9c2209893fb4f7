// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/cycles/ContourSegment.h"
#include "machining/program/cycles/CycleBudget.h"

namespace handwheel {

// The differences between controls that rough in levels.
struct RoughingMode {
  bool cutsStart = true;     // the first level is that of the start (LinuxCNC), not a depth of cut below it (Fanuc)
  bool followsWall = false;  // a level ends along the contour, up to the level before (Fanuc, type II)
};

// Roughs the region outside of a contour in levels, downwards from its start. ContourCycle uses this class. The contour
// must run in the direction -z. A level is cut from its entry into the material to its end at the contour. A pocket of
// the contour is cut when the contour has been followed to the pocket.
class ContourLevels {
 public:
  // depth: the depth of a level. retract: the length of the escape of 45 degrees at the end of a level. Throws
  // ProgramRefusal if there would be too many levels.
  ContourLevels(const std::vector<ContourSegment>& contour, double depth, double retract, const RoughingMode& mode,
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
  // Follows the contour upwards from a point of segment i to a level, or as far as it climbs. Returns the end.
  PlanePoint followWall(Index i, PlanePoint from, double top);
  double firstLevel() const { return m_pockets.back().imag() - (m_mode.cutsStart ? 0.0 : m_depth); }
  void spend();

  const std::vector<ContourSegment>& m_contour;
  double m_depth, m_retract;
  RoughingMode m_mode;
  SourceLocation m_location;
  CycleBudget& m_work;
  const CycleOutput* m_out = nullptr;
  PlanePoint m_at;
  std::vector<PlanePoint> m_pockets;  // start of the levels of each pocket
  int m_steps = 0;
};

}  // namespace handwheel
