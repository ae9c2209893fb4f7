// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"

#include <vector>

namespace handwheel {

// The helical groove that one pass cuts for all starts of a thread. The edge of the tool runs along a helix whose
// radius may change along the axis. Beyond both ends of the pass the groove runs out within a quarter of a turn, as it
// does when the tool is drawn back.
class ThreadGroove {
 public:
  static constexpr double kMostTurns = 500.0;         // largest number of turns, all starts together
  static constexpr double kRunOut = 0.25;             // turns
  static constexpr std::size_t kMostBottoms = 4'096;  // largest number of points of the bottom

  // Returns the grooves of a pass: one for each stretch of its path that runs in one direction along z. The bottom
  // follows the path. The result is empty if the pass cuts no thread; grooves that exceed kMostTurns or kMostBottoms
  // are left out.
  static std::vector<ThreadGroove> of(const TurningPass& pass);

  const ThreadCut& cut() const { return m_cut; }
  TurningSide side() const { return m_side; }
  double noseRadius() const { return m_nose; }          // mm
  double from() const { return m_bottom.front().y(); }  // mm, height of its lower end, without the run-out
  double to() const { return m_bottom.back().y(); }
  double deepest() const { return m_deepest; }  // mm, least radius of the bottom, or the largest one in a bore

  // Returns the radius (mm) of the surface that the edge swept, at a height and an angle about the axis. Outside of the
  // swept range it is infinite, or 0 if the groove is in a bore.
  double radius(double z, double angle) const;

  bool touches(const TurnedProfile& profile) const;  // true if it removes material; O(samples)

  // Returns true if the other groove, which is deeper, contains this one, so that nothing of it is left.
  bool isWithin(const ThreadGroove& other) const;

 private:
  ThreadGroove(const TurningPass& pass, std::vector<ProfilePoint> bottom);
  double bottomAt(double z) const;  // mm, radius of the bottom; beyond the ends, that of the run-out

  ThreadCut m_cut;
  TurningSide m_side = TurningSide::Outside;
  double m_nose = 0.0;
  ThreadEdge m_edge;
  double m_deepest = 0.0;
  std::vector<ProfilePoint> m_bottom;  // (r, z) in ascending order of z
};

}  // namespace handwheel
