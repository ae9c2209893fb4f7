// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Accessibility.h"
#include "ControlsTestMain.h"
#include "DeviceScenes.h"
#include "panels/AxisBars.h"
#include "panels/ForcePlot.h"

#include <QCheckBox>
#include <QClipboard>
#include <QDir>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTest>
#include <QToolButton>

using namespace handwheel;
using namespace handwheel::test;

// The panel of a device: what it shows of the values given, and what it asks for.
class DevicePanelTest : public QObject {
  Q_OBJECT

 private:
  void look(DevicePanel& panel, const QString& name);

 private slots:
  void cleanup() { applyTheme(*qApp, ThemeKind::Light); }
  void choosing();
  void unpluggedDeviceStaysInTheList();
  void whatToDo_data();
  void whatToDo();
  void mouseInThePlaceOfADevice();
  void forceIsAskedFor();
  void withoutMotors();
  void samples();
  void plotHoldsStillWhileItIsRead();
  void hiddenPanelLetsSamplesPass();
  void safetyInWords();
  void notRealTime();
  void mappingIsEdited();
  void timings();
  void pictures_data();
  void pictures();
  void picturesOfTrouble();
};

namespace {

struct Bench {
  Bench() {
    panel.resize(300, 680);
    panel.show();
    panel.activateWindow();
    if (!QTest::qWaitForWindowActive(&panel)) qFatal("the panel does not appear");
  }
  template <class Widget>
  Widget* part(const char* name) {
    return panel.findChild<Widget*>(name);
  }
  QString text(const char* label) { return part<QLabel>(label)->text(); }
  void turnTo(int page) { part<QTabWidget>("devicePages")->setCurrentIndex(page); }

  DevicePanel panel;
};

}  // namespace

void DevicePanelTest::choosing() {
  Bench bench;
  QSignalSpy chosen(&bench.panel, &DevicePanel::deviceChosen), left(&bench.panel, &DevicePanel::deviceLeft);
  QSignalSpy rescan(&bench.panel, &DevicePanel::rescanAsked);
  auto* list = bench.part<QComboBox>("deviceChoice");
  QCOMPARE(list->count(), 1);
  QCOMPARE(bench.text("deviceHeadline"), QString("No device in use"));
  DeviceInUse view;
  view.found = {falcon(), spaceMouse()};
  bench.panel.showDevice(view);
  QCOMPARE(list->count(), 3);
  QCOMPARE(chosen.size(), 0);  // showing is not choosing
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Down);
  QTest::keyClick(list, Qt::Key_Down);
  QTest::keyClick(list, Qt::Key_Up);
  QTest::keyClick(list, Qt::Key_Up);
  QCOMPARE(left.size(), 1);
  QCOMPARE(chosen.size(), 3);
  QCOMPARE(chosen[1][0].value<std::string>(), std::string("spacemouse"));
  QCOMPARE(chosen[1][1].value<std::string>(), std::string("/dev/hidraw3"));
  bench.part<QToolButton>("rescanDevices")->click();
  QCOMPARE(rescan.size(), 1);
  bench.panel.showDevice(falconView());
  QCOMPARE(list->currentText(), QString("Novint Falcon"));
  QCOMPARE(bench.text("deviceHeadline"), QString("Ready"));
}

void DevicePanelTest::unpluggedDeviceStaysInTheList() {
  Bench bench;
  DeviceInUse view = falconView();
  view.found = {spaceMouse()};
  view.status = DeviceStatus::Absent;
  bench.panel.showDevice(view);
  auto* list = bench.part<QComboBox>("deviceChoice");
  QCOMPARE(list->currentText(), QString("Novint Falcon (unplugged)"));
  QCOMPARE(list->count(), 3);
  bench.panel.showDevice(falconView());  // back again
  QCOMPARE(list->currentText(), QString("Novint Falcon"));
  QCOMPARE(list->count(), 3);
}

void DevicePanelTest::whatToDo_data() {
  QTest::addColumn<int>("status");
  QTest::addColumn<QString>("words");
  QTest::newRow("absent") << int(DeviceStatus::Absent) << "Plug it in";
  QTest::newRow("starting") << int(DeviceStatus::Starting) << "firmware";
  QTest::newRow("homing") << int(DeviceStatus::NeedsHoming) << "push it all the way in";
  QTest::newRow("failed") << int(DeviceStatus::Failed) << "Unplug it";
}

