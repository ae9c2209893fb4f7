// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/scene/TouchFidelity.h"

#include <QTest>

using namespace handwheel;

class TouchFidelityTest : public QObject {
  Q_OBJECT

 private slots:
  void isReadByTheLoopAndTheScene();
  void aDeviceKeepsItsRateUnlessOneIsChosen();
  void defaultsAreWhatHoldsWithoutASetting();
};

void TouchFidelityTest::isReadByTheLoopAndTheScene() {
  FidelityValues values;
  QVERIFY(values.set(proxyToleranceSetting(), 1e-5));
  QVERIFY(values.set(servoRateSetting(), 2000.0));
  QVERIFY(values.set(contactStiffnessSetting(), 1.25));
  QVERIFY(values.set(velocityWindowSetting(), 0.004));
  QCOMPARE(contactOptions(values).tolerance, 1e-5);
  QCOMPARE(servoSettings(values).rate, 2000.0);
  QCOMPARE(servoSettings(values).velocityWindow, 0.004);
  const std::vector<Vec3> points{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
  const std::vector<Triangle> triangles{{0, 1, 2}};
  const TouchedSurface feel = touchedSurface(ContactSurface(points, triangles), values);
  QCOMPARE(feel.stiffness, 1.25);
  QCOMPARE(feel.contact.tolerance, 1e-5);
  QCOMPARE(feel.surface.diagonal(), 5.0);
}

// 0 is the device's nominal rate: the default must not drive a device of 4 kHz at 1 kHz.
void TouchFidelityTest::aDeviceKeepsItsRateUnlessOneIsChosen() {
  FidelityValues values;
  QCOMPARE(servoSettings(values).rate, 0.0);
  QVERIFY(values.set(contactStiffnessSetting(), 1.0));
  QCOMPARE(servoSettings(values).rate, 0.0);
  for (FidelityPreset preset : kFidelityPresets) {
    QCOMPARE(servoSettings(FidelityValues(preset)).rate, servoRateSetting().presetValue(preset));
  }
  // The value is chosen, although it is the default's number.
  QVERIFY(values.set(servoRateSetting(), servoRateSetting().standard));
  QCOMPARE(servoSettings(values).rate, servoRateSetting().standard);
}

void TouchFidelityTest::defaultsAreWhatHoldsWithoutASetting() {
  const FidelityValues none;
  QCOMPARE(contactOptions(none).tolerance, ContactOptions().tolerance);
  QCOMPARE(servoSettings(none).velocityWindow, ServoSettings().velocityWindow);
  QCOMPARE(touchedSurface(ContactSurface(), none).stiffness, TouchedSurface().stiffness);
  // The loop accepts every rate that can be chosen, and the scene only settings of its range.
  QVERIFY(servoRateSetting().least >= kLeastServoRate && servoRateSetting().largest <= kLargestServoRate);
  for (const FidelitySetting& s :
       {proxyToleranceSetting(), servoRateSetting(), contactStiffnessSetting(), velocityWindowSetting()}) {
    QVERIFY2(checkValue(s, s.standard), s.id.c_str());
    for (double preset : s.presets) QVERIFY2(checkValue(s, preset), s.id.c_str());
    FidelityValues values;
    for (double wrong : {0.0, -1.0, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
      QVERIFY2(!values.set(s, wrong), s.id.c_str());
    }
    QCOMPARE(values, none);
  }
}

HANDWHEEL_TEST(TouchFidelityTest)
#include "TouchFidelityTest.moc"
