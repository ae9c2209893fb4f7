// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "openhaptics/HdSession.h"

#include "HdStandIn.h"
#include "TestClass.h"
#include "haptics/device/DeviceErrors.h"
#include "openhaptics/Driver.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace handwheel;

// The bridge's own logic, on a stand-in of the manufacturer's library.
class HdSessionTest : public QObject {
  Q_OBJECT

 private:
  HdStandIn& m_device = HdStandIn::only();
  std::unique_ptr<openhaptics::HdSession> m_session;

  template <class Look>
  auto look(Look what) {
    const std::lock_guard lock(m_device.mutex);
    return what(m_device);
  }
  DeviceState exchangeUntil(DeviceStatus status, const DeviceForce& force = {}) {
    DeviceState state;
    for (int i = 0; i < 500 && state.status != status; ++i) state = m_session->exchange(force);
    return state;
  }
  Vec3 force() {
    return look([](const HdStandIn& device) { return device.force.value_or(Vec3::Zero()); });
  }

 private slots:
  void init() {
    m_device.reset();
    m_session = std::make_unique<openhaptics::HdSession>(openhaptics::kDefaultDevice, std::make_shared<SteadyClock>());
  }
  void cleanup() { m_session.reset(); }

  void readsTheDevice() {
    QVERIFY(m_session->open({}).hasValue());
    look([](HdStandIn& device) { return device.buttons = 2; });
    const DeviceState state = exchangeUntil(DeviceStatus::Ready);
    QVERIFY((state.position - Vec3(10.0, -50.0, 0.0)).norm() < 1e-12);  // from the middle of its space
    QVERIFY(state.hasVelocity && state.velocity == Vec3(1.0, 2.0, 3.0));
    QVERIFY((state.orientation * Vec3::UnitX() - Vec3::UnitY()).norm() < 1e-12);
    QTRY_COMPARE(m_session->exchange({}).buttons, 2u);
    const DeviceCapabilities all = m_session->capabilities();
    QCOMPARE(all.workspaceRadius, 70.0);  // half of the least side
    QCOMPARE(all.maxStiffness, 0.5);
    QCOMPARE(all.maxForce, 3.3);
    QVERIFY(look([](const HdStandIn& device) { return device.isForceOn && device.name.empty(); }));
  }

  void namesAreTheMakersOwn() {
    m_session = std::make_unique<openhaptics::HdSession>("Left Device", std::make_shared<SteadyClock>());
    QVERIFY(m_session->open({}).hasValue());
    QVERIFY(look([](const HdStandIn& device) { return device.name == "Left Device"; }));
  }

  void pushesAndStops() {
    QVERIFY(m_session->open({}).hasValue());
    const DeviceForce push{Vec3(0.5, 1.0, -2.0), Vec3::Zero(), 0.0};
    exchangeUntil(DeviceStatus::Ready);
    for (int i = 0; i < 5; ++i) m_session->exchange(push);
    QCOMPARE(force(), push.force);
    m_session->close();
    QVERIFY(force().isZero());
    QVERIFY(look([](const HdStandIn& device) { return !device.isRunning; }));
  }

  // The callback goes on although nobody requests forces any more.
  void aForceDoesNotOutliveWhoAskedForIt() {
    QVERIFY(m_session->open({}).hasValue());
    exchangeUntil(DeviceStatus::Ready);
    const DeviceForce push{Vec3(0.0, 1.0, 0.0), Vec3::Zero(), 0.0};
    for (int i = 0; i < 5; ++i) m_session->exchange(push);
    QVERIFY(!force().isZero());
    QTRY_VERIFY(force().isZero());
    const int frames = look([](const HdStandIn& device) { return device.frames; });
    QTRY_VERIFY(look([&](const HdStandIn& device) { return device.frames > frames; }));
  }

  void noForceBeforeItKnowsItsPosition() {
    m_device.needsInkwell = true;
    QVERIFY(m_session->open({}).hasValue());
    const DeviceForce push{Vec3(0.0, 1.0, 0.0), Vec3::Zero(), 0.0};
    QCOMPARE(exchangeUntil(DeviceStatus::NeedsHoming, push).status, DeviceStatus::NeedsHoming);
    for (int i = 0; i < 10; ++i) m_session->exchange(push);
    QVERIFY(force().isZero());
    look([](HdStandIn& device) { return device.isInInkwell = true; });
    QCOMPARE(exchangeUntil(DeviceStatus::Ready, push).status, DeviceStatus::Ready);
  }

