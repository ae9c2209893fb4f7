// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "falcon/FalconEmulator.h"
#include "haptics/device/DeviceErrors.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::falcon;

class FalconSessionTest : public QObject {
  Q_OBJECT

 private:
  std::shared_ptr<FalconEmulator> m_falcon;
  std::shared_ptr<FakeClock> m_clock;
  std::unique_ptr<falcon::Session> m_session;

  // Runs until it is ready; returns the number of readings.
  int untilReady(const DeviceForce& force = {}) {
    for (int i = 1; i <= 1000; ++i) {
      if (m_session->exchange(force).status == DeviceStatus::Ready) return i;
    }
    return 0;
  }

 private slots:
  void init() {
    m_falcon = std::make_shared<FalconEmulator>();
    m_clock = std::make_shared<FakeClock>();
    m_session = falconSession(m_falcon, m_clock);
  }

  void firmwareIsLoadedWhereThereIsNone() {
    QVERIFY(m_session->open({}).hasValue());
    QVERIFY(m_falcon->running);
    QCOMPARE(m_falcon->loads, 1);
    QCOMPARE(untilReady(), 1);
  }

  void firmwareThatRunsIsLeftAlone() {
    m_falcon->running = true;
    QVERIFY(m_session->open({}).hasValue());
    QCOMPARE(m_falcon->loads, 0);
  }

  void aFlakyLoadIsTriedAgain() {
    m_falcon->spoiltLoads = 7;
    m_falcon->deafGreetings = 42;
    m_falcon->leadingZero = true;
    JobState job;
    QVERIFY(m_session->open(Progress(job)).hasValue());
    QCOMPARE(m_falcon->loads, 8);
    QVERIFY(job.fraction > 0.0 && job.fraction <= 1.0);
  }

  void aLoadThatNeverWorksIsGivenUp() {
    m_falcon->spoiltLoads = 1000;
    const Status opened = m_session->open({});
    QCOMPARE(opened.error().code, DeviceError::NotResponding);
    QCOMPARE(opened.error().arguments[0], std::string("the firmware's echo"));
    m_falcon->deafGreetings = 100'000;
    QCOMPARE(m_session->open({}).error().arguments[0], std::string("the bootloader's greeting"));
  }

  void theWrongFirmwareDoesNotRun() {
    m_falcon->running = false;
    const FalconEmulator::Bytes right = m_falcon->image;
    const auto connect = [this]() -> Result<std::unique_ptr<UsbTransport>> {
      return std::unique_ptr<UsbTransport>(std::make_unique<FakeUsb>(m_falcon, m_clock));
    };
    falcon::Session session(
        connect, []() -> Result<Firmware> { return Firmware(100, 7); }, m_clock);
    QCOMPARE(session.open({}).error().arguments[0], std::string("a packet of the firmware"));
  }

  void aMissingFirmwareFileIsReported() {
    const auto connect = [this]() -> Result<std::unique_ptr<UsbTransport>> {
      return std::unique_ptr<UsbTransport>(std::make_unique<FakeUsb>(m_falcon, m_clock));
    };
    const Error missing{ErrorCode::ReferenceMissing, {"the firmware file", "falcon.bin"}, {}, {}};
    falcon::Session session(
        connect, [&]() -> Result<Firmware> { return missing; }, m_clock);
    QCOMPARE(session.open({}).error().code, ErrorCode::ReferenceMissing);
    session.close();
    QCOMPARE(session.exchange({}).status, DeviceStatus::Absent);
  }

  void loadingCanBeCancelled() {
    JobState job;
    job.cancelled = true;
    QCOMPARE(m_session->open(Progress(job)).error().code, ErrorCode::Cancelled);
    QVERIFY(m_clock->now() < 1.0);
  }

  void unpluggedWhileLoading() {
    m_falcon->unpluggedAt = 5000;
    QCOMPARE(m_session->open({}).error().code, DeviceError::Unreachable);
    QCOMPARE(m_falcon->loads, 1);  // and not tried again
  }

  void unpluggedBeforeItIsAsked() {
    m_falcon->gone = true;
    QCOMPARE(m_session->open({}).error().code, DeviceError::Unreachable);
    m_session->close();
    QCOMPARE(m_session->exchange({}).status, DeviceStatus::Absent);
  }

