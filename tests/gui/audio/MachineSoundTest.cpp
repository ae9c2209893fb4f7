// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "audio/MachineSound.h"

#include "TestClass.h"

#include <QSignalSpy>
#include <QTest>
#include <limits>

using namespace handwheel;

// A test machine usually has no sound device; then the test is that it stays silent, and nothing waits or fails. A
// device, if any, plays at no volume.
class MachineSoundTest : public QObject {
  Q_OBJECT

 private slots:
  void isOffUntilItIsSwitchedOn();
  void staysUsableWithoutADevice();
  void endsWhileItOpensADevice();
};

void MachineSoundTest::isOffUntilItIsSwitchedOn() {
  MachineSound sound;
  QVERIFY(!sound.isOn());
  sound.setState({.spindleSpeed = 1000.0});
  sound.setVolume(0.0);
  sound.setOn(false);
  QVERIFY(!sound.isOn());
  QSignalSpy devices(&sound, &MachineSound::deviceChanged);
  sound.setOn(true);  // opens nothing before a machine runs
  QTest::qWait(50);
  QCOMPARE(devices.size(), 0);
}

void MachineSoundTest::staysUsableWithoutADevice() {
  MachineSound sound;
  QSignalSpy devices(&sound, &MachineSound::deviceChanged);
  sound.setVolume(std::numeric_limits<double>::quiet_NaN());  // ignored
  sound.setOn(true);
  QVERIFY(sound.isOn());
  for (int i = 0; i < 20; ++i) {
    sound.setState({.spindleSpeed = 100.0 * i, .force = 50.0 * i, .cuttingSpeed = 100.0});
    QTest::qWait(10);
  }
  sound.setOn(false);
  sound.setOn(true);
  sound.setState({});
  sound.setOn(false);
  QVERIFY(!sound.isOn());
  QTRY_VERIFY(devices.isEmpty() || devices.last()[0].toString().isEmpty());
}

void MachineSoundTest::endsWhileItOpensADevice() {
  for (int i = 0; i < 5; ++i) {
    MachineSound sound;
    sound.setVolume(0.0);
    sound.setOn(true);
    sound.setState({.spindleSpeed = 1000.0});
  }
}

HANDWHEEL_TEST(MachineSoundTest)
#include "MachineSoundTest.moc"
