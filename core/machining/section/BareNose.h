// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/section/TurnedSection.h"

namespace handwheel {

// A nose without a body, in a move that crosses no diagonal. It has a leading and a trailing edge if
// TurningPass::edges says so.
class BareNose {
 public:
  // end: where the tool no longer goes inward (WholeMove).
  BareNose(const TurningPass& how, const ProfileSegment& move, const ProfilePoint& end);

  // Returns cutters for what the nose sweeps, and for what is between it and the side of its shank.
  std::vector<SectionCutter> nose(const TurnedSection& section) const;
  // Returns the height at which the trailing edge ends to cut, or nothing if the tool does not face (cutMove()). It is
  // the same for all pieces of a move. pass: the number of the pass.
  std::optional<double> faceBehind(const TurnedSection& section, std::uint32_t pass) const;
  // Returns cutters for what the trailing edge sweeps up to that height.
  std::vector<SectionCutter> trailingEdge(const TurnedSection& section, double face) const;

 private:
  double tipAt(const ProfilePoint& p) const { return m_outward * p.x() - m_radius; }
  ProfilePoint toShank(const TurnedSection& section) const;
  bool isDeepEnough(const TurnedSection& section, std::uint32_t pass, double from, double to) const;
  bool hasOwnSurface(const TurnedSection& section, std::uint32_t pass, double from, double to) const;
  bool isFree(const TurnedSection& section, double z, double edge) const;
  bool isThrough(const TurnedSection& section, double z, double edge) const;
  template <class Visit>
  void eachOutward(const TurnedSection& section, double edge, double from, double to, Visit visit) const;

  ProfileSegment m_move;
  ProfilePoint m_end;
  // Coordinates to the side of the shank, and to the side of the trailing edge, are r and z times these signs.
  double m_radius, m_outward, m_trailing;
  bool m_isFacing;
};

}  // namespace handwheel
