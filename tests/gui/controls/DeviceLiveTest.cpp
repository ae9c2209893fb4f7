// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ControlsTestMain.h"
#include "DevicePanelFixture.h"
#include "panels/device/AxisBars.h"
#include "panels/device/ForcePlot.h"

#include <QCheckBox>
#include <QPushButton>
#include <QSignalSpy>

using namespace handwheel;
using namespace handwheel::test;

// The live display of a device panel: axes, forces, and safety.
class DeviceLiveTest : public QObject {
  Q_OBJECT

 private slots:
  void forceIsAskedFor();
  void withoutMotors();
  void torque();
  void samples();
  void plotHoldsStillWhileItIsRead();
  void aHandAtRestPaintsNothing();
  void hiddenPanelLetsSamplesPass();
  void safetyInWords();
  void softeningInWords();
};

namespace {

struct PaintCount : QObject {
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++paints;
    return QObject::eventFilter(watched, event);
  }
  int paints = 0;
};

}  // namespace

void DeviceLiveTest::forceIsAskedFor() {
  DevicePanelFixture fixture;
  QSignalSpy force(&fixture.panel, &DevicePanel::forceOnChanged),
      test(&fixture.panel, &DevicePanel::forceTestRequested);
  auto* on = fixture.part<QCheckBox>("forceOn");
  auto* button = fixture.part<QPushButton>("forceTest");
  QVERIFY(!on->isEnabled());
  fixture.panel.showDevice(falconView());
  QVERIFY(on->isChecked());
  QCOMPARE(force.size(), 0);
  button->click();
  QCOMPARE(test.size(), 1);
  on->click();
  QCOMPARE(force.size(), 1);
  QCOMPARE(force[0][0].toBool(), false);
  DeviceInUse off = falconView();
  off.isForceOn = false;
  fixture.panel.showDevice(off);
  button->click();  // there is nothing to test
  QCOMPARE(test.size(), 1);
}

void DeviceLiveTest::withoutMotors() {
  DevicePanelFixture fixture;
  fixture.panel.showDevice(spaceMouseView());
  QVERIFY(!fixture.part<QCheckBox>("forceOn")->isVisible());
  QVERIFY(!fixture.part<QPushButton>("forceTest")->isVisible());
  QVERIFY(fixture.part<QLabel>("noForce")->isVisible());
  QCOMPARE(fixture.part<AxisBars>("axisBars")->axes(), std::size_t(6));
}

// The torque sent, for devices that have motors for it; the others have no such line.
void DeviceLiveTest::torque() {
  DevicePanelFixture fixture;
  fixture.panel.showDevice(falconView());
  QVERIFY(!fixture.part<QLabel>("deviceTorque")->isVisible());
  DeviceInUse view = falconView();
  view.capabilities.outputs = 6;
  view.capabilities.maxTorque = 200.0;
  fixture.panel.showDevice(view);
  QVERIFY(fixture.part<QLabel>("deviceTorque")->isVisible());
  QCOMPARE(fixture.text("deviceTorque"), QString("Torque: 0 of 200 N·mm"));
  ServoSample sample = sampleAt(1.0, {0, 0, 0}, {0, 0, 0});
  sample.felt.torque = {0, 0, 1000};
  sample.sent.torque = {0, 30, 40};
  fixture.panel.showSample(sample);
  QCOMPARE(fixture.text("deviceTorque"), QString("Torque: 50 of 200 N·mm"));
}

// The force is a magnitude, the scene's with the gain of the mapping, against the time before now.
void DeviceLiveTest::samples() {
  DevicePanelFixture fixture;
  fixture.panel.showDevice(falconView());
  WorkspaceMapping mapping;
  mapping.forceGain = 0.5;
  fixture.panel.setMapping(mapping);
  fixture.panel.showSample(sampleAt(1.0, {6, 8, 0}, {0, 3, 4}));
  fixture.panel.showSample(sampleAt(3.0, {0, 0, 0}, {0, 0, 0}));
  const Plot& plot = fixture.part<ForcePlot>("forcePlot")->plot();
  QCOMPARE(plot.series.size(), std::size_t(2));
  const auto& asked = plot.series[0].points;
  const auto& sent = plot.series[1].points;
  QCOMPARE(asked.size(), std::size_t(2));
  QCOMPARE(asked[0], QPointF(-2.0, 5.0));
  QCOMPARE(sent[0], QPointF(-2.0, 5.0));
  QCOMPARE(sent[1], QPointF(0.0, 0.0));
  DeviceInUse other = spaceMouseView();
  fixture.panel.showDevice(other);  // the state of the first is not that of the other
  QCOMPARE(fixture.part<ForcePlot>("forcePlot")->trace().size(), std::size_t(0));
}

