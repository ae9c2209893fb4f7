// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FakeClock.h"
#include "TestClass.h"
#include "haptics/device/DeviceErrors.h"
#include "io/SessionHost.h"

#include <rapidcheck.h>
#include <QtTest>
#include <algorithm>
#include <deque>
#include <functional>

using namespace handwheel;

namespace {

constexpr double kTick = 0.001;  // s that the device takes for an exchange

// A device that records the forces of its motors, with the times.
struct Motors : handwheel::Session {
  struct Sent {
    double time;
    Vec3 force;
  };
  std::shared_ptr<FakeClock> clock;
  std::vector<Sent> sent;
  Status result = Done{};
  bool waitsForCancel = false;
  bool isClosed = false;
  bool wasCancelled = false;
  DeviceStatus status = DeviceStatus::Ready;

  explicit Motors(std::shared_ptr<FakeClock> by) : clock(std::move(by)) {}
  DeviceCapabilities capabilities() const override {
    DeviceCapabilities all;
    all.maxForce = 4.5;
    all.workspaceRadius = 55.0;
    return all;
  }
  Status open(Progress progress) override {
    while (waitsForCancel && !progress.cancelled()) std::this_thread::yield();
    wasCancelled = progress.cancelled();
    return result;
  }
  DeviceState exchange(const DeviceForce& force) noexcept override {
    clock->sleep(kTick);
    sent.push_back({clock->now(), force.force});
    DeviceState state;
    state.status = status;
    return state;
  }
  void close() noexcept override {
    isClosed = true;
    sent.push_back({clock->now(), Vec3::Zero()});
  }
};

// The program from the host's side: requests the device, waits until it is open, sends its messages with pauses between
// them, and is then gone, or silent.
class ScriptedProgram : public ByteStream {
 public:
  struct Word {
    double pause;  // s after the one before, the first after the device was opened
    std::string bytes;
  };
  explicit ScriptedProgram(std::shared_ptr<FakeClock> clock) : m_clock(std::move(clock)) { say(0.0, guard::Open{}); }
  void say(double pause, const guard::Message& message) {
    guard::Buffer buffer;
    const auto bytes = guard::bytesOf(message, buffer);
    words.push_back({pause, {bytes.begin(), bytes.end()}});
  }

  std::ptrdiff_t read(std::span<std::uint8_t> into, double timeout) noexcept override {
    const bool mayTalk = isOpened || isHasty || !m_hasAsked;
    if (!mayTalk) {
      m_clock->sleep(timeout);
      return 0;
    }
    if (words.empty()) {
      if (atTheEnd) atTheEnd();
      if (m_clock->now() - m_last >= silenceAtTheEnd) return kGone;
      m_clock->sleep(timeout);
      return 0;
    }
    const double due = m_last + words.front().pause;
    if (due > m_clock->now() + timeout) {
      m_clock->sleep(timeout);
      return 0;
    }
    if (due > m_clock->now()) m_clock->sleep(due - m_clock->now());
    const std::string bytes = words.front().bytes;
    words.pop_front();
    m_last = m_clock->now();
    m_hasAsked = true;
    std::copy(bytes.begin(), bytes.end(), into.begin());
    return static_cast<std::ptrdiff_t>(bytes.size());
  }

  bool write(std::span<const std::uint8_t> bytes) noexcept override {
    m_reader.add(bytes);
    while (auto message = m_reader.next()) {
      if (std::holds_alternative<guard::Opened>(*message)) {
        isOpened = true;
        m_last = m_clock->now();
      }
      heard.push_back(std::move(*message));
    }
    return true;
  }

  template <class Kind>
  const Kind* lastHeard() const {
    const Kind* last = nullptr;
    for (const guard::Message& message : heard) {
      if (const auto* one = std::get_if<Kind>(&message)) last = one;
    }
    return last;
  }

  std::deque<Word> words;
  std::vector<guard::Message> heard;
  double silenceAtTheEnd = 0.0;  // s
  std::function<void()> atTheEnd;
  bool isOpened = false;
  bool isHasty = false;  // does not wait until it is open

 private:
  std::shared_ptr<FakeClock> m_clock;
  guard::Reader m_reader;
  double m_last = 0.0;
  bool m_hasAsked = false;
};

DeviceForce push(double newtons = 2.0) {
  return {Vec3(0.0, 0.0, newtons), Vec3::Zero(), 0.0};
}

struct SessionHostFixture {
  std::shared_ptr<FakeClock> clock = std::make_shared<FakeClock>();
  Motors motors{clock};
  ScriptedProgram program{clock};
  std::atomic<bool> stop{false};

  void serve() { guard::SessionHost(motors, program, *clock, stop).serve(); }
};

}  // namespace

class SessionHostTest : public QObject {
  Q_OBJECT

 private slots:
  void passesForcesAndPlacesOn() {
    SessionHostFixture fixture;
    for (std::uint32_t i = 1; i <= 5; ++i) fixture.program.say(0.001, guard::Force{i, push(i)});
    fixture.serve();
    QCOMPARE(fixture.program.lastHeard<guard::Opened>()->capabilities.maxForce, 4.5);
    QCOMPARE(fixture.program.lastHeard<guard::State>()->number, std::uint32_t{5});
    QCOMPARE(fixture.program.lastHeard<guard::State>()->state.status, DeviceStatus::Ready);
    QCOMPARE(fixture.motors.sent[4].force.z(), 5.0);
  }

