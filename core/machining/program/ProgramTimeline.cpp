// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramTimeline.h"

#include <algorithm>

namespace handwheel {

ProgramTimeline::ProgramTimeline(const ToolPath& path) : m_path(path) {
  double time = 0.0;
  m_ends.reserve(path.moves.size());
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    m_ends.push_back(time += path.moves[i].time);
    if (i + 1 == path.moves.size() || path.moves[i + 1].line != path.moves[i].line) m_stepEnds.push_back(i + 1);
  }
}

double ProgramTimeline::timeAt(const ProgramPosition& position) const {
  const double begun = position.done == 0 ? 0.0 : m_ends[std::min(position.done, m_ends.size()) - 1];
  if (position.done >= m_ends.size()) return duration();
  return begun + timeOf(m_path.moves[position.done], {0.0, position.fraction});
}

ProgramPosition ProgramTimeline::at(double time) const {
  const auto move = std::upper_bound(m_ends.begin(), m_ends.end(), time);
  const auto done = static_cast<std::size_t>(move - m_ends.begin());
  if (move == m_ends.end()) return end();
  const double begun = done == 0 ? 0.0 : m_ends[done - 1];
  return {done, lengthAfter(m_path.moves[done], std::clamp((time - begun) / (*move - begun), 0.0, 1.0))};
}

const ToolMove& ProgramTimeline::moveAt(const ProgramPosition& position) const {
  return m_path.moves[std::min(position.done, m_path.moves.size() - 1)];
}

std::uint32_t ProgramTimeline::lineAt(const ProgramPosition& position) const {
  return m_path.moves.empty() ? 0 : moveAt(position).line;
}

ProfilePoint ProgramTimeline::tipAt(const ProgramPosition& position) const {
  if (m_path.moves.empty()) return ProfilePoint(0, 0);
  return position.done >= m_path.moves.size() ? m_path.moves.back().to : pointOn(moveAt(position), position.fraction);
}

ProgramPosition ProgramTimeline::next(const ProgramPosition& position) const {
  const auto step = std::upper_bound(m_stepEnds.begin(), m_stepEnds.end(), position.done);
  return step == m_stepEnds.end() ? end() : ProgramPosition{*step, 0.0};
}

ProgramPosition ProgramTimeline::previous(const ProgramPosition& position) const {
  // The last end of a step before the position.
  const std::size_t before = position.fraction > 0.0 ? position.done + 1 : position.done;
  const auto step = std::lower_bound(m_stepEnds.begin(), m_stepEnds.end(), before);
  return step == m_stepEnds.begin() ? ProgramPosition{} : ProgramPosition{*std::prev(step), 0.0};
}

ProgramPosition ProgramTimeline::afterLine(std::uint32_t line) const {
  const auto ofStep = [this](std::size_t stepEnd) { return m_path.moves[stepEnd - 1].line; };
  std::size_t best = m_path.moves.size();
  std::uint32_t nearest = 0;
  for (const std::size_t each : m_stepEnds) {
    const std::uint32_t found = ofStep(each);
    if (found < line || (nearest != 0 && found >= nearest)) continue;
    nearest = found;
    best = each;
    if (found == line) break;
  }
  return {best, 0.0};
}

}  // namespace handwheel