  // The manufacturer's example: one of the styles that a device knows is requested; AUTO before INKWELL before
  // ENCODER_RESET.
  void oneStyleOfCalibrationIsAskedFor_data() {
    QTest::addColumn<int>("known");
    QTest::addColumn<unsigned>("asked");
    const int reset = HD_CALIBRATION_ENCODER_RESET, automatic = HD_CALIBRATION_AUTO, inkwell = HD_CALIBRATION_INKWELL;
    QTest::newRow("inkwell") << inkwell << unsigned(inkwell);
    QTest::newRow("reset") << reset << unsigned(reset);
    QTest::newRow("inkwell, reset") << (inkwell | reset) << unsigned(inkwell);
    QTest::newRow("all") << (inkwell | reset | automatic) << unsigned(automatic);
  }
  void oneStyleOfCalibrationIsAskedFor() {
    QFETCH(int, known);
    QFETCH(unsigned, asked);
    m_device.calibrationStyles = known;
    m_device.needsInkwell = m_device.isInInkwell = true;
    QVERIFY(m_session->open({}).hasValue());
    QTRY_COMPARE((m_session->exchange({}), look([](const HdStandIn& device) { return device.askedStyle; })), asked);
  }

  void aSchedulerThatStandsStillHasFailed() {
    QVERIFY(m_session->open({}).hasValue());
    exchangeUntil(DeviceStatus::Ready);
    look([](HdStandIn& device) { return device.isStalled = true; });
    QCOMPARE(exchangeUntil(DeviceStatus::Failed).status, DeviceStatus::Failed);
    look([](HdStandIn& device) { return device.isStalled = false; });
    QCOMPARE(exchangeUntil(DeviceStatus::Ready).status, DeviceStatus::Ready);
  }

  void withoutADeviceItSaysTheMakersReason() {
    m_device.isPlugged = false;
    const Status opened = m_session->open({});
    QVERIFY(!opened.hasValue() && opened.error().code == DeviceError::Unreachable);
    QCOMPARE(opened.error().arguments[0], std::string("no device"));
  }

  // The process itself, started like by the plugin.
  void theBridgeIsAProcess() {
    openhaptics::Driver driver(test::buildPath("tests/BridgeStandIn").toStdString());
    const auto device = driver.make(openhaptics::kDefaultDevice);
    QVERIFY(device && device->capabilities().maxStiffness == 0.4);  // value of its kind
    QVERIFY(device->open({}).hasValue());
    QCOMPARE(device->capabilities().maxStiffness, 0.5);  // its own value
    QTRY_COMPARE(device->read().status, DeviceStatus::Ready);
    QVERIFY((device->read().position - Vec3(10.0, -50.0, 0.0)).norm() < 1e-12);
    device->close();
    QCOMPARE(device->read().status, DeviceStatus::Absent);
  }

  // No device is offered if the bridge was not built.
  void theDriverNeedsTheBridge() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("openhaptics").toStdString();
    openhaptics::Driver driver(path);
    QVERIFY(driver.find().empty());
    QVERIFY(!driver.make(openhaptics::kDefaultDevice));
    QFile bridge(QString::fromStdString(path));
    QVERIFY(bridge.open(QIODevice::WriteOnly));
    QCOMPARE(driver.find().size(), std::size_t{1});
    qputenv("HANDWHEEL_OPENHAPTICS_DEVICES", "Left Device:Right Device");
    QCOMPARE(driver.find().size(), std::size_t{2});
    QVERIFY(driver.make("Right Device") && !driver.make("Default Device"));
    qunsetenv("HANDWHEEL_OPENHAPTICS_DEVICES");
    const auto device = driver.make(openhaptics::kDefaultDevice);
    const Status opened = device->open({});  // it is no program
    QVERIFY(!opened.hasValue() && opened.error().code == DeviceError::Unreachable);
  }
};

HANDWHEEL_TEST(HdSessionTest)
#include "HdSessionTest.moc"