  // The position cannot be known before homing, and leaps with it: no torque until then, whatever is asked.
  void noTorqueBeforeItIsHomed() {
    m_falcon->running = true;
    m_falcon->packetsToHoming = 300;
    QVERIFY(m_session->open({}).hasValue());
    const DeviceForce push{Vec3(5, -5, 5), Vec3::Zero(), 0.0};
    const DeviceState first = m_session->exchange(push);
    QCOMPARE(first.status, DeviceStatus::NeedsHoming);
    QVERIFY(first.position.isZero(0.0));
    QVERIFY(m_falcon->lights & kHoming);
    QVERIFY(untilReady(push) >= 250);
    QCOMPARE(m_falcon->largestBeforeHomed, 0);
    m_session->exchange(push);
    QVERIFY(m_falcon->torques != (std::array<int, 3>{}));
    QVERIFY(!(m_falcon->lights & kHoming));
    m_falcon->packetsToHoming = 5;  // it loses its homing
    m_session->exchange(push);
    QCOMPARE(m_session->exchange(push).status, DeviceStatus::NeedsHoming);
    QCOMPARE(*m_falcon->torques, (std::array<int, 3>{}));
  }

  void readsWhereItIs() {
    m_falcon->running = true;
    QVERIFY(m_session->open({}).hasValue());
    m_falcon->encoders = {400, -200, 100};
    m_falcon->buttons = 6;
    QCOMPARE(untilReady(), 1);
    const DeviceState state = m_session->exchange({});
    QVERIFY((state.position - Vec3(15.775, -16.182, 136.953 - 134.6)).cwiseAbs().maxCoeff() < 1e-3);
    QCOMPARE(state.buttons, 6u);
  }

  void pushesAsAsked() {
    m_falcon->running = true;
    QVERIFY(m_session->open({}).hasValue());
    untilReady();
    m_session->exchange({Vec3(0, 0, 1), Vec3::Zero(), 0.0});
    QCOMPARE(*m_falcon->torques, (std::array<int, 3>{-249, -249, -249}));
    m_session->close();
    QCOMPARE(*m_falcon->torques, (std::array<int, 3>{}));
  }

  void shortPacketsMakeNoFalseReadings() {
    m_falcon->running = true;
    m_falcon->shortEvery = 3;
    QVERIFY(m_session->open({}).hasValue());
    m_falcon->encoders = {500, 500, 500};
    untilReady();
    int ready = 0;
    for (int i = 0; i < 300; ++i) {
      const DeviceState state = m_session->exchange({});
      QVERIFY((state.position - Vec3(0, 0, 156.860 - 134.6)).norm() < 2e-3);
      QCOMPARE(state.buttons, 0u);
      ready += state.status == DeviceStatus::Ready;
    }
    QCOMPARE(ready, 300);
  }

  // Answers do not lag behind the questions permanently.
  void aLateAnswerIsNotTakenForTheNext() {
    m_falcon->running = true;
    QVERIFY(m_session->open({}).hasValue());
    untilReady();
    m_falcon->lateOnce = true;
    m_session->exchange({});
    QVERIFY(!m_falcon->late.empty());  // it was waited for in vain
    m_falcon->encoders = {500, 500, 500};
    QVERIFY((m_session->exchange({}).position - Vec3(0, 0, 156.860 - 134.6)).norm() < 2e-3);
    QVERIFY(m_falcon->late.empty() && m_falcon->toHost.empty());
  }

  void aStallFailsAndComesBack() {
    m_falcon->running = true;
    QVERIFY(m_session->open({}).hasValue());
    untilReady();
    m_falcon->stalled = true;
    const double start = m_clock->now();
    QCOMPARE(m_session->exchange({}).status, DeviceStatus::Ready);  // one late answer is not a missed one
    while (m_clock->now() < start + 0.2) m_session->exchange({Vec3(0, 0, 1), Vec3::Zero(), 0.0});
    QCOMPARE(m_session->exchange({}).status, DeviceStatus::Failed);
    m_falcon->stalled = false;
    m_session->exchange({Vec3(0, 0, 1), Vec3::Zero(), 0.0});
    QCOMPARE(*m_falcon->torques, (std::array<int, 3>{}));  // the first packet after a fault carries none
    QCOMPARE(m_session->exchange({}).status, DeviceStatus::Ready);
  }

  void anglesThatCannotBeAreAFault() {
    m_falcon->running = true;
    QVERIFY(m_session->open({}).hasValue());
    untilReady();
    const Vec3 before = m_session->exchange({}).position;
    m_falcon->encoders = {32767, -32768, 32767};
    const DeviceState state = m_session->exchange({});
    QCOMPARE(state.status, DeviceStatus::Failed);
    QVERIFY(state.position == before);
  }

  void unpluggedItIsAbsent() {
    m_falcon->running = true;
    QVERIFY(m_session->open({}).hasValue());
    untilReady();
    m_falcon->gone = true;
    QCOMPARE(m_session->exchange({}).status, DeviceStatus::Absent);
    m_session->close();
  }
};

HANDWHEEL_TEST(FalconSessionTest)
#include "FalconSessionTest.moc"
