// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Accessibility.h"
#include "ControlsTestMain.h"
#include "DevicePanelFixture.h"
#include "plot/PlotWidget.h"

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

// The panel of a device: the displayed values, and its requests.
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
  void mouseAsDevice();
  void notRealTime();
  void mappingIsEdited();
  void timings();
  void pictures_data();
  void pictures();
  void picturesOfTrouble();
};

void DevicePanelTest::choosing() {
  DevicePanelFixture fixture;
  QSignalSpy chosen(&fixture.panel, &DevicePanel::deviceChosen), left(&fixture.panel, &DevicePanel::deviceLeft);
  QSignalSpy rescan(&fixture.panel, &DevicePanel::rescanRequested);
  auto* list = fixture.part<QComboBox>("deviceChoice");
  QCOMPARE(list->count(), 1);
  QCOMPARE(fixture.text("deviceHeadline"), QString("No device in use"));
  DeviceInUse view;
  view.found = {falcon(), spaceMouse()};
  fixture.panel.showDevice(view);
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
  fixture.part<QToolButton>("rescanDevices")->click();
  QCOMPARE(rescan.size(), 1);
  fixture.panel.showDevice(falconView());
  QCOMPARE(list->currentText(), QString("Novint Falcon"));
  QCOMPARE(fixture.text("deviceHeadline"), QString("Ready"));
}

void DevicePanelTest::unpluggedDeviceStaysInTheList() {
  DevicePanelFixture fixture;
  DeviceInUse view = falconView();
  view.found = {spaceMouse()};
  view.status = DeviceStatus::Absent;
  fixture.panel.showDevice(view);
  auto* list = fixture.part<QComboBox>("deviceChoice");
  QCOMPARE(list->currentText(), QString("Novint Falcon (unplugged)"));
  QCOMPARE(list->count(), 3);
  fixture.panel.showDevice(falconView());  // back again
  QCOMPARE(list->currentText(), QString("Novint Falcon"));
  QCOMPARE(list->count(), 3);
}

void DevicePanelTest::whatToDo_data() {
  QTest::addColumn<QString>("driver");
  QTest::addColumn<int>("status");
  QTest::addColumn<QString>("words");
  QTest::newRow("absent") << "falcon" << int(DeviceStatus::Absent) << "Plug it in";
  QTest::newRow("starting") << "falcon" << int(DeviceStatus::Starting) << "firmware";
  QTest::newRow("homing of a Falcon") << "falcon" << int(DeviceStatus::NeedsHoming) << "push it all the way in";
  QTest::newRow("homing of OpenHaptics") << "openhaptics" << int(DeviceStatus::NeedsHoming) << "into its inkwell";
  QTest::newRow("homing of an Inverse3") << "haply" << int(DeviceStatus::NeedsHoming) << "as described in its manual";
  QTest::newRow("homing of a Polhem") << "polhem" << int(DeviceStatus::NeedsHoming) << "as described in its manual";
  QTest::newRow("failed") << "falcon" << int(DeviceStatus::Failed) << "Unplug it";
}

// The status comes with the samples, too.
void DevicePanelTest::whatToDo() {
  QFETCH(QString, driver);
  QFETCH(int, status);
  QFETCH(QString, words);
  DevicePanelFixture fixture;
  DeviceInUse view = falconView();
  view.chosen->driver = driver.toStdString();
  view.found = {*view.chosen};
  fixture.panel.showDevice(view);
  QVERIFY(!fixture.part<QLabel>("deviceDetail")->isVisible());
  ServoSample sample;
  sample.device.status = static_cast<DeviceStatus>(status);
  fixture.panel.showSample(sample);
  QVERIFY(fixture.part<QLabel>("deviceDetail")->isVisible());
  QVERIFY2(fixture.text("deviceDetail").contains(words), qPrintable(fixture.text("deviceDetail")));
  QVERIFY(fixture.part<QWidget>("deviceState")->accessibleName().contains(fixture.text("deviceHeadline")));
  QVERIFY(!fixture.part<QPushButton>("forceTest")->isEnabled());
}

void DevicePanelTest::mouseAsDevice() {
  DevicePanelFixture fixture;
  DeviceInUse view = spaceMouseView();
  view.isPointer = true;
  view.status = DeviceStatus::Absent;
  fixture.panel.showDevice(view);
  QCOMPARE(fixture.text("deviceHeadline"), QString("The pointer is outside the view"));
  QCOMPARE(fixture.part<QComboBox>("deviceChoice")->currentText(), QString("SpaceMouse Compact"));
}

