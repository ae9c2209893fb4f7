// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "example/ExampleEmulator.h"
#include "falcon/FalconEmulator.h"
#include "guard/GuardedSubject.h"
#include "haply/HaplyEmulator.h"
#include "openhaptics/HdSubject.h"
#include "polhem/PolhemEmulator.h"
#include "spacemouse/SpaceMouseEmulator.h"

#include <QtTest>
#include <cmath>
#include <limits>
#include <thread>

using namespace handwheel;

namespace {

// Returns a Polhem held by a guard, without the process.
ContractSubject guardedPolhemSubject() {
  const auto peer = std::make_shared<PolhemEmulator>();
  const auto clock = std::make_shared<FakeClock>(FakeClock::Pace::Real);
  const auto host = std::make_shared<HostedSession>([=] { return polhemSession(peer, clock); });
  return guardedSubject(host, polhem::Session({}, {}).capabilities(), polhemSubject(peer, clock));
}

}  // namespace

// The guarantees to the servo loop, for every device of every plugin.
class DeviceContractTest : public QObject {
  Q_OBJECT

 private:
  using MakeSubject = ContractSubject (*)();
  ContractSubject m_subject;
  std::unique_ptr<Device> m_device;

  static bool isSane(const DeviceState& state) {
    return state.position.allFinite() && state.velocity.allFinite() && std::isfinite(state.gripper) &&
           std::abs(state.orientation.norm() - 1.0) < 1e-9;
  }

  static bool drives(const DeviceState& state) {
    return state.status == DeviceStatus::Ready || state.status == DeviceStatus::NeedsHoming;
  }

