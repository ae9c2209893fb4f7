// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/SimulationLoop.h"

#include "SimulationLog.h"
#include "TestClass.h"

#include <QtTest>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

using namespace handwheel;
using namespace handwheel::test;

namespace {

struct Sum : SimulationState {
  double sum = 0.0;
  std::uint64_t inputs = 0;
  std::uint64_t steps = 0;
};

// A sum that depends on the order of inputs and on their distribution over the steps.
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

const SimulationLog& logOf(const Simulation& logged) {
  return static_cast<const LoggedSimulation&>(logged).log();
}

// The gestures of ticks in which these buttons are held.
std::vector<std::uint32_t> gesturesOf(SimulationInputs& inputs, const std::vector<std::uint32_t>& buttons) {
  std::vector<std::uint32_t> gestures;
  for (const std::uint32_t held : buttons) {
    TipState tip;
    tip.isRestart = false;
    tip.buttons = held;
    gestures.push_back(inputs.gestureAt(tip));
  }
  return gestures;
}

// Throws at its third step.
class Failing : public Summing {
 public:
  void step(double dt, std::span<const SimulationInput> inputs) override {
    if (++m_steps == 3) throw std::runtime_error("no memory");
    Summing::step(dt, inputs);
  }

 private:
  int m_steps = 0;
};

// Throws in its first step, a while after that may.
class FailingLater : public Summing {
 public:
  FailingLater(std::atomic<bool>& isInStep, std::atomic<bool>& mayThrow) : m_isInStep(isInStep), m_mayThrow(mayThrow) {}
  void step(double, std::span<const SimulationInput>) override {
    m_isInStep = true;
    while (!m_mayThrow) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    throw std::runtime_error("no memory");
  }

 private:
  std::atomic<bool>&m_isInStep, &m_mayThrow;
};

// Its sum is the number of inputs that act.
class Acting : public Simulation {
 public:
  void step(double, std::span<const SimulationInput> inputs) override {
    auto next = std::make_shared<Sum>(*m_state);
    for (const SimulationInput& input : inputs) next->sum += input.gesture != 0 ? 1.0 : 0.0;
    next->inputs += inputs.size();
    m_state = std::move(next);
  }
  std::shared_ptr<const SimulationState> state() const override { return m_state; }

