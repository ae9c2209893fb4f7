// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/PassSteps.h"

#include "machining/section/SectionSource.h"

namespace handwheel {

namespace {

ProfileSegment moveTo(const TurningPass& pass, std::size_t point) {
  return {pass.path[point == 0 ? 0 : point - 1], pass.path[point], 0.0};
}

}  // namespace

PassSteps::PassSteps(const TurningPass& pass, std::uint32_t number) : m_pass(pass), m_number(number) {
  if (!pass.isExact || pass.edges.isZero()) return;
  std::vector<ProfileSegment> moves;
  for (std::size_t i = 0; i < pass.path.size(); ++i) moves.push_back(moveTo(pass, i));
  m_ends = inwardEnds(pass, moves);
}

TurnedProfile::Range PassSteps::cut(TurnedProfile& profile, std::size_t point, double from, double to) const {
  const ProfileSegment move = moveTo(m_pass, point), piece = move.piece(from, to);
  if (m_pass.isExact) {
    // The first move sweeps the start of the pass, too.
    if (point == 0 && m_pass.path.size() > 1) return {};
    const WholeMove whole(move, m_ends.empty() ? move.to : m_ends[point]);
    if (const auto step = cutExactly(profile, m_pass, piece, whole, m_number)) return step->changed;
  }
  return cutSamples(profile, m_pass, piece.from, piece.to);
}

}  // namespace handwheel
