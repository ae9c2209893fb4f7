// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/TurningSound.h"

#include "machining/force/CuttingFeel.h"
#include "tools/workpiece/ManualLatheTool.h"
#include "tools/workpiece/TurnTool.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

MachineSoundState soundOf(const ManualLatheTool& lathe) {
  const auto now = lathe.moment();
  const LatheLoad& load = now->load;
  MachineSoundState sound;
  sound.spindleSpeed = now->machine.speed;
  sound.force = load.forces.norm();
  sound.cuttingSpeed = load.cut.speed;
  // κ is near a right angle on most tools, where the chip is as thick as the feed.
  if (load.isCutting) sound.chipThickness = load.cut.feed;
  sound.wear = lathe.setup().wear / CuttingFeel::kMostWear;
  sound.chatter = load.chatter;
  sound.blows = static_cast<unsigned>(lathe.collisions().size());
  return sound;
}

MachineSoundState TurningSound::next(const TurnTool& tool, double seconds) {
  MachineSoundState sound;
  const auto state = tool.state();
  const double volume = state->profile.volume();
  const double before = std::exchange(m_volume, volume);
  if (!tool.isLive()) return sound;
  sound.spindleSpeed = kSpindle;
  if (before < 0.0 || !(before > volume) || !(seconds > 0.0)) return sound;
  constexpr double kRadius = 15.0;                              // mm: of parts as they are turned by hand
  const double speed = 2.0 * M_PI * kRadius * kSpindle / 60.0;  // mm/s
  sound.force = kSpecificEnergy * (before - volume) / seconds / speed;
  sound.cuttingSpeed = speed * 60.0 / 1000.0;
  return sound;
}

}  // namespace handwheel
