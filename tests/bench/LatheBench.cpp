// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/Bars.h"
#include "haptics/servo/RealTimeThread.h"
#include "machining/force/TrainedForceModel.h"
#include "machining/lathe/LatheJson.h"
#include "simulation/SimulationLoop.h"
#include "simulation/turning/LatheForce.h"

#include <atomic>
#include <thread>

using namespace handwheel;

namespace {

constexpr StockCylinder kBar{40.0, 100.0, 0.0};
constexpr double kSpacing = 0.02;            // mm
constexpr double kRate = 1000.0;             // steps a second
constexpr std::int64_t kPeriod = 1'000'000;  // ns
constexpr int kTicks = 10'000;               // of the servo loop: 10 s

bench::Bars bars;

// Counts how often a wait ended more than a period too late. One thread waits.
class LateClock : public MonotonicClock {
 public:
  void waitUntil(std::int64_t time) noexcept override {
    MonotonicClock::waitUntil(time);
    ++m_waits;
    if (now() - time > kPeriod) ++m_late;
  }
  double lateShare() const { return m_waits > 0 ? static_cast<double>(m_late) / static_cast<double>(m_waits) : 0.0; }
  std::uint64_t late() const { return m_late; }

 private:
  std::atomic<std::uint64_t> m_waits{0}, m_late{0};
};

// A lathe that turns its bar down by the feed, with the network that ships.
struct RunningLathe {
  std::shared_ptr<LatheChannel> channel = std::make_shared<LatheChannel>();
  LatheTools tools = shippedLatheTools();
  std::shared_ptr<const LatheMaterial> material;
  LateClock clock;
  Service service{"simulation"};
  std::unique_ptr<SimulationLoop> loop;

  RunningLathe() {
    const WorkMaterials materials = WorkMaterials::standard();
    const WorkMaterial& steel = *materials.find(shippedForceModel().origin().material);
    material = std::make_shared<const LatheMaterial>(latheMaterial(steel, ForceLaw::Network, tools));
    LatheSetup setup = defaultLatheSetup(kBar);
    for (LatheSlot& slot : setup.stations) slot.place = slot.offset = {0.0, 0.0};
    const TurnedProfile profile(kBar, kSpacing);
    auto simulation = std::make_unique<LatheSimulation>(
        LatheRun(setup, tools, profile, LatheMachine::initialState(setup, kBar), material),
        TurnedSurface(profile, 0.01), 0.0, channel);
    loop = std::make_unique<SimulationLoop>(std::move(simulation), kRate, channel->inputs, clock, service);
    using Kind = LatheCommand::Kind;
    for (const LatheCommand& command : {LatheCommand{Kind::Spindle, LatheAxis::Carriage, 1.0},
                                        LatheCommand{Kind::Place, LatheAxis::Carriage, 18.5, 101.0}})
      channel->commands.push(command);
    loop->runSteps(3000);
    channel->commands.push({Kind::Feed, LatheAxis::Carriage, -0.3});
    loop->runSteps(1000);
  }
};

// The tick of the force source, timed while simulation and tick run on threads of their own, a thousand times a second
// each; beside them a bare clock of the same rate. What is late here and there is counted over the same seconds.
void tickWhileCutting(benchmark::State& state) {
  for (auto _ : state) {
    RunningLathe lathe;
    LatheForce force(lathe.channel, lathe.material, {}, 0.0);
    LateClock bare;
    std::atomic<bool> isOver{false};
    std::thread bareLoop([&] {
      std::int64_t due = bare.now();
      while (!isOver) {
        bare.waitUntil(due += kPeriod);
        if (const std::int64_t now = bare.now(); now > due + kPeriod) due = now;
      }
    });
    lathe.channel->inputs->setDeviceGesture(1);
    lathe.loop->start();
    std::vector<double> times;
    times.reserve(kTicks);
    int cutting = 0;
    std::thread([&] {
      makeThreadRealTime(80);
      MonotonicClock clock;
      std::int64_t due = clock.now();
      for (int i = 0; i < kTicks; ++i) {
        clock.waitUntil(due += kPeriod);
        TipState tip;
        tip.isRestart = i == 0;
        tip.position = Vec3(18.5, 0.2, 60.0);
        tip.buttons = 1u;
        const std::int64_t begin = clock.now();
        ForceOut out;
        force.advance(tip, out);
        benchmark::DoNotOptimize(force.force(tip, 1.0, 1.0));
        times.push_back(static_cast<double>(clock.now() - begin) * 1e-3);
        cutting += force.cut().cutting > 0.0 ? 1 : 0;
      }
    }).join();
    isOver = true;
    bareLoop.join();
    lathe.loop->stop();
    if (cutting < kTicks / 2) {
      bars.failed(state, "servo tick while cutting", "the lathe did not cut");
      return;
    }
    std::sort(times.begin(), times.end());
    const auto ticks = static_cast<double>(lathe.service.counters().ticks);
    bars.atMost("servo tick while cutting by the network force, p99, us", 20.0, times[times.size() * 99 / 100]);
    bars.tell("the same, median", times[times.size() / 2]);
    bars.atMost("late steps of the simulation, to those of a bare 1 kHz clock", 1.2,
                bare.late() == lathe.clock.late() ? 1.0 : bench::ratioTo(lathe.clock.lateShare(), bare.lateShare()));
    bars.tell("late steps of the bare clock, % of them", 100.0 * bare.lateShare());
    bars.tell("late steps of the simulation, %", 100.0 * lathe.clock.lateShare());
    bars.tell("CPU time of a step of the simulation, us", lathe.service.counters().cpuMicroseconds / ticks);
  }
}

}  // namespace

BENCHMARK(tickWhileCutting)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