// The state comes with the samples, too.
void DevicePanelTest::whatToDo() {
  QFETCH(int, status);
  QFETCH(QString, words);
  Bench bench;
  bench.panel.showDevice(falconView());
  QVERIFY(!bench.part<QLabel>("deviceDetail")->isVisible());
  ServoSample sample;
  sample.device.status = static_cast<DeviceStatus>(status);
  bench.panel.showSample(sample);
  QVERIFY(bench.part<QLabel>("deviceDetail")->isVisible());
  QVERIFY2(bench.text("deviceDetail").contains(words), qPrintable(bench.text("deviceDetail")));
  QVERIFY(bench.part<QWidget>("deviceState")->accessibleName().contains(bench.text("deviceHeadline")));
  QVERIFY(!bench.part<QPushButton>("forceTest")->isEnabled());
}

void DevicePanelTest::mouseInThePlaceOfADevice() {
  Bench bench;
  DeviceInUse view = spaceMouseView();
  view.isPointer = true;
  view.status = DeviceStatus::Absent;
  bench.panel.showDevice(view);
  QCOMPARE(bench.text("deviceHeadline"), QString("The pointer is outside the view"));
  QCOMPARE(bench.part<QComboBox>("deviceChoice")->currentText(), QString("SpaceMouse Compact"));
}

void DevicePanelTest::forceIsAskedFor() {
  Bench bench;
  QSignalSpy force(&bench.panel, &DevicePanel::forceOnChanged), test(&bench.panel, &DevicePanel::forceTestAsked);
  auto* on = bench.part<QCheckBox>("forceOn");
  auto* button = bench.part<QPushButton>("forceTest");
  QVERIFY(!on->isEnabled());
  bench.panel.showDevice(falconView());
  QVERIFY(on->isChecked());
  QCOMPARE(force.size(), 0);
  button->click();
  QCOMPARE(test.size(), 1);
  on->click();
  QCOMPARE(force.size(), 1);
  QCOMPARE(force[0][0].toBool(), false);
  DeviceInUse off = falconView();
  off.isForceOn = false;
  bench.panel.showDevice(off);
  button->click();  // there is none to be tested
  QCOMPARE(test.size(), 1);
}

void DevicePanelTest::withoutMotors() {
  Bench bench;
  bench.panel.showDevice(spaceMouseView());
  QVERIFY(!bench.part<QCheckBox>("forceOn")->isVisible());
  QVERIFY(!bench.part<QPushButton>("forceTest")->isVisible());
  QVERIFY(bench.part<QLabel>("noForce")->isVisible());
  QCOMPARE(bench.part<AxisBars>("axisBars")->axes(), std::size_t(6));
}

// Force as a length, the scene's with the gain of the mapping, against the time before now.
void DevicePanelTest::samples() {
  Bench bench;
  bench.panel.showDevice(falconView());
  WorkspaceMapping mapping;
  mapping.forceGain = 0.5;
  bench.panel.setMapping(mapping);
  bench.panel.showSample(sampleAt(1.0, {6, 8, 0}, {0, 3, 4}));
  bench.panel.showSample(sampleAt(3.0, {0, 0, 0}, {0, 0, 0}));
  const Plot& plot = bench.part<ForcePlot>("forcePlot")->plot();
  QCOMPARE(plot.series.size(), std::size_t(2));
  const auto& asked = plot.series[0].points;
  const auto& sent = plot.series[1].points;
  QCOMPARE(asked.size(), std::size_t(2));
  QCOMPARE(asked[0], QPointF(-2.0, 5.0));
  QCOMPARE(sent[0], QPointF(-2.0, 5.0));
  QCOMPARE(sent[1], QPointF(0.0, 0.0));
  DeviceInUse other = spaceMouseView();
  bench.panel.showDevice(other);  // what the first did is not the other's
  QCOMPARE(bench.part<ForcePlot>("forcePlot")->trace().size(), std::size_t(0));
}