void DevicePanelTest::notRealTime() {
  DevicePanelFixture fixture;
  fixture.panel.showDevice(falconView());
  fixture.panel.showLoop({998.4, 7, RealTimeState::RealTime});
  auto* warning = fixture.part<QToolButton>("notRealTime");
  QVERIFY(!warning->isVisible());
  QCOMPARE(fixture.text("servoRate"), QString("998 ticks a second, 7 missed so far"));
  fixture.panel.showLoop({998.4, 7, RealTimeState::NotPermitted});
  QVERIFY(warning->isVisible());
  warning->click();
  QVERIFY(fixture.part<QLabel>("realTimeAdvice")->isVisible());
  fixture.part<QPushButton>("copyCommand")->click();
  QVERIFY(QGuiApplication::clipboard()->text().contains(" - rtprio "));
}

void DevicePanelTest::mappingIsEdited() {
  DevicePanelFixture fixture;
  fixture.panel.showDevice(falconView());
  WorkspaceMapping mapping;
  mapping.scale = 3.0;
  mapping.sceneFromView.translation() = Vec3(1, 2, 3);
  fixture.panel.setMapping(mapping);
  fixture.turnTo(1);
  QVERIFY(fixture.part<QWidget>("property/up")->isEnabled());
  std::vector<WorkspaceMapping> changed;
  connect(&fixture.panel, &DevicePanel::mappingChanged, this, [&](const WorkspaceMapping& m) { changed.push_back(m); });
  auto* up = fixture.part<QWidget>("property/up")->findChild<QComboBox*>("propertyChoice");
  up->setFocus();
  QTest::keyClick(up, Qt::Key_Down);
  QCOMPARE(changed.size(), std::size_t(1));
  QVERIFY(changed[0].axes[1].isInverted);
  QCOMPARE(changed[0].axes[1].axis, 1);
  QCOMPARE(changed[0].scale, 3.0);
  QCOMPARE(Vec3(changed[0].sceneFromView.translation()), Vec3(1, 2, 3));
  fixture.panel.showDevice({});
  QVERIFY(!fixture.part<QWidget>("property/up")->isEnabled());
}

void DevicePanelTest::timings() {
  DevicePanelFixture fixture;
  const DeviceInUse view = falconView();
  fixture.panel.showDevice(view);
  ServoStatistics measure(view.capabilities, 0.002, 1e-3);
  fill(measure);
  auto* plot = fixture.part<PlotWidget>("timingPlot");
  fixture.panel.showTiming(measure);  // nobody sees it
  QVERIFY(plot->plot().series[0].points.empty());
  fixture.turnTo(2);
  fixture.panel.showTiming(measure);
  QVERIFY(!plot->plot().series[0].points.empty());
  fixture.part<QComboBox>("timingKind")->setCurrentIndex(2);
  // Values of 8 to 16 us in bins of 5, each upper end: half are not above 12, all below 17.
  QCOMPARE(fixture.text("timingSummary"), QString("Half within 15 µs, 99 % within 20 µs, all within 20 µs"));
}

void DevicePanelTest::pictures_data() {
  QTest::addColumn<int>("page");
  QTest::addColumn<QSize>("size");
  const char* const names[] = {"live", "mapping", "timing", "data"};
  for (int page = 0; page < 4; ++page) QTest::newRow(names[page]) << page << QSize(300, 680);
  QTest::newRow("live-low") << 0 << QSize(296, 300);  // the room left of 1280 x 800 at 200 %
}

void DevicePanelTest::picturesOfTrouble() {
  DevicePanelFixture fixture;
  fixture.panel.showDevice(falconView());
  fixture.panel.showLoop({998.4, 7, RealTimeState::NotPermitted});
  playTouches(fixture.panel);
  ServoSample sample = sampleAt(10.0, Vec3::Zero(), Vec3::Zero());
  sample.device.status = DeviceStatus::NeedsHoming;
  for (const SafetyAction action : {SafetyAction::DeviceFault, SafetyAction::NotFinite, SafetyAction::Ramp}) {
    sample.actions.add(action);
  }
  fixture.panel.showSample(sample);
  look(fixture.panel, "falcon-homing");
  fixture.panel.showDevice({});
  look(fixture.panel, "none");
}

void DevicePanelTest::pictures() {
  QFETCH(int, page);
  QFETCH(QSize, size);
  for (const DeviceInUse& view : {falconView(), spaceMouseView()}) {
    DevicePanelFixture fixture;
    fixture.panel.resize(size);
    fixture.turnTo(page);
    fixture.panel.showDevice(view);
    fixture.panel.showLoop({998.4, 7, page == 1 ? RealTimeState::RealTime : RealTimeState::NotPermitted});
    playTouches(fixture.panel);
    ServoStatistics measure(view.capabilities, 0.002, 1e-3);
    fill(measure);
    fixture.panel.showTiming(measure);
    look(fixture.panel,
         QStringLiteral("%1-%2").arg(QString::fromStdString(view.chosen->driver), QTest::currentDataTag()));
  }
}

// In both themes nothing is cut, everything has a name and is reached by Tab. With HANDWHEEL_PICTURES, a folder, the
// pictures are kept there for inspection.
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
