// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedSurface.h"
#include "machining/TurningPass.h"
#include "machining/finish/FinishMeter.h"
#include "simulation/turning/HandPass.h"
#include "simulation/turning/TurningForce.h"

namespace handwheel {

// A turned part with its triangles, at one moment of the simulation.
struct TurningState : SimulationState {
  TurningState(TurnedProfile p, TurnedSurface s) : profile(std::move(p)), surface(std::move(s)) {}
  TurnedProfile profile;
  TurnedSurface surface;
  SurfaceFinish finish;  // finish of the profile
  // Largest feed of a cut since the simulation began, mm per revolution; 0: there was no cut, or the speed is not
  // known.
  double fastest = 0.0;
  bool isCut = false;   // true: something was cut since the simulation began
  bool isFull = false;  // true: the pass has the largest number of points, and nothing more is cut
};

// The initial data for the finish of a pass.
struct TurningFinish {
  SurfaceFinish before = SurfaceFinish();  // finish of the part before the pass
  std::uint32_t pass = 0;                  // number of the pass in the part
  double speed = 0.0;                      // r/min, speed of the spindle; 0: not known
};

// The simulation of turning, in which a tool cuts a profile. In a gesture, which is one pass, the tool removes the
// material that it passes.
class TurningSimulation : public Simulation {
 public:
  // blank: a pass without points, with the tool. base: z of the part's lower end in the scene, mm. mostPoints: the
  // largest number of points of the pass.
  TurningSimulation(TurnedProfile profile, TurnedSurface surface, TurningPass blank, double base,
                    std::shared_ptr<TurningChannel> channel, std::size_t mostPoints = TurningPass::kMostPoints,
                    TurningFinish finish = {});

  void step(double dt, std::span<const SimulationInput> inputs) override;
  std::shared_ptr<const SimulationState> state() const override { return m_state; }
  // Returns the cut since the simulation began as one pass. cut() with this pass has the same effect on the same
  // profile.
  const TurningPass& pass() const { return m_hand.pass(); }

 private:
  TurnedProfile::Range take(const SimulationInput& input);
  bool isDeep(const TurnedProfile& before, const TurnedProfile::Range& changed) const;

  std::shared_ptr<const TurningState> m_state;
  TurnedProfile m_profile;
  HandPass m_hand;
  double m_base;  // mm
  std::shared_ptr<TurningChannel> m_channel;
  FinishMeter m_finish;
  std::uint32_t m_passNumber;  // number of the pass in the part
  double m_speed;              // r/min; 0: not known
  std::uint32_t m_number;      // number of this simulation in the channel
};

}  // namespace handwheel
