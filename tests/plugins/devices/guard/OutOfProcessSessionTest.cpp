// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/OutOfProcessSession.h"

#include "FakeStream.h"
#include "TestClass.h"
#include "haptics/device/DeviceErrors.h"
#include "io/DeviceHostProcess.h"

#include <QtTest>

using namespace handwheel;

namespace {

// A guard from the program's side, with its faults.
struct FakeGuard : Peer {
  bool isMute = false;      // does not answer
  bool answersOld = false;  // each answer is that to the force before
  bool isBusy = false;      // opens the device, and never ends
  bool speaksNonsense = false;
  std::optional<Error> refusal;
  std::vector<guard::Message> heard;
  DeviceState state = [] {
    DeviceState ready;
    ready.status = DeviceStatus::Ready;
    ready.position = Vec3(1, 2, 3);
    return ready;
  }();

  void receive(std::span<const std::uint8_t> bytes) override {
    m_reader.add(bytes);
    while (const auto message = m_reader.next()) {
      heard.push_back(*message);
      if (std::holds_alternative<guard::Open>(*message)) answerOpen();
      if (const auto* force = std::get_if<guard::Force>(&*message)) answer(force->number);
      if (std::holds_alternative<guard::Close>(*message)) gone = true;
    }
  }

 private:
  void say(const guard::Message& message) {
    guard::Buffer buffer;
    const auto bytes = guard::bytesOf(message, buffer);
    toHost.insert(toHost.end(), bytes.begin(), bytes.end());
  }
  void answerOpen() {
    if (speaksNonsense) toHost.insert(toHost.end(), 20, 0xff);
    if (isMute || speaksNonsense) return;
    say(guard::Opening{0.25});
    if (isBusy) return;
    if (refusal) return say(guard::Refused{*refusal});
    DeviceCapabilities all;
    all.maxForce = 7.5;
    all.workspaceRadius = 33.0;
    all.latency = 0.002;
    say(guard::Opened{all});
  }
  void answer(std::uint32_t number) {
    if (!isMute) say(guard::State{answersOld ? number - 1 : number, state});
  }

  guard::Reader m_reader;
};

DeviceCapabilities kind() {
  DeviceCapabilities all;
  all.maxForce = 5.0;
  return all;
}

struct Fixture {
  std::shared_ptr<FakeGuard> process = std::make_shared<FakeGuard>();
  std::shared_ptr<FakeClock> clock = std::make_shared<FakeClock>();
  OutOfProcessSession session{[this]() -> Result<std::unique_ptr<ByteStream>> {
                                return std::unique_ptr<ByteStream>(std::make_unique<FakeStream>(process, clock));
                              },
                              clock, kind(), "Falcon"};

  ErrorCode whyNot(Progress progress = {}) {
    const Status opened = session.open(progress);
    return opened ? ErrorCode::LibraryFailed : opened.error().code;
  }
};

}  // namespace

// The program's side of a guard.
class OutOfProcessSessionTest : public QObject {
  Q_OBJECT

 private slots:
  void asksTheDeviceItself() {
    Fixture fixture;
    QCOMPARE(fixture.session.capabilities().maxForce, 5.0);  // value of its kind
    QCOMPARE(fixture.session.exchange({}).status, DeviceStatus::Absent);
    QVERIFY(fixture.session.open({}).hasValue());
    QCOMPARE(fixture.session.capabilities().maxForce, 7.5);
    QVERIFY(fixture.session.capabilities().latency > 0.002);  // both directions
    const DeviceState state = fixture.session.exchange({Vec3(0, 0, 2), Vec3::Zero(), 0.0});
    QCOMPARE(state.status, DeviceStatus::Ready);
    QCOMPARE(state.position, Vec3(1, 2, 3));
    QCOMPARE(std::get<guard::Force>(fixture.process->heard.back()).force.force, Vec3(0, 0, 2));
  }

  void whyItIsNotOpenIsReported() {
    Fixture refused;
    refused.process->refusal = Error{ErrorCode::ReferenceMissing, {"the firmware file", "falcon.bin"}, {}, "x"};
    QCOMPARE(refused.whyNot(), ErrorCode::ReferenceMissing);
    Fixture mute;
    mute.process->isMute = true;
    QCOMPARE(mute.whyNot(), DeviceError::Unreachable);
    Fixture nonsense;
    nonsense.process->speaksNonsense = true;
    QCOMPARE(nonsense.whyNot(), DeviceError::Unreachable);
    Fixture dead;
    dead.process->gone = true;
    QCOMPARE(dead.whyNot(), DeviceError::Unreachable);
  }

  void openingTellsHowFarItIsAndCanBeCancelled() {
    Fixture fixture;
    JobState job;
    QVERIFY(fixture.session.open(Progress(job)).hasValue());
    QCOMPARE(job.fraction.load(), 0.25);
    Fixture busy;
    busy.process->isBusy = true;
    job.cancelled = true;
    QCOMPARE(busy.whyNot(Progress(job)), ErrorCode::Cancelled);
    busy.session.close();
    QVERIFY(std::holds_alternative<guard::Close>(busy.process->heard.back()));
  }

  // The watchdog of this side: it waits for each answer 20 ms at most, and fails after 100 ms.
  void aGuardThatHangsHasFailed() {
    Fixture fixture;
    QVERIFY(fixture.session.open({}).hasValue());
    QCOMPARE(fixture.session.exchange({}).status, DeviceStatus::Ready);
    fixture.process->isMute = true;
    const double begun = fixture.clock->now();
    QCOMPARE(fixture.session.exchange({}).status, DeviceStatus::Ready);  // the last known state
    QVERIFY(fixture.clock->now() - begun < 0.0201);
    for (int i = 0; i < 6; ++i) fixture.session.exchange({});
    QCOMPARE(fixture.session.exchange({}).status, DeviceStatus::Failed);
    fixture.process->isMute = false;
    QCOMPARE(fixture.session.exchange({}).status, DeviceStatus::Ready);
  }

  // An answer to an older force is not taken for the one to this; its reading is new all the same.
  void whatComesLateIsNotTakenForTheNext() {
    Fixture fixture;
    QVERIFY(fixture.session.open({}).hasValue());
    fixture.process->answersOld = true;
    const double begun = fixture.clock->now();
    QCOMPARE(fixture.session.exchange({}).position, Vec3(1, 2, 3));
    QVERIFY(fixture.clock->now() - begun > 0.019);  // it has waited for the other
  }

  void aGuardThatDiesIsADeviceThatIsGone() {
    Fixture fixture;
    QVERIFY(fixture.session.open({}).hasValue());
    fixture.process->gone = true;
    QCOMPARE(fixture.session.exchange({}).status, DeviceStatus::Absent);
    fixture.session.close();
    fixture.session.close();
  }

  void closingWaitsUntilTheGuardHasGone() {
    Fixture fixture;
    QVERIFY(fixture.session.open({}).hasValue());
    fixture.session.close();
    QVERIFY(fixture.process->gone);
    QCOMPARE(fixture.session.exchange({}).status, DeviceStatus::Absent);
  }

  // Real processes that are no guards.
  void aProgramThatIsNoGuardIsFoundOut() {
    for (const char* path : {"/nowhere/at/all", "/bin/true"}) {
      const auto session = guarded(path, "address", kind(), "Falcon");
      const Status opened = session->open({});
      QVERIFY2(!opened.hasValue() && opened.error().code == DeviceError::Unreachable, path);
      session->close();
    }
  }
};

HANDWHEEL_TEST(OutOfProcessSessionTest)
#include "OutOfProcessSessionTest.moc"
