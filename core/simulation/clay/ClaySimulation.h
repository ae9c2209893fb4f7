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
  std::size_t changedBlocks = 0;  // number of changed blocks of the volume and of the mask since the simulation began
  bool isComplete = false;        // true: the gesture has ended, and the volume has its whole effect
};

// The data of a clay simulation for the servo loop. `state` is null before the first step. A volume is read without a
// lock, and is freed on the thread that writes the next volume.
struct ClayPatch {
  std::shared_ptr<const ClayState> state;
  std::optional<DrillingLoad> load = {};  // none: not computed yet, or not by this simulation
};

using ClayChannel = SimulationChannel<ClayPatch>;

// The simulation of clay. A brush stroke changes the volume while the stroke is drawn.
class ClaySimulation : public Simulation {
 public:
  // begin: the initial state.
  ClaySimulation(std::shared_ptr<const ClayState> begin, const ClayBrush& brush, std::shared_ptr<ClayChannel> channel);

  // Applies at most kMostDabs dabs, and leaves the rest for the next steps. So a hand that is too fast for the machine
  // is followed late instead of in one long step.
  void step(double dt, std::span<const SimulationInput> inputs) override;
  // Applies the remaining dabs. It has to be called at the end of a gesture, or after each step if no thread waits for
  // the step.
  void finish();
  std::shared_ptr<const SimulationState> state() const override { return m_state; }
  // Returns the blocks that ClayState::changedBlocks counts.
  const std::set<std::array<int, 3>>& changed() const { return m_changed; }

  static constexpr std::size_t kMostDabs = 4;

 private:
  void apply(std::size_t most);

  std::shared_ptr<const ClayState> m_state;
  ClayStroke m_stroke;
  std::shared_ptr<ClayChannel> m_channel;
  bool m_isEnded = false;                  // the gesture has ended
  bool m_isWritten = false;                // the present state is in the channel
  std::set<std::array<int, 3>> m_changed;  // changed blocks
};

}  // namespace handwheel