  // Calls the device like the servo loop, until the state is as wanted. Returns false if it never is.
  template <class Wanted>
  bool tickUntil(Wanted wanted, const DeviceForce& force = {}) {
    for (int i = 0; i < 5000; ++i) {
      const DeviceState state = m_device->read();
      if (!isSane(state)) return false;
      if (wanted(state)) return true;
      m_device->write(force);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  }

  bool becomes(DeviceStatus status) {
    return tickUntil([=](const DeviceState& state) { return state.status == status; });
  }

 private slots:
  void initTestCase_data() {
    QTest::addColumn<MakeSubject>("make");
    QTest::newRow("example") << &exampleSubject;
    QTest::newRow("falcon") << &falconSubject;
    QTest::newRow("haply") << &haplySubject;
    QTest::newRow("openhaptics") << &hdSubject;
    QTest::newRow("polhem") << +[] { return polhemSubject(); };
    QTest::newRow("polhem, guarded") << &guardedPolhemSubject;
    QTest::newRow("spacemouse, HID") << &spaceMouseHidSubject;
    QTest::newRow("spacemouse, spacenavd") << &spaceNavSubject;
  }

  void init() {
    QFETCH_GLOBAL(MakeSubject, make);
    m_subject = make();
    m_device = m_subject.make();
    QVERIFY(m_device != nullptr);
  }

  void cleanup() { m_device.reset(); }

  void aClosedDeviceIsAbsentAndHarmless() {
    m_device->write({Vec3(1, 2, 3), Vec3::Zero(), 0.0});
    QCOMPARE(m_device->read().status, DeviceStatus::Absent);
    QVERIFY(isSane(m_device->read()));
    m_device->close();
    QCOMPARE(m_device->read().status, DeviceStatus::Absent);
  }

  void capabilitiesMakeSense() {
    const DeviceCapabilities all = m_device->capabilities();
    QVERIFY(all.inputs >= 2 && all.inputs <= 7);
    QVERIFY(all.outputs == 0 || all.outputs == 3 || all.outputs == 6 || all.outputs == 7);
    QVERIFY(all.buttons >= 0 && all.buttons <= 32);
    for (const double value : {all.maxForce, all.maxTorque, all.maxGripperForce, all.maxStiffness,
                               all.maxAngularStiffness, all.maxDamping, all.inherentDamping, all.latency}) {
      QVERIFY(std::isfinite(value) && value >= 0.0);
    }
    QVERIFY(all.workspaceRadius > 0.0 && all.workspaceRadius < 1e4);
    QVERIFY(all.nominalRate >= 10.0 && all.nominalRate <= 10'000.0);
    QCOMPARE(all.maxForce > 0.0, all.outputs >= 3);
    QCOMPARE(all.outputs > 0, m_subject.motorForce != nullptr);
    QVERIFY(!all.isRateControl || all.outputs == 0);
  }

  void comesUpAndReadsSane() {
    QVERIFY(m_device->open({}).hasValue());
    QVERIFY(tickUntil(drives));
    for (int i = 0; i < 100; ++i) QVERIFY(isSane(m_device->read()));
  }

  // A device with motors says which of its readings are new, so that a force is not held on ones that are old.
  void motorsComeWithACount() {
    if (!m_subject.motorForce) QSKIP("it has no motors");
    QVERIFY(m_device->open({}).hasValue());
    QVERIFY(becomes(DeviceStatus::Ready));
    const std::uint32_t first = m_device->read().reading;
    QVERIFY(first > 0);
    QVERIFY(tickUntil(
        [=](const DeviceState& state) { return state.reading - first > 20 && state.reading - first < 5000; }));
  }

  void opensAgain() {
    for (int i = 0; i < 3; ++i) {
      QVERIFY(m_device->open({}).hasValue());
      QVERIFY(tickUntil(drives));
      m_device->close();
      QCOMPARE(m_device->read().status, DeviceStatus::Absent);
    }
    QVERIFY(m_device->open({}).hasValue());
    QVERIFY(m_device->open({}).hasValue());  // without closing it in between
    QVERIFY(tickUntil(drives));
  }

  void closesWithZeroForce() {
    QVERIFY(m_device->open({}).hasValue());
    QVERIFY(becomes(DeviceStatus::Ready));
    const DeviceForce force{Vec3(0.0, 0.0, 1.0), Vec3::Zero(), 0.0};
    if (m_subject.motorForce) {
      const auto holds = [&](const DeviceState&) {
        const std::optional<Vec3> held = m_subject.motorForce();
        return held && (*held - force.force).norm() < 0.05;
      };
      QVERIFY(tickUntil(holds, force));
    }
    m_device->close();
    m_device->close();
    m_device->write(force);
    if (m_subject.motorForce) {
      QVERIFY(m_subject.motorForce().has_value());
      QVERIFY(m_subject.motorForce()->isZero(1e-12));
    }
    QCOMPARE(m_device->read().status, DeviceStatus::Absent);
  }

  // A force ends also if nobody takes it back.
  void aSilentServoLoopHoldsNoForce() {
    if (!m_subject.motorForce) QSKIP("it has no motors");
    QVERIFY(m_device->open({}).hasValue());
    QVERIFY(becomes(DeviceStatus::Ready));
    const auto isZero = [this] { return m_subject.motorForce()->isZero(1e-12); };
    const auto pushes = [&](const DeviceState&) { return !isZero(); };
    QVERIFY(tickUntil(pushes, {Vec3(0.0, 0.0, 1.0), Vec3::Zero(), 0.0}));
    QTRY_VERIFY_WITH_TIMEOUT(isZero(), 5000);
  }

  void noForceThatIsNoNumberArrives() {
    if (!m_subject.motorForce) QSKIP("it has no motors");
    QVERIFY(m_device->open({}).hasValue());
    QVERIFY(becomes(DeviceStatus::Ready));
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
      for (int i = 0; i < 50; ++i) {
        m_device->write({Vec3(0.0, bad, 1.0), Vec3(bad, 0.0, 0.0), bad});
        QVERIFY(m_subject.motorForce()->isZero(1e-12));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    }
  }

  void unpluggedItIsAbsent() {
    QVERIFY(m_device->open({}).hasValue());
    QVERIFY(becomes(DeviceStatus::Ready));
    m_subject.unplug();
    QVERIFY(becomes(DeviceStatus::Absent));
    m_device->write({Vec3(1, 2, 3), Vec3::Zero(), 0.0});
    QCOMPARE(m_device->read().status, DeviceStatus::Absent);
    m_device->close();
    m_device->close();
    QVERIFY(!m_device->open({}).hasValue() || becomes(DeviceStatus::Absent));
  }

  void nonsenseStaysOutside() {
    QVERIFY(m_device->open({}).hasValue());
    QVERIFY(becomes(DeviceStatus::Ready));
    for (int i = 0; i < 100; ++i) {
      m_subject.corrupt();
      const DeviceState state = m_device->read();
      QVERIFY(isSane(state));
      QVERIFY(state.position.norm() < 1e4);
      m_device->write({});
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
};

HANDWHEEL_TEST(DeviceContractTest)
#include "DeviceContractTest.moc"