 private:
  std::shared_ptr<const Sum> m_state = std::make_shared<const Sum>();
};

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
    SimulationLoop loop(std::make_unique<LoggedSimulation>(std::make_unique<Summing>()), 100.0, inputs, clock, service);
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
    const auto taken = loop.take();  // after one step more, without inputs
    QCOMPARE(logOf(*taken).countPerStep, (std::vector<std::uint32_t>{7, 0}));
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
    SimulationLoop loop(std::make_unique<LoggedSimulation>(std::make_unique<Summing>()), 500.0, inputs, clock, service);
    loop.start();
    constexpr int kInputsSent = 2000;
    std::thread hand([&] {
      for (int i = 0; i < kInputsSent; ++i) {
        while (!inputs->push(at(std::sin(0.1 * i)))) std::this_thread::yield();
        if (i % 10 == 0) std::this_thread::sleep_for(std::chrono::microseconds(300));
      }
    });
    hand.join();
    const auto taken = loop.take();  // while its thread runs
    const Sum& live = sumOf(loop.state());
    QCOMPARE(live.inputs, std::uint64_t{kInputsSent});
    Summing again;
    replay(again, logOf(*taken));
    QCOMPARE(sumOf(again.state()).sum, live.sum);
    QCOMPARE(sumOf(again.state()).steps, live.steps);
  }

  // The mouse drags while a device is open: both write, and nothing is lost or torn.
  void deviceAndWindowWriteAtOnce() {
    MonotonicClock clock;
    Service service("simulation");
    const auto inputs = std::make_shared<SimulationInputs>(kWaitingInputs);
    SimulationLoop loop(std::make_unique<LoggedSimulation>(std::make_unique<Summing>()), 500.0, inputs, clock, service);
    loop.start();
    constexpr int kInputsSent = 20000;
    std::thread hand([&] {
      for (int i = 0; i < kInputsSent; ++i)
        while (!inputs->push(at(1.0 + i))) std::this_thread::yield();
    });
    for (int i = 0; i < kInputsSent; ++i)
      while (!inputs->pushFromWindow(at(-1.0 - i))) std::this_thread::yield();
    hand.join();
    const auto taken = loop.take();
    int ofDevice = 0, ofWindow = 0;
    for (const SimulationInput& input : logOf(*taken).inputs) {
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
    const double lost = service.counters().lostSeconds;
    QVERIFY(lost > 0.0);
    QVERIFY(steps * loop.dt() + lost <= seconds + 2.0 * loop.dt());
  }

  // Nobody waits for inputs without room; they are counted.
  void droppedInputsAreCounted() {
    VirtualClock clock;
    Service service("simulation");
    const auto inputs = std::make_shared<SimulationInputs>(4);
    SimulationLoop loop(std::make_unique<Summing>(), 100.0, inputs, clock, service);
    for (int i = 0; i < 7; ++i) inputs->push(at(i));
    for (int i = 0; i < 6; ++i) inputs->pushFromWindow(at(i));
    loop.runSteps(2);
    QCOMPARE(sumOf(loop.state()).inputs, 8u);
    QCOMPARE(service.counters().dropped, 5u);
  }

  // The hand acts while the button is held, once the window has announced a gesture; each gesture ends for good with
  // the button.
  void aGestureIsOfOneButtonPress() {
    SimulationInputs inputs(4);
    using Gestures = std::vector<std::uint32_t>;
    QCOMPARE(gesturesOf(inputs, {1, 1}), (Gestures{0, 0}));  // held before the tool was there
    inputs.setDeviceGesture(7);
    QCOMPARE(gesturesOf(inputs, {2, 1, 3, 2, 1, 1}), (Gestures{0, 7, 7, 0, 0, 0}));
    inputs.setDeviceGesture(8);
    QCOMPARE(gesturesOf(inputs, {1, 1}), (Gestures{8, 8}));
    inputs.setDeviceGesture(0);  // dropped
    QCOMPARE(gesturesOf(inputs, {1, 0, 1}), (Gestures{0, 0, 0}));
    inputs.setDeviceGesture(9);
    TipState leapt;
    leapt.buttons = 1;
    leapt.isRestart = false;
    QCOMPARE(inputs.gestureAt(leapt), 9u);
    leapt.isRestart = true;
    QCOMPARE(inputs.gestureAt(leapt), 0u);
    leapt.isRestart = false;
    QCOMPARE(inputs.gestureAt(leapt), 0u);
  }

  // Late inputs of a dropped gesture no longer act.
  void lateInputsOfAnotherGestureOnlyMove() {
    VirtualClock clock;
    Service service("simulation");
    const auto inputs = std::make_shared<SimulationInputs>(8);
    SimulationLoop loop(std::make_unique<LoggedSimulation>(std::make_unique<Summing>()), 100.0, inputs, clock, service);
    loop.setGesture(2);
    for (const std::uint32_t gesture : {1u, 0u, 2u}) {
      SimulationInput input = at(1.0);
      input.gesture = gesture;
      inputs->push(input);
    }
    const auto taken = loop.take();
    std::vector<std::uint32_t> seen;
    for (const SimulationInput& input : logOf(*taken).inputs) seen.push_back(input.gesture);
    QCOMPARE(seen, (std::vector<std::uint32_t>{0, 0, 2}));
  }

  // A gesture begins at any moment of a step: its first input acts.
  void aGestureThatBeginsDuringAStepActs() {
    constexpr std::uint32_t kGestures = 1'000;
    VirtualClock clock;
    Service service("simulation");
    const auto inputs = std::make_shared<SimulationInputs>(8);
    SimulationLoop loop(std::make_unique<Acting>(), 100.0, inputs, clock, service);
    std::atomic<bool> isDone = false;
    std::thread steps([&] {
      while (!isDone) loop.runSteps(1);
    });
    const auto arrived = [&loop] { return sumOf(loop.state()).inputs; };
    for (std::uint32_t gesture = 1; gesture <= kGestures; ++gesture) {
      loop.setGesture(gesture);
      SimulationInput input = at(1.0);
      input.gesture = gesture;
      inputs->pushFromWindow(input);
      while (arrived() < gesture) std::this_thread::yield();
    }
    isDone = true;
    steps.join();
    QCOMPARE(sumOf(loop.state()).sum, static_cast<double>(kGestures));
  }

  // A simulation is exchanged while the thread runs, and its steps are late all the time: nobody starves.
  void isExchangedWhileItRuns() {
    MonotonicClock clock;
    Service service("simulation");
    const auto inputs = std::make_shared<SimulationInputs>(kWaitingInputs);
    const auto slow = [] { return std::make_unique<Summing>(std::chrono::milliseconds(3)); };
    SimulationLoop loop(slow(), 1000.0, inputs, clock, service);
    loop.start();
    for (int i = 0; i < 20; ++i) {
      inputs->push(at(1.0));
      const auto taken = loop.take();
      QCOMPARE(sumOf(taken->state()).inputs, 1u);
      loop.replace(slow());
      QCOMPARE(sumOf(loop.state()).inputs, 0u);
    }
  }

  // A step that throws ends the simulation, not the program; the owner is informed.
  void aStepThatThrows() {
    MonotonicClock clock;
    Service service("simulation");
    const auto inputs = std::make_shared<SimulationInputs>(kWaitingInputs);
    SimulationLoop loop(std::make_unique<Failing>(), 1000.0, inputs, clock, service);
    loop.rethrow();
    loop.start();
    const auto hasThrown = [&loop] {
      try {
        loop.rethrow();
      } catch (const std::runtime_error& error) {
        return std::string(error.what()) == "no memory";
      }
      return false;
    };
    QTRY_VERIFY(hasThrown());
    QVERIFY_EXCEPTION_THROWN(loop.take(), std::runtime_error);
    QCOMPARE(sumOf(loop.state()).steps, 2u);
    loop.replace(std::make_unique<Summing>());
    loop.rethrow();
    QTRY_VERIFY(sumOf(loop.state()).steps > 3);
  }

  // It throws while the owner waits for its end.
  void aStepThatThrowsMeanwhile() {
    MonotonicClock clock;
    for (const bool isTaken : {true, false}) {
      Service service("simulation");
      std::atomic<bool> isInStep = false, mayThrow = false;
      SimulationLoop loop(std::make_unique<FailingLater>(isInStep, mayThrow), 1000.0,
                          std::make_shared<SimulationInputs>(kWaitingInputs), clock, service);
      loop.start();
      while (!isInStep) std::this_thread::yield();
      mayThrow = true;
      bool wasLookedAt = false;
      if (isTaken) {
        QVERIFY_EXCEPTION_THROWN(loop.take(), std::runtime_error);
      } else {
        QVERIFY_EXCEPTION_THROWN(loop.look([&](Simulation&) { wasLookedAt = true; }), std::runtime_error);
      }
      QVERIFY(!wasLookedAt);
    }
  }
};

HANDWHEEL_TEST(SimulationLoopTest)
#include "SimulationLoopTest.moc"
