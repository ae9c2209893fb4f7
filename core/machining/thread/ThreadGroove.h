// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"

#include <vector>

namespace handwheel {

// The helical groove that a thread pass leaves, or all of its starts. The edge of the tool runs along a helix whose
// depth may change along the axis. At the end of the pass it runs out within a quarter of a turn, like a tool that is
// drawn back.
class ThreadGroove {
 public:
  static constexpr double kMostTurns = 500.0;         // limit of the turns of all starts together
  static constexpr double kRunOut = 0.25;             // turns
  static constexpr std::size_t kMostBottoms = 4'096;  // limit of the points of its bottom

  // Returns the grooves of a pass. The bottom rises and falls along z like the path; a path that goes back leaves two
  // grooves or more. Empty if the pass cuts no thread, or more than kMostTurns.
  static std::vector<ThreadGroove> of(const TurningPass& pass);

  const ThreadCut& cut() const { return m_cut; }
  TurningSide side() const { return m_side; }
  double noseRadius() const { return m_nose; }          // mm
  double from() const { return m_bottom.front().y(); }  // mm, height of its lower end, without the run-out
  double to() const { return m_bottom.back().y(); }
  double deepest() const { return m_deepest; }  // mm, least radius of the bottom; largest in a bore

  // Returns the radius (mm) of the surface that the edge swept at a height and an angle about the axis; infinite
  // outside of the sweep, or 0 in a bore.
  double radius(double z, double angle) const;

  bool touches(const TurnedProfile& profile) const;  // true if it removes material; O(samples)

  // Returns true if nothing of this groove is left beside the other one, which is deeper.
  bool isWithin(const ThreadGroove& other) const;

 private:
  ThreadGroove(const TurningPass& pass, std::vector<ProfilePoint> bottom);
  double bottomAt(double z) const;  // mm; beyond the ends, with the run-out

  ThreadCut m_cut;
  TurningSide m_side = TurningSide::Outside;
  double m_nose = 0.0;
  ThreadEdge m_edge;
  double m_deepest = 0.0;
  std::vector<ProfilePoint> m_bottom;  // (r, z), rising in z
};

}  // namespace handwheel
