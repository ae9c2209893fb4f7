// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "../workpiece/LatheWindow.h"
#include "LessonWidgets.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"

#include <QPushButton>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// The steps of a lesson while a pass of the manual lathe is under way.
class LessonPassTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  // The bar of 40 mm has its ⌀30 up to the shoulder at Z 50 of 80: three steps are ticked. A pass at ⌀28 spoils the
  // diameter, in two of them, before it is in the document.
  void aPassSpoilsASize() {
    LatheWindow window;
    window.driver.choose("exercise/first-lesson-teacher");
    QVERIFY(window.driver.settle());
    window.driver.choose("beginExercise");
    QVERIFY(window.driver.settle());
    TurningPass pass;
    pass.noseRadius = 0.8;
    pass.path = {{15.8, 82.0}, {15.8, 50.8}};
    pass.times = {0.0, 31.2 / (0.25 * 800.0 / 60.0)};
    WorkpieceDocument& work = window.document();
    work.commit("Turn", std::make_unique<TurnedPartEdit>(withPass(work.workpiece(), pass, 0.05)));
    QVERIFY(window.driver.settle());
    auto* const lesson = window.driver.find<QWidget>("exerciseLesson");
    QTRY_VERIFY2(labelsOf(lesson).contains("3 of 5 steps"), qPrintable(labelsOf(lesson)));
    partOfLesson<QPushButton>(window.driver, "exerciseLesson", "lesson/measure")->click();
    QVERIFY(window.driver.settle());
    const auto* const sizes = partOfLesson<QLabel>(window.driver, "exerciseLesson", "lesson/sizes");
    QTRY_VERIFY(sizes->isEnabled() && sizes->text().contains(QStringLiteral("✓ ⌀30 ±0.5")));

    window.driver.find<QAction>("latheTool")->trigger();
    QVERIFY(window.driver.settle() && window.lathe());
    window.view->setFocus();
    QVERIFY(window.rests());
    QTest::keyClick(window.view, Qt::Key_Space);
    const auto go = [&window](LatheAxis axis, Qt::Key key, double step, double to) {
      const auto clicks = std::lround((window.slide(axis) - to) / step);
      for (int i = 0; i < clicks; ++i) QTest::keyClick(window.view, key, Qt::ShiftModifier);
      return window.comesTo(axis, to, step);
    };
    QVERIFY(go(LatheAxis::Carriage, Qt::Key_Left, 2.0, 82.0));
    QVERIFY(go(LatheAxis::Cross, Qt::Key_Up, 0.2, 14.0));
    const int steps = work.history()->count();
    window.driver.click("latheFeedLeft");
    const auto isSpoiled = [lesson] { return labelsOf(lesson).contains("1 of 5 steps"); };
    QVERIFY2(QTest::qWaitFor(isSpoiled, kPatienceMs), qPrintable(labelsOf(lesson)));
    QCOMPARE(work.history()->count(), steps);  // it is not in the document yet
    QVERIFY(!sizes->isEnabled());
    const auto isGood = [lesson] { return labelsOf(lesson).contains("3 of 5 steps"); };
    // Other records of that time, such as a crash, do not restore the sizes that the document still has.
    QVERIFY(window.tools().isUnderWay(work));
    const auto value = std::static_pointer_cast<const WorkpieceSnapshot>(window.tools().valueWithGesture(work));
    QVERIFY(value && value->part->passes.size() > work.workpiece().part->passes.size());
    const LatheCollision crash;
    work.addCrashes({&crash, 1});
    QVERIFY(!QTest::qWaitFor(isGood, 3000));
    QVERIFY2(isSpoiled(), qPrintable(labelsOf(lesson)));
    window.driver.find<QAction>("undo")->trigger();
    QVERIFY2(QTest::qWaitFor(isGood, kPatienceMs), qPrintable(labelsOf(lesson)));

    // Sizes that were measured before tick nothing when the work is shown again.
    window.driver.find<QAction>("undo")->trigger();
    const auto isUncut = [lesson] { return labelsOf(lesson).contains("0 of 5 steps"); };
    QVERIFY2(QTest::qWaitFor(isUncut, kPatienceMs), qPrintable(labelsOf(lesson)));
    auto* const tabs = window.driver.window().findChild<DocumentTabs*>();
    DocumentTab* const here = tabs->current();
    tabs->setCurrent(tabs->all().front().get());
    QVERIFY(tabs->current() != here && window.driver.settle());
    tabs->setCurrent(here);
    QVERIFY(window.driver.settle());
    QVERIFY2(isUncut() && !sizes->isEnabled(), qPrintable(labelsOf(lesson)));
  }
};

HANDWHEEL_WINDOW_TEST(LessonPassTest)
#include "LessonPassTest.moc"
