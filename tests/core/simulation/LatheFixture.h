// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/TrainedForceModel.h"
#include "machining/lathe/LatheJson.h"
#include "simulation/SimulationLoop.h"
#include "simulation/turning/LatheSimulation.h"

#include <cmath>

// A lathe in its simulation loop, with commands from a test.
namespace handwheel::test {

using LatheDo = LatheCommand::Kind;

inline constexpr StockCylinder kRod{40.0, 100.0, 0.0};
inline constexpr double kLower = 7.0, kServoTick = 0.001;
inline constexpr std::size_t kPassesBefore = 3;

// A law of cutting forces that is simple enough to be calculated in a test.
class PlainLaw : public CuttingForceModel {
 public:
  CutForces at(const CutConditions& cut) const noexcept override {
    return {2000.0 * cut.depth * cut.feed, 800.0 * cut.depth * cut.feed, 400.0 * cut.depth * cut.feed};
  }
  bool covers(const CutConditions&) const noexcept override { return true; }
};

// Returns a material with the same law for all tools.
template <class Law>
std::shared_ptr<const LatheMaterial> materialWith(Law law) {
  LatheMaterial material;
  material.laws.assign(shippedLatheTools().size(), std::make_shared<Law>(law));
  return std::make_shared<const LatheMaterial>(std::move(material));
}

struct LatheFixture {
  std::shared_ptr<LatheChannel> channel = std::make_shared<LatheChannel>();
  VirtualClock clock;
  Service service{"simulation"};
  TurnedProfile rod{kRod, 0.05};
  LatheSetup setup = defaultLatheSetup(kRod);
  LatheTools tools = shippedLatheTools();
  std::shared_ptr<const LatheMaterial> material = materialWith(PlainLaw());
  std::shared_ptr<const PartThreads> threads;
  SimulationLoop loop{make(), 1000.0, channel->inputs, clock, service};

  std::unique_ptr<Simulation> make() {
    for (LatheSlot& slot : setup.stations) slot.position = slot.offset = {0.0, 0.0};
    return std::make_unique<LatheSimulation>(
        LatheRun(setup, tools, rod, LatheMachine::initialState(setup, kRod), material),
        TurnedSurface(rod, 0.05, threads), kLower, channel, SurfaceFinish(rod.size()), kPassesBefore);
  }
  void send(LatheDo kind, double value, double other = 0.0, LatheAxis axis = LatheAxis::Carriage) {
    channel->commands.push({kind, axis, value, other});
  }
  void run(double seconds) { loop.runSteps(static_cast<std::uint64_t>(std::lround(seconds / loop.dt()))); }
  // Makes the first pass, 2 mm deep, by the automatic feed.
  void turnDown() {
    send(LatheDo::Spindle, 1.0);
    send(LatheDo::MoveTip, 18.0, 102.0);
    run(2.0);
    send(LatheDo::Feed, -0.2);
    run(8.0);
  }
  // Turns the end down and cuts in with the parting tool.
  std::unique_ptr<Simulation> workWithTwoTools() {
    turnDown();
    send(LatheDo::Feed, 0.0);
    send(LatheDo::MoveTip, 30.0, 110.0);
    run(1.0);
    send(LatheDo::Tool, 3.0);  // parting
    send(LatheDo::MoveTip, 21.0, 60.0);
    run(2.0);
    send(LatheDo::Feed, -0.05, 0.0, LatheAxis::Cross);
    run(5.0);
    auto taken = loop.take();
    static_cast<LatheSimulation&>(*taken).finish();
    return taken;
  }
  const LatheMoment& moment() { return static_cast<const LatheMoment&>(*(m_held = loop.state())); }

 private:
  std::shared_ptr<const SimulationState> m_held;
};

}  // namespace handwheel::test
