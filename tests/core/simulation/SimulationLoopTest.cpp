// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/SimulationLoop.h"

#include "TestClass.h"

#include <QtTest>
#include <chrono>
#include <thread>

using namespace handwheel;

namespace {

struct Sum : SimulationState {
  double sum = 0.0;
  std::uint64_t inputs = 0;
  std::uint64_t steps = 0;
};

// A sum that depends on the order of what comes in and on how it is spread over the steps.
class Summing : public Simulation {
 public:
  explicit Summing(std::chrono::microseconds work = {}) : m_work(work) {}
  void step(double dt, std::span<const SimulationInput> inputs) override {
    auto next = std::make_shared<Sum>(*m_state);
    for (const SimulationInput& input : inputs) next->sum = 0.999 * next->sum + input.tip.position.x() * dt;
    next->inputs += inputs.size();
    ++next->steps;
    m_state = std::move(next);
    if (m_work.count() > 0) std::this_thread::sleep_for(m_work);
  }
  std::shared_ptr<const SimulationState> state() const override { return m_state; }

 private:
  std::shared_ptr<const Sum> m_state = std::make_shared<const Sum>();
  std::chrono::microseconds m_work;
};

const Sum& sumOf(const std::shared_ptr<const SimulationState>& state) {
  return static_cast<const Sum&>(*state);
}

SimulationInput at(double x) {
  SimulationInput input;
  input.tip.position.x() = x;
  return input;
}

}  // namespace

class SimulationLoopTest : public QObject {
  Q_OBJECT

 private slots:
  void consumesInOrderAndCounts() {
    VirtualClock clock;
    Service service("simulation");
    const auto inputs = std::make_shared<SimulationInputs>(kWaitingInputs);
    SimulationLoop loop(std::make_unique<Summing>(), 100.0, inputs, clock, service);
    loop.keepLog();
    QCOMPARE(loop.dt(), 0.01);
    QCOMPARE(sumOf(loop.state()).steps, 0u);
    double expected = 0.0;
    for (int i = 0; i < 7; ++i) {
      inputs->push(at(i));
      expected = 0.999 * expected + i * loop.dt();
    }
    loop.runSteps(1);
    QCOMPARE(sumOf(loop.state()).sum, expected);
    QCOMPARE(sumOf(loop.state()).inputs, 7u);
    QCOMPARE(service.counters().ticks, 1u);
    QCOMPARE(loop.log().countPerStep, std::vector<std::uint32_t>{7});
  }

  void ratesAreKeptWithinTheLimits() {
    const auto inputs = std::make_shared<SimulationInputs>(kWaitingInputs);
    VirtualClock clock;
    Service service("simulation");
    QCOMPARE(SimulationLoop(std::make_unique<Summing>(), 1e9, inputs, clock, service).dt(),
             1.0 / SimulationLoop::kLargestRate);
    QCOMPARE(SimulationLoop(std::make_unique<Summing>(), 0.0, inputs, clock, service).dt(),
             1.0 / SimulationLoop::kLeastRate);
  }

  // Real threads: whatever the timing was, the log gives the same state again, bit for bit, and nothing is lost.
  void aLogIsReplayedToTheSameBits() {
    MonotonicClock clock;
    Service service("simulation");
    const auto inputs = std::make_shared<SimulationInputs>(kWaitingInputs);
    SimulationLoop loop(std::make_unique<Summing>(), 500.0, inputs, clock, service);
    loop.keepLog();
    loop.start();
    constexpr int kInputsSent = 2000;
    std::thread hand([&] {
      for (int i = 0; i < kInputsSent; ++i) {
        while (!inputs->push(at(std::sin(0.1 * i)))) std::this_thread::yield();
        if (i % 10 == 0) std::this_thread::sleep_for(std::chrono::microseconds(300));
      }
    });
    hand.join();
    loop.stop();
    const Sum& live = sumOf(loop.state());
    QCOMPARE(live.inputs, std::uint64_t{kInputsSent});
    Summing again;
    replay(again, loop.log());
    QCOMPARE(sumOf(again.state()).sum, live.sum);
    QCOMPARE(sumOf(again.state()).steps, live.steps);
  }

  // The mouse drags while a device is open: both write, and nothing is lost or torn.
  void deviceAndWindowWriteAtOnce() {
    MonotonicClock clock;
    Service service("simulation");
    const auto inputs = std::make_shared<SimulationInputs>(kWaitingInputs);
    SimulationLoop loop(std::make_unique<Summing>(), 500.0, inputs, clock, service);
    loop.keepLog();
    loop.start();
    constexpr int kInputsSent = 20000;
    std::thread hand([&] {
      for (int i = 0; i < kInputsSent; ++i)
        while (!inputs->push(at(1.0 + i))) std::this_thread::yield();
    });
    for (int i = 0; i < kInputsSent; ++i)
      while (!inputs->pushFromWindow(at(-1.0 - i))) std::this_thread::yield();
    hand.join();
    loop.stop();
    int ofDevice = 0, ofWindow = 0;
    for (const SimulationInput& input : loop.log().inputs) {
      const double x = input.tip.position.x();
      QCOMPARE(std::abs(x), 1.0 + (x > 0.0 ? ofDevice++ : ofWindow++));
    }
    QVERIFY(ofDevice == kInputsSent && ofWindow == kInputsSent);
  }

  // A step that takes three periods: the simulation runs at a third of the rate, says how far it is behind, and makes
  // up for nothing.
  void lateStepsSlowItDown() {
    MonotonicClock clock;
    Service service("simulation");
    const auto inputs = std::make_shared<SimulationInputs>(kWaitingInputs);
    SimulationLoop loop(std::make_unique<Summing>(std::chrono::milliseconds(6)), 500.0, inputs, clock, service);
    const auto begin = std::chrono::steady_clock::now();
    loop.start();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    loop.stop();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const auto steps = static_cast<double>(loop.steps());
    QVERIFY(steps <= seconds / 0.006 + 1.0);
    QVERIFY(loop.lostTime() > 0.0);
    QVERIFY(steps * loop.dt() + loop.lostTime() <= seconds + 2.0 * loop.dt());
  }
};

HANDWHEEL_TEST(SimulationLoopTest)
#include "SimulationLoopTest.moc"
