// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "bench/Bars.h"
#include "haptics/device/SimulatedDevice.h"
#include "haptics/servo/ServoLoop.h"

#include <array>
#include <thread>

using namespace handwheel;

namespace {

bench::Bars bars;

constexpr int kTicks = 4000;  // in one run: 4 s
constexpr int kRuns = 5;
constexpr std::int64_t kPeriod = 1'000'000;  // ns

// Notes by how much each wait came too late.
class NotingClock : public MonotonicClock {
 public:
  NotingClock() { m_late.reserve(kTicks + 16); }
  void waitUntil(std::int64_t time) noexcept override {
    MonotonicClock::waitUntil(time);
    if (m_late.size() < m_late.capacity()) m_late.push_back(static_cast<double>(now() - time) * 1e-3);
  }
  // us; no number where some of the waits are missing.
  double quantile(double share) {
    if (m_late.size() < kTicks) return std::nan("");
    std::sort(m_late.begin(), m_late.end());
    return m_late[static_cast<std::size_t>(share * static_cast<double>(m_late.size() - 1))];
  }

 private:
  std::vector<double> m_late;
};

// A wall of 0.5 N/mm that a simulated hand leans on.
class Wall : public ForceRenderer {
 public:
  void tick(const TipState& tip, ForceOut& out) noexcept override {
    out.isContact = tip.position.x() > 0.0;
    if (out.isContact) out.force.x() = -std::min(0.5, tip.stiffnessLimit) * tip.position.x();
  }
};

std::unique_ptr<ServoLoop> makeLoop(ServoClock& clock, Service& service) {
  const PoseTrajectory path({{0.0, {-1, 0, 0}}, {0.5, {2, 0, 0}}, {100.0, {2, 0, 0}}});
  auto device = std::make_unique<SimulatedDevice>(simulatedDevice(), path, clock);
  if (!device->open(Progress())) return nullptr;
  auto loop = std::make_unique<ServoLoop>(std::move(device), ServoSettings(), clock, service);
  auto scene = std::make_unique<HapticScene>();
  scene->renderer = std::make_unique<Wall>();
  loop->setScene(std::move(scene));
  return loop;
}

struct Lateness {
  double p50 = 0.0, p99 = 0.0;  // us
};

// On a thread of its own, real-time where allowed, like the loop's.
template <class Work>
Lateness latenessOf(Work work) {
  NotingClock clock;
  std::thread([&] {
    makeThreadRealTime(80);
    work(clock);
  }).join();
  return {clock.quantile(0.5), clock.quantile(0.99)};
}

Lateness ofBareLoop() {
  return latenessOf([](NotingClock& clock) {
    std::int64_t due = clock.now();
    for (int i = 0; i < kTicks; ++i) {
      due += kPeriod;
      clock.waitUntil(due);
      if (clock.now() > due + kPeriod) due = clock.now();
    }
  });
}

Lateness ofServoLoop() {
  return latenessOf([](NotingClock& clock) {
    Service service("servo");
    const auto loop = makeLoop(clock, service);
    loop->runTicks(kTicks);
  });
}

double median(std::array<double, kRuns> values) {
  std::nth_element(values.begin(), values.begin() + kRuns / 2, values.end());
  return values[kRuns / 2];
}

// By turns, and the median of the runs: the machine steals slices of milliseconds now from one, now from the other.
void wakeUpLateness(benchmark::State& state) {
  std::array<double, kRuns> bare50{}, bare99{}, ours50{}, ours99{};
  for (auto _ : state) {
    for (std::size_t i = 0; i < kRuns; ++i) {
      Lateness bare, ours;
      if (i % 2 == 0) bare = ofBareLoop();
      ours = ofServoLoop();
      if (i % 2 != 0) bare = ofBareLoop();
      bare50[i] = bare.p50;
      bare99[i] = bare.p99;
      ours50[i] = ours.p50;
      ours99[i] = ours.p99;
    }
  }
  state.counters["bare_p50_us"] = median(bare50);
  state.counters["bare_p99_us"] = median(bare99);
  state.counters["p50_us"] = median(ours50);
  state.counters["p99_us"] = median(ours99);
  bars.atMost("wake-up lateness p50, to a bare clock_nanosleep loop", 1.2, median(ours50) / median(bare50));
  bars.atMost("wake-up lateness p99, to a bare clock_nanosleep loop", 1.2, median(ours99) / median(bare99));
}

// All of a tick but the wait, with a wall and a simulated hand: thread CPU time.
void tickCost(benchmark::State& state) {
  constexpr int ticks = 100'000;
  double least = 1e9;
  for (auto _ : state) {
    VirtualClock clock;
    Service service("servo");
    const auto loop = makeLoop(clock, service);
    const double us = cpuMilliseconds([&] { loop->runTicks(ticks); }) * 1e3 / ticks;
    state.SetIterationTime(us * ticks * 1e-6);
    least = std::min(least, us);
  }
  state.counters["us_per_tick"] = least;
  bars.atMost("servo tick without the scene, us of CPU time", 5.0, least);
}

}  // namespace

BENCHMARK(wakeUpLateness)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(tickCost)->Iterations(5)->Unit(benchmark::kMillisecond)->UseManualTime();

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
