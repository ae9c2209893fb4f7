// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/RecordedPasses.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// The side that the turning tool is used on; none where another tool is, or none.
using Turning = std::optional<TurningSide>;

// After an event of a recording; others than the choice of a tool change nothing.
Turning turningAfter(const std::string& event, Turning before) {
  if (event == "tool turn") return TurningSide::Outside;
  if (event == "tool turn bore") return TurningSide::Bore;
  return event == "no tool" || event.starts_with("tool ") ? Turning() : before;
}

}  // namespace

std::optional<std::vector<TurningPass>> passesOf(const Recording& recording, double noseRadius, double base) {
  std::vector<TurningPass> passes;
  auto event = recording.events().begin();
  Turning turning = TurningSide::Outside;  // a recording that names no tool is one of turning
  bool isActing = false, wasHeld = false;
  double begin = 0.0;  // s
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const RecordedTick& tick = recording[i];
    for (; event != recording.events().end() && event->tick < tick.tick; ++event) {
      if (event->text == "tool lathe") return std::nullopt;
      turning = turningAfter(event->text, turning);
    }
    const bool isHeld = (tick.tip.buttons & 1u) != 0, isPressed = isHeld && !wasHeld;
    wasHeld = isHeld;
    if (isActing && isHeld && turning != passes.back().side) {  // another tool, or its other side, drops the pass
      passes.pop_back();
      isActing = false;
    }
    isActing = isHeld && turning && (isPressed || (isActing && !tick.tip.isRestart));
    if (!isActing) continue;
    if (isPressed) {
      passes.emplace_back().noseRadius = noseRadius;
      passes.back().side = *turning;
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
