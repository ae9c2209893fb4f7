// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "LatheWindow.h"
#include "controls/NumberField.h"
#include "document/recovery/Recovery.h"
#include "panels/time/TimeLinePanel.h"
#include "tools/workpiece/TurnTool.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/fidelity/FidelityChoice.h"

#include <QComboBox>
#include <QDockWidget>
#include <QMenu>
#include <QPushButton>
#include <QTabBar>
#include <QTemporaryDir>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// The manual lathe as a student uses it: keys, wheels, tools, undo, replay, a device.
class LatheWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  // The setup is that of an exercise.
  void leversOfThePanelAreThoseOfTheLathe() {
    LatheWindow window(kSmallWindow);
    window.driver.choose("newWorkpiece");
    QVERIFY(window.driver.settle());
    auto setup = std::make_shared<LatheSetup>(latheOf(window.workpiece()));
    setup->spindle.speed = 800.0;
    window.document().commit(QStringLiteral("Set up"), std::make_unique<LatheSetupEdit>(setup));
    window.driver.find<QAction>("latheTool")->trigger();
    QVERIFY(window.driver.settle() && window.lathe());
    QTRY_COMPARE(window.driver.find<NumberField>("latheSpeed")->value(), 800.0);
    QVERIFY(!window.driver.find<QAbstractButton>("latheConstantSpeed")->isChecked());
    QCOMPARE(window.machine().setSpeed, 800.0);
  }

  // A section can be folded, by mouse or key, gives its room to the view, and stays folded.
  void sectionsFold() {
    LatheWindow window(kSmallWindow);
    QVERIFY(window.beginLathe());
    auto* dock = window.driver.find<QDockWidget>("latheDock");
    auto* wheel = window.driver.find<QWidget>("latheCross");
    auto* thread = window.driver.find<QWidget>("latheHalfNut");
    QVERIFY(wheel->isVisible() && thread->isVisible());
    const int high = dock->height(), view = window.view->height();  // sections stand side by side
    window.driver.click("latheSection/wheels");
    window.driver.click("latheSection/thread");
    QVERIFY(!wheel->isVisible() && !thread->isVisible());
    QVERIFY(dock->height() <= high);
    QVERIFY(window.view->height() >= view);
    auto* heading = window.driver.find<QWidget>("latheSection/thread");
    heading->setFocus();
    QTest::keyClick(heading, Qt::Key_Space);
    QVERIFY(thread->isVisible());
    LatheWindow again(kSmallWindow);
    QVERIFY(again.beginLathe());
    QVERIFY(!again.driver.find<QWidget>("latheCross")->isVisible());
    QVERIFY(again.driver.find<QWidget>("latheHalfNut")->isVisible());
  }

  // Clockwise is in for the cross slide, away from the chuck for the carriage. The rings begin at zero and count up.
  void wheelsTurnAsOnALathe() {
    LatheWindow window(kSmallWindow);
    QVERIFY(window.beginLathe());
    const double z = window.slide(LatheAxis::Carriage), r = window.slide(LatheAxis::Cross);
    QTRY_COMPARE(window.dial("latheCross").readingText(), QStringLiteral("0.0 div"));
    window.crank(window.dial("latheCross"), 2.0);
    QVERIFY(window.comesTo(LatheAxis::Cross, r - 4.0, 0.05));  // a turn is 2 mm; to the precision of pixels
    // The read-out is in diameters, and so is the dial.
    const auto counted = [&] { return window.dial("latheCross").value() - window.dial("latheCross").zero(); };
    QTRY_VERIFY(std::abs(counted() - 8.0) < 0.1);
    QVERIFY(window.dial("latheCross").numberText().startsWith(QStringLiteral("Δ⌀")));  // no size: travel
    QVERIFY(window.dial("latheCarriage").numberText().startsWith(QStringLiteral("Δ ")));
    const auto* const touchOff = window.driver.find<QPushButton>("latheTouchX");
    QVERIFY(touchOff->text().endsWith(QStringLiteral("X ⌀")));
    auto setup = std::make_shared<LatheSetup>(latheOf(window.workpiece()));
    setup->showsDiameter = false;
    window.document().commit(QStringLiteral("Set up"), std::make_unique<LatheSetupEdit>(setup));
    QTRY_VERIFY(window.dial("latheCross").numberText().startsWith(QStringLiteral("ΔR")));
    QTRY_VERIFY(touchOff->text().endsWith(QStringLiteral("X R")));
    QVERIFY(std::abs(counted() - 4.0) < 0.05);
    window.document().history()->undo();
    QTRY_VERIFY(std::abs(counted() - 8.0) < 0.1);
    window.crank(window.dial("latheCross"), -2.0);
    QVERIFY(window.comesTo(LatheAxis::Cross, r, 0.05));
    window.crank(window.dial("latheCarriage"), 0.5);
    QVERIFY(window.comesTo(LatheAxis::Carriage, z + 10.0, 0.5));
    const double compound = window.slide(LatheAxis::Compound);
    window.crank(window.dial("latheCompound"), 1.0);
    QVERIFY(window.comesTo(LatheAxis::Compound, compound - 1.0, 0.05));
  }

  // Arrows move carriage and cross slide, whatever wheel was turned last; a wheel that Tab came to moves only itself.
  void arrowsHaveTheirSlides() {
    LatheWindow window(kSmallWindow);
    QVERIFY(window.beginLathe());
    window.crank(window.dial("latheCompound"), 0.25);
    QVERIFY2(window.driver.window().focusWidget() == window.view,
             qPrintable(window.driver.window().focusWidget()->objectName()));
    QVERIFY(QTest::qWaitFor([&] { return window.machine().demands == std::array<double, kLatheAxes>{}; }));
    const double z = window.slide(LatheAxis::Carriage), r = window.slide(LatheAxis::Cross);
    QTest::keyClick(window.view, Qt::Key_Left);
    QVERIFY(window.comesTo(LatheAxis::Carriage, z - 0.2));
    QTest::keyClick(window.view, Qt::Key_Up, Qt::ControlModifier);
    QVERIFY(window.comesTo(LatheAxis::Cross, r - 0.002));
    QTest::keyClick(window.view, Qt::Key_Down, Qt::ShiftModifier);
    QVERIFY(window.comesTo(LatheAxis::Cross, r + 0.198));
    window.dial("latheCompound").setFocus(Qt::TabFocusReason);
    const double compound = window.slide(LatheAxis::Compound);
    QTest::keyClick(&window.dial("latheCompound"), Qt::Key_Up);
    QVERIFY(window.comesTo(LatheAxis::Compound, compound - 0.02));
    QVERIFY(std::abs(window.slide(LatheAxis::Cross) - r - 0.198) < 1e-9);
  }

  // A number that is no size is not shown as one: neither in the panel nor at the tool. Each tool has its own.
  void theReadOutIsUnknownUntilTouchedOff() {
    LatheWindow window(kSmallWindow);
    QVERIFY(window.beginLathe());
    auto *x = window.driver.find<QLabel>("latheX"), *z = window.driver.find<QLabel>("latheZ");
    QTRY_COMPARE(x->text(), QStringLiteral("X not touched off"));
    QCOMPARE(z->text(), QStringLiteral("Z not touched off"));
    QVERIFY(!x->isEnabled() && x->toolTip().contains("Touch off X") && z->toolTip().contains("Touch off Z"));
    QVERIFY(!window.lathe()->preview().label);
    window.driver.find<NumberField>("latheTouchValue")->setValue(46.5);
    window.driver.click("latheTouchX");
    // Away from any surface it is refused with the reason, unless the turner insists.
    QTRY_VERIFY(window.driver.text("messageText").contains("does not touch"));
    QVERIFY2(window.driver.text("messageText").contains("20.00 mm"), qPrintable(window.driver.text("messageText")));
    QCOMPARE(x->text(), QStringLiteral("X not touched off"));
    window.driver.click("messageAction");
    QTRY_COMPARE(x->text(), QStringLiteral("X ⌀ 46.500 mm"));
    QVERIFY(x->isEnabled() && x->toolTip().contains("Diameter") && x->toolTip().contains("outward is positive"));
    QCOMPARE(z->text(), QStringLiteral("Z not touched off"));
    QTRY_VERIFY(window.lathe()->preview().label);
    QCOMPARE(window.lathe()->preview().label->figures.size(), std::size_t(1));
    QCOMPARE(window.lathe()->preview().label->figures[0].value, 46.5);
    auto* post = window.driver.find<QComboBox>("latheTool");
    post->setCurrentIndex(1);
    emit post->activated(1);
    QTRY_COMPARE(x->text(), QStringLiteral("X not touched off"));
    window.document().history()->undo();
    post->setCurrentIndex(0);
    emit post->activated(0);
    QTest::qWait(100);
    QTRY_COMPARE(x->text(), QStringLiteral("X not touched off"));
  }

  // A cut left ⌀46, and 49 is entered: both are said, and the read-out stays unless the turner insists. What was taken
  // is undone as usual.
  void aSlipAtTouchingOff() {
    LatheWindow window(kSmallWindow);
    QVERIFY(window.beginLathe() && window.turnEnd());
    window.driver.click("latheFeedOff");
    auto* const x = window.driver.find<QLabel>("latheX");
    window.driver.find<NumberField>("latheTouchValue")->setValue(49.0);
    window.driver.click("latheTouchX");
    QTRY_VERIFY(window.driver.text("messageText").contains("another size"));
    const QString said = window.driver.text("messageText");
    QVERIFY2(said.contains("49.000 mm") && said.contains(QStringLiteral("⌀ 46.0")), qPrintable(said));
    window.driver.click("messageOther");
    QCOMPARE(x->text(), QStringLiteral("X not touched off"));
    window.driver.click("latheTouchX");
    QTRY_VERIFY(window.driver.find<QPushButton>("messageAction")->isVisible());
    window.driver.click("messageAction");
    QTRY_COMPARE(x->text(), QStringLiteral("X ⌀ 49.000 mm"));
    window.document().history()->undo();
    QTRY_COMPARE(x->text(), QStringLiteral("X not touched off"));
    window.driver.find<NumberField>("latheTouchValue")->setValue(46.0);
    window.driver.click("latheTouchX");
    QTRY_COMPARE(x->text(), QStringLiteral("X ⌀ 46.000 mm"));
  }

  // The panel names the law in use: the chosen one may have no data, the network gives way to the power law outside its
  // range, and a law may not have been compared with the handbook.
  void theLawInUse() {
    {
      LatheWindow window(kSmallWindow);
      window.driver.window().findChild<FidelityChoice*>()->set("turn.force_model", double(ForceLaw::Network));
      QVERIFY(window.beginLathe());
      auto* law = window.driver.find<QLabel>("latheLaw");
      QTRY_COMPARE(law->text(), QStringLiteral("Network"));
      QVERIFY(!law->toolTip().contains("Kienzle"));
      QVERIFY(window.turnEnd(0.5));  // mm in a turn; it was trained on 0.4 at most
      QTRY_COMPARE(law->text(), QStringLiteral("Power law"));
      QVERIFY(law->toolTip().contains("outside the range of the network"));
      window.driver.click("latheFeedOff");
      QVERIFY(bool(window.document().setProperty("material", std::string("Brass"))));
      QTRY_COMPARE(law->text(), QStringLiteral("Kienzle"));
      QVERIFY(law->toolTip().contains("Network has no data"));
    }
    LatheWindow window(kSmallWindow);  // with a rake of -6°, between two entries of the table
    window.driver.window().findChild<FidelityChoice*>()->set("turn.force_model", double(ForceLaw::Kosilova));
    QVERIFY(window.beginLathe());
    auto* law = window.driver.find<QLabel>("latheLaw");
    QTRY_COMPARE(law->text(), QStringLiteral("Kosilova, unverified"));
    QVERIFY(law->toolTip().contains("compared with the handbook"));
  }

  void rapidWhileHeld() {
    LatheWindow window(kSmallWindow);
    QVERIFY(window.beginLathe());
    const double z = window.slide(LatheAxis::Carriage);
    QTest::keyPress(window.view, Qt::Key_Right, Qt::AltModifier);
    QVERIFY(QTest::qWaitFor([&] { return window.slide(LatheAxis::Carriage) > z + 3.0; }, kPatienceMs));
    QTest::keyRelease(window.view, Qt::Key_Right, Qt::AltModifier);
    QVERIFY(QTest::qWaitFor([&] { return window.machine().rapids[0] == 0; }, kPatienceMs));
    auto* left = window.driver.find<QAbstractButton>("latheRapidLeft");
    const double far = window.slide(LatheAxis::Carriage);
    QTest::mousePress(left, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return window.slide(LatheAxis::Carriage) < far - 2.0; }, kPatienceMs));
    QTest::mouseRelease(left, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return window.machine().rapids[0] == 0; }, kPatienceMs));
  }

  // Chosen while the feed runs, it begins with the cut so far; on return the slides are where they were, and rest.
  void anotherToolKeepsTheCut() {
    LatheWindow window(kSmallWindow);
    QVERIFY(window.beginLathe() && window.turnEnd());
    window.driver.find<QAction>("turnTool")->trigger();
    QVERIFY(window.driver.settle());
    const auto* const turn = dynamic_cast<const TurnTool*>(window.tools().runner().tool());
    QVERIFY(turn && window.workpiece().part);
    QVERIFY(turn->state()->profile == window.workpiece().part->profile);
    QCOMPARE(window.document().history()->count(), 1);
    QVERIFY(std::abs(window.radiusAt(99.5) - 23.0) < 0.05);
    window.driver.find<QAction>("latheTool")->trigger();
    QVERIFY(window.driver.settle());
    QVERIFY(window.lathe() && window.lathe()->moment()->profile == window.workpiece().part->profile);
  }

  // A look at another document moves no slides and no rings of the wheels; the spindle stops, which is said.
  void slidesStayInTheirDocument() {
    LatheWindow window(kSmallWindow);
    QVERIFY(window.beginLathe());
    const double start = window.slide(LatheAxis::Carriage);
    for (int i = 0; i < 5; ++i) QTest::keyClick(window.view, Qt::Key_Left, Qt::ShiftModifier);  // 2 mm each
    QVERIFY(window.comesTo(LatheAxis::Carriage, start - 10.0));
    const auto counted = [&] { return window.dial("latheCarriage").value() - window.dial("latheCarriage").zero(); };
    QTRY_VERIFY(std::abs(counted() + 10.0) < 1e-3);
    QTest::keyClick(window.view, Qt::Key_Space);
    QVERIFY(QTest::qWaitFor([&] { return window.machine().speed > 100.0; }, kPatienceMs));
    const LatheState before = window.machine();
    auto* const touch = window.driver.find<NumberField>("latheTouchValue");
    touch->setValue(46.2);
    auto* tabs = window.driver.find<QTabBar>("documentTabBar");
    window.driver.choose("newWorkpiece");
    QVERIFY(window.driver.settle() && tabs->count() == 2);
    QTRY_VERIFY(window.driver.text("messageText").contains(QStringLiteral("The spindle was stopped")));
    if (!window.lathe()) window.driver.find<QAction>("latheTool")->trigger();
    QVERIFY(window.driver.settle() && window.lathe());
    QTRY_COMPARE(touch->value(), 0.0);  // the number is that of the first bar
    tabs->setCurrentIndex(0);
    QVERIFY(window.driver.settle());
    if (!window.lathe()) window.driver.find<QAction>("latheTool")->trigger();
    QVERIFY(window.driver.settle() && window.lathe());
    QVERIFY(window.machine().slides == before.slides && window.machine().direction == 0);
    QTRY_VERIFY(std::abs(counted() + 10.0) < 1e-3);
    QTRY_COMPARE(touch->value(), 46.2);
  }

  // One Ctrl+Z takes back the pass that is being cut: the slides rest, the spindle turns on.
  void undoTakesThePassBack() {
    LatheWindow window(kSmallWindow);
    QVERIFY(window.beginLathe() && window.turnEnd());
    QVERIFY(window.machine().direction != 0);
    QTRY_VERIFY(window.driver.find<QAction>("undo")->text().contains("Turning pass 1"));
    window.driver.find<QAction>("undo")->trigger();
    QVERIFY(window.driver.settle());
    QVERIFY(!window.workpiece().part);
    QCOMPARE(window.document().history()->count(), 1);
    QVERIFY(window.machine().direction != 0 && window.machine().feed == 0.0);
    QVERIFY(window.lathe()->collisions().empty());
    QTRY_VERIFY(window.driver.find<QAction>("redo")->isEnabled());
    window.driver.find<QAction>("redo")->trigger();
    QVERIFY(window.workpiece().part);
    QVERIFY(std::abs(window.radiusAt(99.5) - 23.0) < 0.05);
    // Taken back again, and another one begun, which is in no step yet: there is no redo beside it.
    auto* const redo = window.driver.find<QAction>("redo");
    window.driver.find<QAction>("undo")->trigger();
    QVERIFY(window.driver.settle());
    QTRY_VERIFY(!window.workpiece().part && redo->isEnabled());
    window.driver.click("latheFeedLeft");
    for (int i = 0; i < 15; ++i) QTest::keyClick(window.view, Qt::Key_Up, Qt::ShiftModifier);  // 0.2 mm each
    QTRY_VERIFY(window.lathe()->moment()->isCut && !redo->isEnabled());
    QCOMPARE(window.document().history()->count(), 1);  // still the first one
  }

  void toolsAreMountedByTheMenu() {
    LatheWindow window(kSmallWindow);
    QVERIFY(window.beginLathe());
    auto* menu = window.driver.find<QMenu>("latheMountMenu");
    emit menu->aboutToShow();
    window.driver.find<QAction>("mount/facing")->trigger();
    QVERIFY(window.driver.settle());
    QCOMPARE(window.lathe()->setup().stations[0].tool, std::string("facing"));
    auto* sides = window.driver.find<QComboBox>("latheTool");
    QTRY_VERIFY(sides->itemText(0).contains(QStringLiteral("TCMT")));
    QCOMPARE(window.document().history()->undoText(), QStringLiteral("Mount Facing tool TCMT 16T304"));
  }

  // The thread of a half-nut: the carriage goes its pitch in a turn of the spindle.
  void halfNutLeadsTheCarriage() {
    LatheWindow window(kSmallWindow);
    QVERIFY(window.beginLathe());
    QTest::keyClick(window.view, Qt::Key_Space);
    window.driver.click("latheHalfNut");
    QVERIFY(QTest::qWaitFor([&] { return window.machine().isNutClosed; }, kPatienceMs));
    const LatheState before = window.machine();
    QVERIFY(QTest::qWaitFor([&] { return window.machine().turns > before.turns + 3.0; }, kPatienceMs));
    const LatheState now = window.machine();
    QVERIFY(std::abs((before.slides[0] - now.slides[0]) - 1.5 * (now.turns - before.turns)) < 1e-6);
    window.driver.click("latheHalfNut");
    QVERIFY(QTest::qWaitFor([&] { return window.machine().lead == 0.0; }, kPatienceMs));
    // A left-hand thread leads away from the chuck.
    auto* const left = window.driver.find<QPushButton>("latheLeftHand");
    QTRY_VERIFY(left->isEnabled());
    window.driver.click("latheLeftHand");
    window.driver.click("latheHalfNut");
    QVERIFY(QTest::qWaitFor([&] { return window.machine().isNutClosed; }, kPatienceMs));
    QCOMPARE(window.machine().lead, 1.5);
    QTRY_VERIFY(!left->isEnabled());
    const LatheState start = window.machine();
    QVERIFY(QTest::qWaitFor([&] { return window.machine().turns > start.turns + 1.0; }, kPatienceMs));
    QVERIFY(window.machine().slides[0] > start.slides[0] + 1.0);
  }

  // Played back the view shows the bar as it was; closed, the part as it is, and the lathe stands where it stood.
  void replayAndBack() {
    LatheWindow window(kSmallWindow);
    QVERIFY(window.beginLathe() && window.turnEnd());
    QTest::keyClick(window.view, Qt::Key_Escape);
    QVERIFY(window.driver.settle());
    QTRY_COMPARE(window.machine().speed, 0.0);
    QVERIFY(window.workpiece().part);
    const LatheState before = window.machine();
    const auto part = window.workpiece().part;
    window.driver.choose("replayDockToggle");
    QVERIFY(window.driver.settle());
    auto* line = window.driver.find<TimeLinePanel>("replayTimeLine");
    QTRY_VERIFY(line->isVisible() && line->isEnabled());
    QVERIFY(window.driver.settle());
    const QString end = window.driver.text("replayText");
    QVERIFY(end.contains(QStringLiteral("Pass 1 of 1")));
    const double half = 0.5;  // s; 2 mm at 0.2 mm · 600 / min last 1 s
    QVERIFY(line->time() > half);
    window.driver.hold();
    line->setPlaying(true);  // from the end it begins anew
    QTRY_VERIFY(line->time() < half);
    line->setPlaying(false);
    QCOMPARE(window.driver.text("replayText"), end);  // a worker makes the shown part
    window.driver.release();
    QTRY_VERIFY(window.driver.text("replayText") != end);
    QCOMPARE(window.document().history()->count(), 1);
    window.driver.choose("replayDockToggle");
    QVERIFY(!line->isVisible());
    QVERIFY(window.workpiece().part == part);
    QVERIFY(window.machine().slides == before.slides);
  }

  // Beside it another workpiece is played, on the same time line.
  void replayBesideAnother() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("first.handwheel");
    LatheWindow window(kSmallWindow);
    QVERIFY(window.beginLathe() && window.turnEnd());
    QTest::keyClick(window.view, Qt::Key_Escape);
    QVERIFY(window.driver.settle());
    window.driver.click("quickActions/saveFile");
    QVERIFY(window.driver.enterFileName("saveDialog", path) && window.driver.settle());
    window.driver.choose("replayDockToggle");
    QVERIFY(window.driver.settle());
    auto* const line = window.driver.find<TimeLinePanel>("replayTimeLine");
    auto* const compare = window.driver.find<QPushButton>("replayCompare");
    QTRY_VERIFY(line->isEnabled() && compare->isEnabled());
    QCOMPARE(line->timeOf(1), 0.0);
    window.driver.click("replayCompare");
    QVERIFY(window.driver.enterFileName("replayCompareDialog", path) && window.driver.settle());
    QTRY_VERIFY(compare->text().contains("first.handwheel"));
    QVERIFY(line->time() > 0.5 && std::abs(line->timeOf(1) - line->time()) < 1e-9);  // 2 mm at 2 mm/s last 1 s
    window.driver.click("replayCompare");
    QVERIFY(!compare->text().contains("first.handwheel"));
    QCOMPARE(line->timeOf(1), 0.0);
  }

  // A thread that is being cut is of the bar as it was, and the window says that it is not cut into another one.
  void aThreadOfAnOlderBar() {
    LatheWindow window(kSmallWindow);
    window.driver.choose("newWorkpiece");
    QVERIFY(window.driver.settle());
    const double narrower = 40.0;  // mm
    for (const bool isChanged : {true, false}) {
      window.driver.choose("thread");
      window.driver.click("cutThread");
      QVERIFY(!isChanged || window.document().setProperty("diameter", narrower));
      QVERIFY(window.driver.settle());
      QCOMPARE(window.workpiece().part == nullptr, isChanged);
      QCOMPARE(window.workpiece().stock.diameter, narrower);
      QCOMPARE(window.driver.find<QWidget>("messageBar")->isVisible(), isChanged);
      if (!isChanged) continue;
      const QString said = window.driver.text("messageText");
      QVERIFY2(said.contains("thread") && said.contains("changed meanwhile"), qPrintable(said));
      window.driver.click("messageClose");
    }
  }

  // Opened, a model solution is as fine as it was made, whatever this machine shows a new bar with.
  void aModelSolutionKeepsItsTolerance() {
    LatheWindow window(kSmallWindow);
    window.driver.choose("newExercise");
    QVERIFY(window.driver.settle());
    window.driver.choose("beginExercise");
    QVERIFY(window.driver.settle());
    QVERIFY(window.document().setProperty("chord", 0.5));
    window.driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    window.driver.choose("takeSolution");
    QTRY_VERIFY(window.driver.text("messageText").contains("Model solution taken"));
    window.driver.choose("openSolution");
    QVERIFY(window.driver.settle());
    QCOMPARE(window.driver.tabs(), 3);
    QCOMPARE(window.workpiece().chord, 0.5);
  }

  // Killed while the feed runs, the program offers the cuts up to the last autosave.
  void aKilledPassComesBack() {
    const QString folder = QString::fromStdString(recoveryFolder().string());
    QDir(folder).removeRecursively();  // left by previous tests
    QSettings().setValue("autosaveSeconds", 5);
    {
      LatheWindow window(kSmallWindow);
      QVERIFY(window.beginLathe() && window.turnEnd());
      QVERIFY(!window.workpiece().part);  // nothing was committed
      const QDateTime isCut = QDateTime::currentDateTime();
      const auto isStored = [&] {
        for (const QString& session : QDir(folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot))
          for (const QFileInfo& each : QDir(folder + "/" + session).entryInfoList({"*.handwheel"}, QDir::Files))
            if (each.lastModified() > isCut) return true;
        return false;
      };
      QVERIFY(QTest::qWaitFor(isStored, kPatienceMs));
    }  // the window goes without asking, as in a crash
    WindowDriver second(kSmallWindow);
    second.window().offerRecovery();
    second.click("messageAction");
    QVERIFY(QTest::qWaitFor([&] { return second.tabs() == 1; }, kPatienceMs) && second.settle());
    const auto& work =
        static_cast<const WorkpieceDocument&>(second.window().findChild<DocumentTabs*>()->current()->document)
            .workpiece();
    QVERIFY(work.part && !work.crashes);
    const TurnedProfile& profile = work.part->profile;
    QVERIFY(std::abs(profile.radius(static_cast<std::size_t>(std::lround(99.0 / profile.spacing()))) - 23.0) < 0.02);
  }

  // A hand at a device holds the tool, and cuts with it. It takes the tool where it is, 20 mm in X and Z from the bar,
  // and moves it by as much as it moves.
  void aHandHoldsTheTool() {
    LatheWindow window(kSmallWindow);
    QVERIFY(window.beginLathe());
    window.session.choose("simulated", "hand");
    QVERIFY(QTest::qWaitFor([&] { return window.session.latest() != nullptr; }, kPatienceMs));
    QVERIFY(window.driver.settle());
    const auto isBeside = [&window] {  // led anew, as the view may still change
      window.leadTo({40.0, 0.0, 108.0}, 0);
      const Vec3& tip = window.session.latest()->tip.position;
      return std::abs(tip.x() - 40.0) < 1.0 && std::abs(tip.z() - 108.0) < 1.0;
    };
    QVERIFY(QTest::qWaitFor(isBeside, kPatienceMs));
    window.leadTo({40.0, 0.0, 108.0}, 1);
    QVERIFY(QTest::qWaitFor([&] { return window.lathe()->isLive(); }, kPatienceMs));
    QVERIFY(window.comesTo(LatheAxis::Cross, 45.0, 1.0) && window.comesTo(LatheAxis::Carriage, 120.0, 1.0));
    QTest::keyClick(window.view, Qt::Key_Space);
    QVERIFY(QTest::qWaitFor([&] { return window.machine().speed == window.machine().setSpeed; }, kPatienceMs));
    window.leadTo({18.0, 0.0, 80.0}, 1);  // the grip may be off by a millimetre
    const auto isCut = [&window] {
      const TurnedProfile& profile = window.lathe()->moment()->profile;
      return profile.radius(static_cast<std::size_t>(std::lround(99.5 / profile.spacing()))) < 25.0;
    };
    QVERIFY(QTest::qWaitFor(isCut, kPatienceMs));
    window.leadTo({40.0, 0.0, 108.0}, 0);
    QVERIFY(QTest::qWaitFor([&] { return window.document().history()->count() == 1; }, kPatienceMs));
    QVERIFY(window.radiusAt(99.5) < 25.0);
  }
};

HANDWHEEL_WINDOW_TEST(LatheWindowTest)
#include "LatheWindowTest.moc"
