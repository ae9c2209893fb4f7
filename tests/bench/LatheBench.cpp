// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "bench/Bars.h"
#include "document/workpiece/ProgramTrial.h"
#include "document/workpiece/WorkpieceShape.h"
#include "haptics/servo/RealTimeThread.h"
#include "machining/force/TrainedForceModel.h"
#include "machining/lathe/LatheJson.h"
#include "nurbs/StepWriter.h"
#include "simulation/SimulationLoop.h"
#include "simulation/turning/LatheForce.h"

#include <atomic>
#include <thread>

using namespace handwheel;

namespace {

constexpr StockCylinder kBar{40.0, 100.0, -100.0};
constexpr double kSpacing = 0.02;            // mm
constexpr double kRate = 1000.0;             // steps a second
constexpr std::int64_t kPeriod = 1'000'000;  // ns
constexpr int kTicks = 10'000;               // ticks of the servo loop: 10 s

bench::Bars bars;

// Counts how often a wait ended more than a period too late. One thread waits.
class LateClock : public MonotonicClock {
 public:
  void waitUntil(std::int64_t time) noexcept override {
    MonotonicClock::waitUntil(time);
    m_waits.fetch_add(1, std::memory_order_relaxed);
    if (now() - time > kPeriod) m_late.fetch_add(1, std::memory_order_relaxed);
  }
  double late() const { return static_cast<double>(m_late); }
  double share() const { return late() / static_cast<double>(std::max<std::uint64_t>(m_waits, 1)); }

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
    for (LatheSlot& slot : setup.stations) slot.position = slot.offset = {0.0, 0.0};
    const TurnedProfile profile(kBar, kSpacing);
    loop = std::make_unique<SimulationLoop>(
        std::make_unique<LatheSimulation>(
            LatheRun(setup, tools, profile, LatheMachine::initialState(setup, kBar), material),
            TurnedSurface(profile, 0.01), 0.0, channel, SurfaceFinish(profile.size())),
        kRate, channel->inputs, clock, service);
    using Kind = LatheCommand::Kind;
    for (const LatheCommand& command : {LatheCommand{Kind::Spindle, LatheAxis::Carriage, 1.0},
                                        LatheCommand{Kind::MoveTip, LatheAxis::Carriage, 18.5, 101.0}})
      channel->commands.push(command);
    loop->runSteps(3000);
    channel->commands.push({Kind::Feed, LatheAxis::Carriage, -0.3});
    loop->runSteps(1000);
  }
};

// The tick of the force source while simulation, tick and a bare clock run on threads of their own, a thousand times a
// second each, over the same seconds. Where hardly any wait of the bare clock is late, one in a thousand is allowed.
void tickWhileCutting(benchmark::State& state) {
  constexpr double kFew = 1e-3;
  for (auto _ : state) {
    RunningLathe lathe;
    LatheForce force(lathe.channel, lathe.material, {}, 0.0);
    LateClock bare;
    std::atomic<bool> isOver{false};
    std::thread bareLoop([&] {
      std::int64_t due = bare.now();
      while (!isOver) {
        bare.waitUntil(due += kPeriod);
        due = std::max(due, bare.now() - kPeriod);
      }
    });
    lathe.channel->inputs->setDeviceGesture(1);  // ends the gesture of the hand; the feed of the lathe goes on
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
    const ServiceCounters counters = lathe.service.counters();
    bars.atMost("servo tick while cutting by the network force, p99, us", 20.0, times[times.size() * 99 / 100]);
    bars.tell("the same, median", times[times.size() / 2]);
    bars.atMost("late steps of the simulation, to those of a bare 1 kHz clock", 1.2,
                bench::ratioTo(lathe.clock.share(), std::max(bare.share(), kFew)));
    bars.tell("late waits of the bare clock, %", 100.0 * bare.share());
    bars.tell("late steps of the simulation, %", 100.0 * lathe.clock.share());
    bars.tell("CPU time of a step of the simulation, us",
              static_cast<double>(counters.cpuMicroseconds) / static_cast<double>(counters.ticks));
  }
}

// 50 passes of 200 lines each towards a ball of 18 mm on a neck, and 20 to come and go: 10,000 lines that cut.
std::string longProgram() {
  constexpr int kPasses = 50, kLines = 200;
  std::string text = "G8 G18 G21 G97 S800 M3\n";
  char line[80];
  for (int pass = 0; pass < kPasses; ++pass) {
    const double left = 8.0 * (kPasses - 1 - pass) / (kPasses - 1);  // mm
    text += "G0 X25 Z2\n";
    for (int i = 0; i < kLines; ++i) {
      const double angle = 2.6 * i / (kLines - 1);
      std::snprintf(line, sizeof line, "G1 X%.5f Z%.5f F160\n", 18.0 * std::sin(angle) + left,
                    18.0 * (std::cos(angle) - 1.0) + left);
      text += line;
    }
    text += "G1 X25\n";
  }
  return text + "M2\n";
}

// Parsed, checked, cut, recorded as passes, with finish and triangles: what a user waits for. And the STEP file of it.
void aLongProgram(benchmark::State& state) {
  for (auto _ : state) {
    WorkpieceSnapshot workpiece;
    workpiece.stock = kBar;
    workpiece.mesh = std::make_shared<const StockMesh>(workpiece.stock, workpiece.chord);
    const ProgramSetup setup = usualSetup(ProgramDialect::LinuxCnc, workpiece.stock, 20.0, 0.4);
    const std::string text = longProgram();
    std::optional<Result<ProgramTrial::Pointer>> trial;
    const double ms = cpuMilliseconds([&] { trial = ProgramTrial::run(workpiece, text, setup, kSpacing); });
    if (!*trial || !trial->value()->part()) {
      bars.failed(state, "a program of 10,000 lines", "it does not run");
      return;
    }
    bars.atMost("a program of 10,000 lines, from its text to the part, s of CPU time", 1.0, 1e-3 * ms);
    workpiece.part = trial->value()->part();
    std::optional<Result<std::string>> bytes;
    const double stepMs = cpuMilliseconds([&] { bytes = checkedStep(workpiece, {}); });
    const auto report = *bytes ? inspectStep(**bytes) : Result<StepFileReport>((*bytes).error());
    if (!report) {
      bars.failed(state, "STEP file of that part", "it is not written");
      return;
    }
    bars.atMost("STEP file of that part: volume, to that of the profile, share", 1e-4,
                std::abs(report->volume / workpiece.part->profile.volume() - 1.0));
    bars.tell("its writing and checking, s of CPU time", 1e-3 * stepMs);
  }
}

}  // namespace

BENCHMARK(tickWhileCutting)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(aLongProgram)->Iterations(1)->Unit(benchmark::kMillisecond);

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