  // For each ending of the program: killed, leaving, sending nonsense, asked to stop.
  void theEndIsZeroForce() {
    for (const char* how : {"gone", "close", "nonsense", "stop"}) {
      SessionHostFixture fixture;
      fixture.program.say(0.001, guard::Force{1, push()});
      fixture.program.say(0.001, guard::Force{2, push()});
      const std::string ending = how;
      if (ending == "close") fixture.program.say(0.001, guard::Close{});
      if (ending == "nonsense") fixture.program.words.push_back({0.001, std::string(20, '\xff')});
      if (ending != "gone") fixture.program.silenceAtTheEnd = 1e9;
      if (ending == "stop") fixture.program.atTheEnd = [&fixture] { fixture.stop = true; };
      fixture.serve();
      QCOMPARE(fixture.motors.sent[1].force, push().force);
      QVERIFY2(fixture.motors.isClosed && fixture.motors.sent.back().force.isZero(), how);
      QVERIFY2(fixture.motors.sent.back().time - fixture.motors.sent[1].time < 0.05, how);
    }
  }

  void silenceIsZeroForceUntilZeroWasAskedFor() {
    SessionHostFixture fixture;
    fixture.program.say(0.001, guard::Force{1, push()});
    fixture.program.silenceAtTheEnd = 0.2;
    fixture.program.say(0.2, guard::Force{2, push()});
    fixture.program.say(0.02, guard::Force{3, {}});  // too early for anybody to have noticed
    fixture.program.say(0.02, guard::Force{4, push()});
    fixture.program.say(0.02, guard::Force{5, push()});
    fixture.program.say(0.001, guard::Force{6, {}});
    fixture.program.say(0.001, guard::Force{7, push()});
    fixture.serve();
    const auto isPush = [](const Motors::Sent& each) { return !each.force.isZero(); };
    QCOMPARE(std::count_if(fixture.motors.sent.begin(), fixture.motors.sent.end(), isPush), 2);  // those of 1 and 7
    std::vector<DeviceStatus> statuses;
    for (const guard::Message& message : fixture.program.heard) {
      if (const auto* state = std::get_if<guard::State>(&message)) statuses.push_back(state->state.status);
    }
    const std::vector<DeviceStatus> expected{DeviceStatus::Ready,    DeviceStatus::Starting, DeviceStatus::Starting,
                                             DeviceStatus::Starting, DeviceStatus::Starting, DeviceStatus::Ready,
                                             DeviceStatus::Ready};
    QVERIFY(statuses == expected);
  }

  // For any messages of the program, no force is held 50 ms later.
  void noForceIsOlderThanFiftyMilliseconds() {
    QVERIFY(rc::check([] {
      SessionHostFixture fixture;
      for (int i = *rc::gen::inRange(1, 30); i > 0; --i) {
        const double pause = *rc::gen::element(0.0005, 0.001, 0.003, 0.03, 0.045, 0.09, 0.3);
        fixture.program.say(pause, guard::Force{1, *rc::gen::arbitrary<bool>() ? push() : DeviceForce()});
      }
      fixture.program.silenceAtTheEnd = 0.3;
      fixture.serve();
      RC_ASSERT(fixture.motors.isClosed);
      RC_ASSERT(fixture.motors.sent.back().force.isZero());
      // Between two forces, no more than 50 ms pass without a message: the gap was filled with zeros.
      for (std::size_t i = 1; i < fixture.motors.sent.size(); ++i) {
        if (!fixture.motors.sent[i - 1].force.isZero())
          RC_ASSERT(fixture.motors.sent[i].time - fixture.motors.sent[i - 1].time < 0.05);
      }
    }));
  }

  void aRefusalIsPassedOn() {
    SessionHostFixture fixture;
    fixture.motors.result = Error{ErrorCode::ReferenceMissing, {"the firmware file", "falcon.bin"}, {}, "here"};
    fixture.serve();
    const auto* refused = fixture.program.lastHeard<guard::Refused>();
    QVERIFY(refused && refused->error.code == ErrorCode::ReferenceMissing);
    QCOMPARE(refused->error.arguments[1], std::string("falcon.bin"));
    QVERIFY(fixture.motors.isClosed && !fixture.program.lastHeard<guard::Opened>());
  }

  void anotherVersionIsRefused() {
    SessionHostFixture fixture;
    fixture.program.words.clear();
    fixture.program.say(0.0, guard::Open{guard::kVersion + 1});
    fixture.serve();
    QVERIFY(fixture.program.lastHeard<guard::Refused>()->error.code == DeviceError::PluginVersion);
    QCOMPARE(fixture.motors.sent.size(), std::size_t{1});  // on closing
  }

  void whoLeavesWhileItOpensCancels() {
    SessionHostFixture fixture;
    fixture.motors.waitsForCancel = true;
    fixture.motors.result = Error{ErrorCode::Cancelled, {}, {}, {}};
    fixture.program.isHasty = true;
    fixture.program.say(0.1, guard::Close{});
    fixture.serve();
    QVERIFY(fixture.motors.wasCancelled && fixture.motors.isClosed);
    QVERIFY(fixture.program.lastHeard<guard::Opening>());
  }

  void whoNeverAsksIsLeft() {
    SessionHostFixture fixture;
    fixture.program.words.clear();
    fixture.program.silenceAtTheEnd = 1e9;  // without any message
    fixture.serve();
    QVERIFY(fixture.motors.isClosed);
  }
};

HANDWHEEL_TEST(SessionHostTest)
#include "SessionHostTest.moc"