void DeviceLiveTest::plotHoldsStillWhileItIsRead() {
  DevicePanelFixture fixture;
  fixture.panel.showDevice(falconView());
  fixture.panel.showSample(sampleAt(1.0, {2, 0, 0}, {1, 0, 0}));
  auto* plot = fixture.part<ForcePlot>("forcePlot");
  QTest::keyClick(plot, Qt::Key_Right);
  QCOMPARE(plot->reading(), QString("asked for: 0 s, 2 N"));
  fixture.panel.showSample(sampleAt(2.0, {3, 0, 0}, {1, 0, 0}));
  QCOMPARE(plot->reading(), QString("asked for: 0 s, 2 N"));
  QCOMPARE(plot->trace().size(), std::size_t(2));
  QTest::keyClick(plot, Qt::Key_Escape);
  fixture.panel.showSample(sampleAt(3.0, {3, 0, 0}, {1, 0, 0}));
  QCOMPARE(plot->plot().series[0].points.size(), std::size_t(3));
}

// Each picture of a part is one of the whole window where the graphics are software.
void DeviceLiveTest::aHandAtRestPaintsNothing() {
  DevicePanelFixture fixture;
  fixture.panel.showDevice(falconView());
  const auto rest = [&fixture](double from, double to) {
    for (double time = from; time < to; time += 0.016) fixture.panel.showSample(sampleAt(time, {1, 0, 0}, {1, 0, 0}));
    QTest::qWait(100);  // for pictures that were asked for
  };
  rest(1.0, 12.0);
  PaintCount count;
  qApp->installEventFilter(&count);
  rest(12.0, 14.0);
  QCOMPARE(count.paints, 0);
  fixture.panel.showSample(sampleAt(14.0, {2, 0, 0}, {1, 0, 0}));
  QTRY_VERIFY(count.paints > 0);
}

void DeviceLiveTest::hiddenPanelLetsSamplesPass() {
  DevicePanel panel;
  panel.showDevice(falconView());
  playTouches(panel);
  QCOMPARE(panel.findChild<ForcePlot*>("forcePlot")->trace().size(), std::size_t(0));
  QCOMPARE(panel.findChild<AxisBars*>("axisBars")->text(0), QString("X 0.0 mm"));
  panel.show();
  playTouches(panel);
  QVERIFY(panel.findChild<ForcePlot*>("forcePlot")->trace().size() > 300);
  panel.hide();  // later values are not joined to it
  QCOMPARE(panel.findChild<ForcePlot*>("forcePlot")->trace().size(), std::size_t(0));
}

void DeviceLiveTest::safetyInWords() {
  DevicePanelFixture fixture;
  fixture.panel.showDevice(falconView());
  ServoSample sample = sampleAt(1.0, Vec3::Zero(), Vec3::Zero());
  sample.actions.add(SafetyAction::Passivity);
  sample.actions.add(SafetyAction::Slew);
  fixture.panel.showSample(sample);
  const QString words = fixture.text("safetyText");
  QVERIFY(words.indexOf("more energy") >= 0 && words.indexOf("more energy") < words.indexOf("rate of change"));
  fixture.panel.showSample(sampleAt(1.1, Vec3::Zero(), Vec3::Zero()));
  QCOMPARE(fixture.text("safetyText"), words);  // long enough to be read
  fixture.panel.showSample(sampleAt(9.0, Vec3::Zero(), Vec3::Zero()));
  QCOMPARE(fixture.text("safetyText"), QString("Safety: the force is not limited."));
}

// A surface of 0.5 N/mm at the hand is 0.25 in a scene of twice the size, of which the loop can carry 0.2.
void DeviceLiveTest::softeningInWords() {
  DevicePanelFixture fixture;
  DeviceInUse view = falconView();
  view.capabilities.latency = 0.0022;
  fixture.panel.showDevice(view);
  fixture.panel.showLoop({1003.0, 0, RealTimeState::RealTime});
  ServoSample sample = sampleAt(1.0, {1, 0, 0}, {1, 0, 0});
  sample.felt.stiffness = 0.2;
  sample.felt.asked = 0.25;
  sample.felt.isSoftened = true;
  fixture.panel.showSample(sample, 2.0);
  const QString words("Softer than set: 0.40 of 0.50 N/mm; limit of the Novint Falcon at 1 kHz and 2.2 ms of delay");
  QCOMPARE(fixture.text("safetyText"), words);
  fixture.panel.showSample(sampleAt(1.5, {0, 0, 0}, {0, 0, 0}), 2.0);
  QCOMPARE(fixture.text("safetyText"), words);  // long enough to be read
  fixture.panel.showSample(sampleAt(9.0, {0, 0, 0}, {0, 0, 0}), 2.0);
  QCOMPARE(fixture.text("safetyText"), QString("Safety: the force is not limited."));
  sample.felt.stiffness = 1.5;
  sample.felt.asked = 5.0;
  sample.tip.time = 10.0;
  fixture.panel.showSample(sample, 2.0);
  QCOMPARE(fixture.text("safetyText"),
           QString("Softer than set: 3.00 of 10.00 N/mm; limit specified for the Novint Falcon"));
  fixture.panel.hide();
  fixture.panel.show();
  QVERIFY(!fixture.text("safetyText").contains("Softer"));
}

HANDWHEEL_CONTROLS_TEST(DeviceLiveTest)
#include "DeviceLiveTest.moc"
