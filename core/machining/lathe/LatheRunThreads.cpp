// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Threads on the lathe: LatheRun.
#include "machining/lathe/LatheRunTry.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

// Returns true if the nut is open, and the work turns against a threading tool that is still in its groove: the edge
// makes a ring of the end of the groove before anybody can draw it back.
bool LatheRun::leavesThread(const Try& tried) const {
  return m_isInThread && tried.tool && tried.tool == m_lastTool && !tried.isIndexed && !tried.isQuill &&
         std::abs(m_machine.state().speed) >= kAtRest && !threadOf(tried);
}

// The profile does not contain the grooves. On the helix, and while the spindle rests, the edge only removes material
// beyond them. On the helix a tool that is drawn out cuts while it is in the material, but nobody has to push it.
void LatheRun::meetThreads(Try& tried) const {
  tried.thread = threadOf(tried);
  const LatheState& state = m_machine.state();
  const bool isAtRest = std::abs(state.speed) < kAtRest;
  if (tried.thread || isAtRest) {
    const ThreadsBeingCut::ToolPosition position{tried.to, -2.0 * M_PI * state.turns};
    const ThreadChip chip = m_threads.chipAt(m_profile, *tried.tool, position, isAtRest ? &tried.from : nullptr);
    tried.cut.depth = std::min(tried.cut.depth, chip.depth);
    const double inward = tried.from.x() - tried.to.x(), depth = tried.cut.depth;
    tried.pushed = tried.thread ? std::min(depth, tried.tool->side == TurningSide::Bore ? -inward : inward) : depth;
    tried.takesNothing = !tried.thread && !(tried.cut.depth > kTouch);
  } else if (tried.isRing) {
    TurnedProfile ringed = m_profile;  // shares its pages
    cutWithTool(ringed, *tried.tool, m_lastPosition, tried.from);
    tried.cut = previewCut(ringed, *tried.tool, tried.from, tried.to);
    tried.pushed = tried.cut.depth;
  }
}

// The tool is at a height for each turn; turns are those of the work, opposite to those of the tool about it.
std::optional<ThreadCut> LatheRun::threadOf(const Try& tried) const {
  const LatheState& state = m_machine.state();
  const bool isLed = state.lead != 0.0 && state.isNutClosed && !tried.isQuill && !tried.isIndexed;
  if (!isLed || tried.tool->kind != LatheToolKind::Threading) return std::nullopt;
  ThreadCut thread;
  thread.pitch = std::abs(state.lead);
  thread.isLeft = state.lead > 0.0;
  const double middle = tried.to.y() + tried.tool->noseCentre().y() - state.lead * state.turns;
  thread.offset = middle - thread.pitch * std::floor(middle / thread.pitch);
  return thread.isSound() ? std::optional(thread) : std::nullopt;
}

}  // namespace handwheel
