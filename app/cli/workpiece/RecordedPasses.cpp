// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/RecordedPasses.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// Whether the turning tool is in use after an event of a recording; others than the choice of a tool change nothing.
bool isTurningAfter(const std::string& event, bool before) {
  if (event == "no tool") return false;
  return event.starts_with("tool ") ? event == "tool turn" : before;
}

}  // namespace

std::vector<TurningPass> passesOf(const Recording& recording, double noseRadius, double base) {
  std::vector<TurningPass> passes;
  auto event = recording.events().begin();
  bool isTurning = true, isActing = false, wasHeld = false;  // a recording that names no tool is one of turning
  double begin = 0.0;                                        // s
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const RecordedTick& tick = recording[i];
    for (; event != recording.events().end() && event->tick < tick.tick; ++event)
      isTurning = isTurningAfter(event->text, isTurning);
    const bool isHeld = (tick.tip.buttons & 1u) != 0, isPressed = isHeld && !wasHeld;
    wasHeld = isHeld;
    if (isActing && isHeld && !isTurning) passes.pop_back();  // another tool drops the pass
    isActing = isHeld && isTurning && (isPressed || (isActing && !tick.tip.isRestart));
    if (!isActing) continue;
    if (isPressed) {
      passes.emplace_back().noseRadius = noseRadius;
      begin = tick.tip.time;
    }
    TurningPass& pass = passes.back();
    if (!tick.hasSource || pass.path.size() == TurningPass::kMostPoints) continue;
    const Vec3& nose = tick.felt.proxy;
    pass.times.push_back(std::max(tick.tip.time - begin, pass.times.empty() ? 0.0 : pass.times.back()));
    pass.path.emplace_back(std::hypot(nose.x(), nose.y()), nose.z() - base);
  }
  std::erase_if(passes, [](const TurningPass& pass) { return pass.path.empty(); });
  return passes;
}

}  // namespace handwheel
