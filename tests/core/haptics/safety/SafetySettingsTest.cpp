// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/safety/SafetySettings.h"

#include <QtTest>
#include <cmath>

#include "HapticDevices.h"
#include "TestClass.h"

using namespace handwheel;

class SafetySettingsTest : public QObject {
  Q_OBJECT

 private slots:
  void followTheDataSheet() {
    DeviceCapabilities device = test::forceDevice();
    device.maxTorque = 150.0;
    device.maxGripperForce = 2.0;
    const SafetySettings settings = safetySettingsFor(device, 2000.0);
    QCOMPARE(settings.nominalPeriod, 0.0005);
    QCOMPARE(settings.maxForce, 8.0);
    QCOMPARE(settings.maxTorque, 150.0);
    QCOMPARE(settings.maxGripperForce, 2.0);
    QCOMPARE(settings.inherentDamping, 0.005);
    QCOMPARE(settings.controlDamping, 0.02);
    QCOMPARE(settings.speedDamping, 0.005);  // for a velocity that is estimated late
    // 8 N at most along the 200 mm across the workspace.
    QCOMPARE(settings.energyLimit, 1600.0);
  }

  // A soft device reaches its whole force within 4 ms.
  void slewsInTheSameTime() {
    for (const double force : {0.1, 3.3, 8.0, 40.0}) {
      DeviceCapabilities device = test::forceDevice();
      device.maxForce = force;
      device.maxStiffness = 0.02;
      QVERIFY(qAbs(force / safetySettingsFor(device, 1000.0).slewRate - 0.004) < 1e-12);
    }
  }

  // A stiff one slews as fast as a hand of 1 m/s meets its stiffest wall: that of its manufacturer, or of eq. 2-1.
  void slewsAsFastAsAHandMeetsAWall() {
    DeviceCapabilities device = test::forceDevice();
    device.maxStiffness = 7.0;
    QVERIFY(qAbs(safetySettingsFor(device, 1000.0).slewRate - 7000.0) < 1e-9);
    device.maxStiffness = 1000.0;
    QVERIFY(qAbs(safetySettingsFor(device, 1000.0).slewRate - 10000.0) < 1e-9);
    device.latency = 0.0005;
    QVERIFY(qAbs(safetySettingsFor(device, 1000.0).slewRate - 5000.0) < 1e-9);
  }

  // 3 N/mm at 1 kHz need 1.5 N·s/m, eq. 2-1; at any rate of the loop.
  void frictionThatIsNotStatedFollowsFromTheStiffness() {
    DeviceCapabilities device = test::forceDevice();
    device.inherentDamping = 0.0;
    device.maxStiffness = 3.0;
    QCOMPARE(safetySettingsFor(device, 1000.0).inherentDamping, 0.0015);
    QCOMPARE(safetySettingsFor(device, 4000.0).inherentDamping, 0.0015);
  }

  // Damping that arrives a period late or more is limited to the friction that compensates for it.
  void lateDampingIsBounded() {
    DeviceCapabilities device = test::forceDevice();
    device.latency = 0.002;
    const SafetySettings settings = safetySettingsFor(device, 1000.0);
    QCOMPARE(settings.controlDamping, 0.005);
    QCOMPARE(settings.speedDamping, 0.005);
    QCOMPARE(settings.latency, 0.002);
  }

  void whatOnlyPointsMayBeFast() {
    DeviceCapabilities mouse;
    mouse.outputs = 0;
    QVERIFY(std::isinf(safetySettingsFor(mouse, 1000.0).cutSpeed));
    QVERIFY(std::isfinite(safetySettingsFor(test::forceDevice(), 1000.0).cutSpeed));
  }

  void actionsAreASet() {
    SafetyActions actions;
    QVERIFY(actions.isEmpty());
    actions.add(SafetyAction::Slew);
    actions.add(SafetyAction::Clamp);
    QVERIFY(actions.has(SafetyAction::Slew) && actions.has(SafetyAction::Clamp));
    QVERIFY(!actions.has(SafetyAction::Ramp));
    QVERIFY(!actions.isEmpty());
  }
};

HANDWHEEL_TEST(SafetySettingsTest)
#include "SafetySettingsTest.moc"
