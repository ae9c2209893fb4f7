// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "example/Session.h"
#include "falcon/Session.h"
#include "haply/Session.h"
#include "haptics/safety/SafetySettings.h"
#include "haptics/safety/StiffnessLimit.h"
#include "haptics/servo/ServoStatistics.h"
#include "openhaptics/Driver.h"
#include "polhem/Session.h"

#include <QtTest>

using namespace handwheel;

namespace {

constexpr double kPeriod = 0.001;  // s: every stiffness below is stated for 1 kHz

}  // namespace

// The stiffest wall that the loop allows on each device, compared with the stated one.
class StiffnessCapTest : public QObject {
  Q_OBJECT

 private slots:
  // A program that speaks to the device in each tick, like that for which a stiffness is stated, answers a reading an
  // exchange later: 1 ms. Ours waits one more for its threads, and 0.2 ms if another process guards the motors. Only
  // these may lower the cap: K·(T/2 + t)/(T/2 + t + ours).
  void onlyOurOwnDelaySoftens_data() {
    QTest::addColumn<DeviceCapabilities>("device");
    QTest::addColumn<double>("stated");  // N/mm
    QTest::addColumn<double>("guard");   // s
    QTest::addColumn<double>("cap");     // N/mm
    // 3000 N/m, 1000 N/m, 1500 N/m, 400 N/m in CHAI3D and the manufacturers' forks of it.
    QTest::newRow("falcon") << falcon::Session({}, {}, {}).capabilities() << 3.0 << 0.0002 << 3.0 * 1.5 / 2.7;
    QTest::newRow("haply") << haply::Session({}, {}).capabilities() << 1.0 << 0.0 << 1.0 * 1.5 / 2.5;
    QTest::newRow("polhem") << polhem::Session({}, {}).capabilities() << 1.5 << 0.0002 << 1.5 * 1.5 / 2.7;
    QTest::newRow("touch") << openhaptics::touchCapabilities() << 0.4 << 0.0002 << 0.4 * 1.5 / 2.7;
    QTest::newRow("example") << ExampleSession({}).capabilities() << 1.0 << 0.0 << 1.0 * 1.5 / 2.5;
  }
  void onlyOurOwnDelaySoftens() {
    QFETCH(DeviceCapabilities, device);
    QFETCH(double, stated);
    QFETCH(double, guard);
    QFETCH(double, cap);
    device.latency += guard;
    const double allowed = stiffnessLimit({kPeriod, device.latency, device.inherentDamping}, 0.0);
    qInfo("%-8s %.2f of %.2f N/mm, %.1f ms of delay", QTest::currentDataTag(), allowed, stated, device.latency * 1e3);
    QCOMPARE(device.maxStiffness, stated);
    QCOMPARE(device.nominalRate, 1.0 / kPeriod);
    QCOMPARE(allowed, cap);
    // In the loop for which it is stated, the wall has this stiffness, and not more.
    QCOMPARE(stiffnessLimit({kPeriod, 0.001, device.inherentDamping}, 0.0), stated);
  }

  // The loop itself reaches that cap as soon as it has measured ticks in time; until then it is lower.
  void theLoopComesToTheCap_data() { onlyOurOwnDelaySoftens_data(); }
  void theLoopComesToTheCap() {
    QFETCH(DeviceCapabilities, device);
    QFETCH(double, guard);
    QFETCH(double, cap);
    device.latency += guard;
    const SafetySettings settings = safetySettingsFor(device, device.nominalRate);
    ServoStatistics measure(device, settings.inherentDamping, settings.nominalPeriod);
    QVERIFY(measure.stiffnessLimit() < cap);
    for (int i = 0; i < 20000; ++i) {
      measure.addPeriod(kPeriod);
      measure.addDelay(0.0);
    }
    QVERIFY(std::abs(measure.stiffnessLimit() - cap) < 1e-3 * cap);
  }
};

HANDWHEEL_TEST(StiffnessCapTest)
#include "StiffnessCapTest.moc"