void DevicePanelTest::plotHoldsStillWhileItIsRead() {
  Bench bench;
  bench.panel.showDevice(falconView());
  bench.panel.showSample(sampleAt(1.0, {2, 0, 0}, {1, 0, 0}));
  auto* plot = bench.part<ForcePlot>("forcePlot");
  QTest::keyClick(plot, Qt::Key_Right);
  QCOMPARE(plot->reading(), QString("asked for: 0 s, 2 N"));
  bench.panel.showSample(sampleAt(2.0, {3, 0, 0}, {1, 0, 0}));
  QCOMPARE(plot->reading(), QString("asked for: 0 s, 2 N"));
  QCOMPARE(plot->trace().size(), std::size_t(2));
  QTest::keyClick(plot, Qt::Key_Escape);
  bench.panel.showSample(sampleAt(3.0, {3, 0, 0}, {1, 0, 0}));
  QCOMPARE(plot->plot().series[0].points.size(), std::size_t(3));
}

void DevicePanelTest::hiddenPanelLetsSamplesPass() {
  DevicePanel panel;
  panel.showDevice(falconView());
  playTouches(panel);
  QCOMPARE(panel.findChild<ForcePlot*>("forcePlot")->trace().size(), std::size_t(0));
  QCOMPARE(panel.findChild<AxisBars*>("axisBars")->text(0), QString("X 0.0 mm"));
  panel.show();
  playTouches(panel);
  QVERIFY(panel.findChild<ForcePlot*>("forcePlot")->trace().size() > 300);
  panel.hide();  // what comes later is not joined to it
  QCOMPARE(panel.findChild<ForcePlot*>("forcePlot")->trace().size(), std::size_t(0));
}

void DevicePanelTest::safetyInWords() {
  Bench bench;
  bench.panel.showDevice(falconView());
  ServoSample sample = sampleAt(1.0, Vec3::Zero(), Vec3::Zero());
  sample.actions.add(SafetyAction::Passivity);
  sample.actions.add(SafetyAction::Slew);
  bench.panel.showSample(sample);
  const QString words = bench.text("safetyText");
  QVERIFY(words.indexOf("more energy") >= 0 && words.indexOf("more energy") < words.indexOf("no faster"));
  bench.panel.showSample(sampleAt(1.1, Vec3::Zero(), Vec3::Zero()));
  QCOMPARE(bench.text("safetyText"), words);  // long enough to be read
  bench.panel.showSample(sampleAt(9.0, Vec3::Zero(), Vec3::Zero()));
  QCOMPARE(bench.text("safetyText"), QString("Safety: nothing is held back."));
}

void DevicePanelTest::notRealTime() {
  Bench bench;
  bench.panel.showDevice(falconView());
  bench.panel.showLoop({998.4, 7, RealTimeState::RealTime});
  auto* warning = bench.part<QToolButton>("notRealTime");
  QVERIFY(!warning->isVisible());
  QCOMPARE(bench.text("servoRate"), QString("998 ticks a second, 7 missed so far"));
  bench.panel.showLoop({998.4, 7, RealTimeState::NotPermitted});
  QVERIFY(warning->isVisible());
  warning->click();
  QVERIFY(bench.part<QLabel>("realTimeAdvice")->isVisible());
  bench.part<QPushButton>("copyCommand")->click();
  QVERIFY(QGuiApplication::clipboard()->text().contains(" - rtprio "));
}

void DevicePanelTest::mappingIsEdited() {
  Bench bench;
  bench.panel.showDevice(falconView());
  WorkspaceMapping mapping;
  mapping.scale = 3.0;
  mapping.sceneFromView.translation() = Vec3(1, 2, 3);
  bench.panel.setMapping(mapping);
  bench.turnTo(1);
  QVERIFY(bench.part<QWidget>("property/up")->isEnabled());
  std::vector<WorkspaceMapping> changed;
  connect(&bench.panel, &DevicePanel::mappingChanged, this, [&](const WorkspaceMapping& m) { changed.push_back(m); });
  auto* up = bench.part<QWidget>("property/up")->findChild<QComboBox*>("propertyChoice");
  up->setFocus();
  QTest::keyClick(up, Qt::Key_Down);
  QCOMPARE(changed.size(), std::size_t(1));
  QVERIFY(changed[0].axes[1].isInverted);
  QCOMPARE(changed[0].axes[1].axis, 1);
  QCOMPARE(changed[0].scale, 3.0);
  QCOMPARE(Vec3(changed[0].sceneFromView.translation()), Vec3(1, 2, 3));
  bench.panel.showDevice({});
  QVERIFY(!bench.part<QWidget>("property/up")->isEnabled());
}

