// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../QuickWindow.h"
#include "../WindowTestMain.h"
#include "window/haptics/HapticSession.h"
#include "window/haptics/ScriptedDeviceDemo.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr int kWholeMs = 120000;

struct ShowFixture {
  QuickWindow driver;
  ScriptedDeviceDemo& show;
  HapticSession& session;

  ShowFixture()
      : show(*driver.window().findChild<ScriptedDeviceDemo*>()), session(*driver.window().findChild<HapticSession*>()) {
    show.setPace(4.0);
  }
  ~ShowFixture() { session.close(); }

  bool waitFor(const QString& caption) {
    return QTest::qWaitFor([&] { return show.caption().startsWith(caption); }, kWholeMs);
  }
  // The steps that can be undone, the last first; afterwards none can.
  QStringList undoAll() {
    auto* undo = driver.find<QAction>("undo");
    QStringList steps;
    for (; undo->isEnabled() && steps.size() < 100; undo->trigger()) steps << undo->text();
    driver.settle();
    return steps;
  }
};

}  // namespace

// The simulated hand repairs a hole in the window, from the servo loop to the undo step.
class RepairDemoTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  // Smoothed, bridged, two parts filled, subdivided, pulled, the seam smoothed: seven steps, and one hole less. The
  // first step is that of opening, which has reversed triangles.
  void aHoleIsRepaired() {
    ShowFixture fixture;
    QSignalSpy ended(&fixture.show, &ScriptedDeviceDemo::ended);
    fixture.driver.choose("watchRepair");
    QVERIFY(fixture.waitFor("1 of 5"));
    QVERIFY(fixture.session.simulatedHand());
    const int holes = fixture.driver.count(DefectKind::Hole);
    QVERIFY(fixture.waitFor("4 of 5"));
    QTRY_COMPARE(fixture.driver.count(DefectKind::Hole), holes + 1);  // the bridge has parted it
    QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, kWholeMs);
    QVERIFY(ended.first().first().toBool());
    QVERIFY(fixture.driver.settle());
    QCOMPARE(fixture.driver.count(DefectKind::Hole), holes - 1);
    QVERIFY(!fixture.session.isOpen() && fixture.session.chosen().driver.empty());
    QStringList steps = fixture.undoAll();
    for (QString& step : steps) step = step.section(QLatin1Char(' '), 1, 1);  // "Fill", of "&Undo Fill hole 8"
    QCOMPARE(steps, QStringList({"Smooth", "Drag", "Subdivide", "Fill", "Fill", "Add", "Smooth", "Triangles"}));
    QCOMPARE(fixture.driver.count(DefectKind::Hole), holes);
  }

  // Stopped in the midst nothing stays in the air, and the device comes back that was in use.
  void itCanBeStopped() {
    ShowFixture fixture;
    fixture.session.choose("mouse", "pointer");
    QTRY_VERIFY(fixture.session.mouse());
    QSignalSpy ended(&fixture.show, &ScriptedDeviceDemo::ended);
    fixture.driver.choose("watchRepair");
    QVERIFY(fixture.waitFor("3 of 5"));
    fixture.driver.find<QAction>("stopShow")->trigger();
    QVERIFY(!fixture.show.isRunning() && fixture.show.caption().isEmpty());
    QCOMPARE(ended.count(), 1);
    QVERIFY(!ended.first().first().toBool());
    QTRY_VERIFY(fixture.session.mouse());
    QVERIFY(fixture.driver.settle());
    const QStringList steps = fixture.undoAll();  // the last is what opening has done
    QCOMPARE(steps.size(), 2);
    QCOMPARE(steps.first(), "&Undo Smooth the boundary");
  }

  // Choosing another device ends it.
  void anotherDeviceEndsIt() {
    ShowFixture fixture;
    fixture.driver.choose("watchRepair");
    QVERIFY(fixture.waitFor("1 of 5"));
    fixture.session.choose("mouse", "pointer");
    QVERIFY(!fixture.show.isRunning());
    QTRY_VERIFY(fixture.session.mouse());
  }
};

HANDWHEEL_WINDOW_TEST(RepairDemoTest)
#include "RepairDemoTest.moc"
