// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/Simulation.h"
#include "simulation/clay/ClayContact.h"
#include "simulation/clay/ClayStroke.h"
#include "volume/clay/ClayMask.h"
#include "volume/surface/VolumeSurface.h"

#include <set>

namespace handwheel {

// A volume with its surface, at one moment of the simulation.
struct ClayState : SimulationState {
  SparseVolume volume;
  VolumeSurface surface;
  std::shared_ptr<const ClayMask> mask;  // null: nothing is protected
  std::size_t changedBlocks = 0;         // since the simulation began, of the volume and of the mask
  bool isComplete = false;               // the gesture has ended, and all of it is in the volume
};

// What the servo loop reads of a simulation of clay: null before the first step. A volume is read without a lock, and
// is freed on the thread that writes the next one.
struct ClayPatch {
  std::shared_ptr<const ClayState> state;
  std::optional<DrillingLoad> load = {};  // of a simulation that computes one; none: not yet
};

using ClayChannel = SimulationChannel<ClayPatch>;

// The simulation of clay: a brush changes the volume in a gesture. It does so as it is drawn over it.
class ClaySimulation : public Simulation {
 public:
  // begin: what it starts from. The channel must outlive it.
  ClaySimulation(std::shared_ptr<const ClayState> begin, const ClayBrush& brush, std::shared_ptr<ClayChannel> channel);

  // Applies kMostDabs at most: the rest waits for the next steps, so that a hand that is faster than the machine is
  // followed late, and not by one long step.
  void step(double dt, std::span<const SimulationInput> inputs) override;
  // Applies what is left. To be called at the end of a gesture, and after each step where nobody waits for it.
  void finish();
  std::shared_ptr<const SimulationState> state() const override { return m_state; }
  // The blocks that ClayState::changedBlocks counts.
  const std::set<std::array<int, 3>>& changed() const { return m_changed; }

  static constexpr std::size_t kMostDabs = 4;

 private:
  void apply(std::size_t most);

  std::shared_ptr<const ClayState> m_state;
  ClayStroke m_stroke;
  std::shared_ptr<ClayChannel> m_channel;
  bool m_isEnded = false;                  // the gesture
  bool m_isWritten = false;                // the present state is in the channel
  std::set<std::array<int, 3>> m_changed;  // blocks
};

}  // namespace handwheel