void DevicePanelTest::timings() {
  Bench bench;
  const DeviceInUse view = falconView();
  bench.panel.showDevice(view);
  LoopMeasure measure(view.capabilities, 0.002, 1e-3);
  fill(measure);
  auto* plot = bench.part<PlotWidget>("timingPlot");
  bench.panel.showTiming(measure);  // nobody sees it
  QVERIFY(plot->plot().series[0].points.empty());
  bench.turnTo(2);
  bench.panel.showTiming(measure);
  QVERIFY(!plot->plot().series[0].points.empty());
  bench.part<QComboBox>("timingKind")->setCurrentIndex(2);
  // Of 8 to 16 us in bins of 5, each upper end: half are not above 12, all below 17.
  QCOMPARE(bench.text("timingSummary"), QString("Half within 15 µs, 99 % within 20 µs, all within 20 µs"));
}

void DevicePanelTest::pictures_data() {
  QTest::addColumn<int>("page");
  QTest::addColumn<QSize>("size");
  const char* const names[] = {"live", "mapping", "timing", "data"};
  for (int page = 0; page < 4; ++page) QTest::newRow(names[page]) << page << QSize(300, 680);
  QTest::newRow("live-low") << 0 << QSize(296, 300);  // what is left of 1280 x 800 at 200 %
}

void DevicePanelTest::picturesOfTrouble() {
  Bench bench;
  bench.panel.showDevice(falconView());
  bench.panel.showLoop({998.4, 7, RealTimeState::NotPermitted});
  playTouches(bench.panel);
  ServoSample sample = sampleAt(10.0, Vec3::Zero(), Vec3::Zero());
  sample.device.status = DeviceStatus::NeedsHoming;
  for (const SafetyAction action : {SafetyAction::DeviceFault, SafetyAction::NotFinite, SafetyAction::Ramp}) {
    sample.actions.add(action);
  }
  bench.panel.showSample(sample);
  look(bench.panel, "falcon-homing");
  bench.panel.showDevice({});
  look(bench.panel, "none");
}

void DevicePanelTest::pictures() {
  QFETCH(int, page);
  QFETCH(QSize, size);
  for (const DeviceInUse& view : {falconView(), spaceMouseView()}) {
    Bench bench;
    bench.panel.resize(size);
    bench.turnTo(page);
    bench.panel.showDevice(view);
    bench.panel.showLoop({998.4, 7, page == 1 ? RealTimeState::RealTime : RealTimeState::NotPermitted});
    playTouches(bench.panel);
    LoopMeasure measure(view.capabilities, 0.002, 1e-3);
    fill(measure);
    bench.panel.showTiming(measure);
    look(bench.panel,
         QStringLiteral("%1-%2").arg(QString::fromStdString(view.chosen->driver), QTest::currentDataTag()));
  }
}

// In both themes nothing is cut, everything has a name and is reached by Tab. With HANDWHEEL_PICTURES, a folder, the
// pictures are kept there to be looked at.
void DevicePanelTest::look(DevicePanel& panel, const QString& name) {
  const QString folder = qEnvironmentVariable("HANDWHEEL_PICTURES");
  for (const ThemeKind theme : {ThemeKind::Light, ThemeKind::Dark}) {
    applyTheme(*qApp, theme);
    QTest::qWait(20);
    const QString file = QStringLiteral("device-%1-%2-%3.png")
                             .arg(name, theme == ThemeKind::Dark ? "dark" : "light")
                             .arg(panel.devicePixelRatioF());
    if (!folder.isEmpty()) QVERIFY(panel.grab().save(QDir(folder).filePath(file)));
    QCOMPARE(cutTexts(panel).join("\n"), QString());
  }
  QCOMPARE(withoutAccessibleName(panel).join("\n"), QString());
  QCOMPARE(notReachedByTab(panel).join("\n"), QString());
}

HANDWHEEL_CONTROLS_TEST(DevicePanelTest)
#include "DevicePanelTest.moc"
