// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramObstacles.h"

#include <algorithm>

namespace handwheel {

// The tailstock stands still, with its quill retracted: no program moves it.
ProgramObstacles::ProgramObstacles(const ProgramSetup& setup, const TurnedProfile& part) {
  for (std::size_t i = 0; i < part.size(); ++i) m_within = std::max(m_within, part.radius(i));
  if (!setup.lathe) return;
  m_standing = chuckSolids(setup.lathe->chuck, grippedRadius(part, setup.lathe->chuck));
  const LatheTailstock& tailstock = setup.lathe->tailstock;
  const auto tail = tailstockSolids(tailstock, tailstock.position, setup.lathe->drill.get());
  m_standing.insert(m_standing.end(), tail.begin(), tail.end());
}

std::optional<LatheCollision> ProgramObstacles::contact(const LatheTool& tool, const ProfilePoint& tip,
                                                        const TurnedProfile& part) {
  const auto known = m_solids.find(&tool);
  const auto& solids = known != m_solids.end() ? known->second : (m_solids[&tool] = toolSolids(tool));
  if (auto standing = contactBetween(solids, tip, m_standing)) return standing;
  return contactWithWork(solids, tip, tip, part, m_within);
}

// A drill turns about its own axis, with its tip in front of the nose that represents it.
ProfilePoint bodyTipFrom(const LatheTool& body, const ProfilePoint& centre, double nose) {
  if (body.kind == LatheToolKind::Drill) return centre - ProfilePoint(0.0, nose);
  return centre - body.noseCentre();
}

}  // namespace handwheel
