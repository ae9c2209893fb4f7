// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/LessonPanel.h"

#include "ControlPictures.h"
#include "ControlsTestMain.h"

#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

std::vector<LessonStep> shoulderSteps() {
  return {{"Clamp the bar",
           "Choose the chuck and clamp the bar by 30 mm.",
           {"The chuck is in the panel Machine."},
           LessonStep::State::Open,
           true},
          {"Touch off",
           "Turn the cross slide until the tool touches the bar, then set its dial to zero.",
           {"A double click on the dial sets it to zero.", "Turn slowly: Ctrl turns by a tenth of a division."}},
          {"Turn the shoulder", "Turn to 30 mm over a length of 20 mm.", {"Two passes of 1 mm are better than one."}},
          {"Check it", "Compare the drawing.", {}}};
}

struct LessonBench {
  LessonBench() {
    panel.setLesson("Your first shoulder", shoulderSteps());
    panel.resize(300, 480);
    panel.show();
    panel.activateWindow();
    if (!QTest::qWaitForWindowActive(&panel)) qFatal("the panel does not appear");
  }
  template <class Widget>
  Widget* part(const char* name) {
    return panel.findChild<Widget*>(name);
  }
  QString text(const char* label) { return part<QLabel>(label)->text(); }
  bool isSeen(const char* name) { return part<QWidget>(name)->isVisible(); }
  LessonPanel panel;
};

using State = LessonStep::State;

}  // namespace

class LessonPanelTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { applyTheme(*qApp, ThemeKind::Light); }
  void goesOnWhenAStepIsDone();
  void whoLooksElsewhereStaysThere();
  void hintsOnDemand();
  void stepsByHand();
  void time();
  void textsAreNotMarkup();
  void empty();
  void pictures();
};

void LessonPanelTest::goesOnWhenAStepIsDone() {
  LessonBench bench;
  QSignalSpy shown(&bench.panel, &LessonPanel::stepShown);
  QCOMPARE(bench.panel.shownStep(), 0);
  QCOMPARE(bench.text("lessonTitle"), QString("Your first shoulder"));
  QCOMPARE(bench.text("lessonProgress"), QString("0 of 4 steps"));
  bench.panel.setStepState(0, State::Done);
  QCOMPARE(bench.panel.shownStep(), 1);
  QVERIFY(bench.text("lessonText").startsWith("Turn the cross slide"));
  bench.panel.setStepState(2, State::Done);  // out of order
  QCOMPARE(bench.panel.shownStep(), 1);
  bench.panel.setStepState(1, State::Failed);
  QCOMPARE(bench.panel.shownStep(), 3);
  bench.panel.setStepState(3, State::Done);
  QCOMPARE(bench.panel.shownStep(), 3);
  QCOMPARE(bench.text("lessonProgress"), QString("4 of 4 steps"));
  bench.panel.setStepState(1, State::Open);  // undone
  QCOMPARE(bench.panel.shownStep(), 1);
  QCOMPARE(shown.size(), 3);
  const QVariant spoken = bench.part<QListWidget>("lessonSteps")->item(0)->data(Qt::AccessibleTextRole);
  QCOMPARE(spoken.toString(), QString("Clamp the bar, done"));
}

void LessonPanelTest::whoLooksElsewhereStaysThere() {
  LessonBench bench;
  bench.part<QListWidget>("lessonSteps")->setCurrentRow(2);
  QCOMPARE(bench.panel.shownStep(), 2);
  QVERIFY(bench.text("lessonText").startsWith("Turn to 30 mm"));
  bench.panel.setStepState(0, State::Done);
  QCOMPARE(bench.panel.shownStep(), 2);
  bench.panel.setStepState(99, State::Done);
  QCOMPARE(bench.panel.shownStep(), 2);
}

void LessonPanelTest::hintsOnDemand() {
  LessonBench bench;
  QSignalSpy hints(&bench.panel, &LessonPanel::hintShown);
  QVERIFY(!bench.panel.isHintShown() && bench.isSeen("lessonAskHint"));
  QTest::mouseClick(bench.part<QPushButton>("lessonAskHint"), Qt::LeftButton);
  QVERIFY(bench.panel.isHintShown() && !bench.isSeen("lessonAskHint"));
  QCOMPARE(bench.text("lessonHint"), QString("The chuck is in the panel Machine."));
  QCOMPARE(hints.size(), 1);
  bench.panel.setStepState(0, State::Done);
  QVERIFY(!bench.panel.isHintShown());
  bench.part<QListWidget>("lessonSteps")->setCurrentRow(0);
  QVERIFY(bench.panel.isHintShown());  // it was asked for
  bench.part<QListWidget>("lessonSteps")->setCurrentRow(3);
  QVERIFY(!bench.isSeen("lessonAskHint"));  // it has none
  QCOMPARE(hints.size(), 1);
  // Of two, one at a time.
  bench.part<QListWidget>("lessonSteps")->setCurrentRow(1);
  auto* ask = bench.part<QPushButton>("lessonAskHint");
  QTest::mouseClick(ask, Qt::LeftButton);
  QCOMPARE(bench.text("lessonHint"), QString("A double click on the dial sets it to zero."));
  QVERIFY(ask->isVisible());
  QTest::mouseClick(ask, Qt::LeftButton);
  QVERIFY(bench.text("lessonHint").endsWith("a tenth of a division.") && !ask->isVisible());
  QCOMPARE(hints.size(), 3);
  QCOMPARE(hints[1], QList<QVariant>({1, 1}));
  QCOMPARE(hints[2], QList<QVariant>({1, 2}));
  // Who goes on sees those again that were asked for.
  std::vector<LessonStep> again = shoulderSteps();
  again[0].shownHints = 5;
  bench.panel.setLesson("Goes on", again);
  QVERIFY(bench.panel.isHintShown() && !ask->isVisible());
  bench.panel.setLesson("Once more", shoulderSteps());
  QVERIFY(!bench.panel.isHintShown());
}

void LessonPanelTest::stepsByHand() {
  LessonBench bench;
  QSignalSpy done(&bench.panel, &LessonPanel::stepDone);
  QTest::mouseClick(bench.part<QPushButton>("lessonDone"), Qt::LeftButton);
  QCOMPARE(done.size(), 1);
  QCOMPARE(done[0][0].toInt(), 0);
  bench.panel.setStepState(0, State::Done);
  QVERIFY(!bench.isSeen("lessonDone"));  // of the next one the program finds out
}

void LessonPanelTest::time() {
  QCOMPARE(clockText(0.0), QString("0:00"));
  QCOMPARE(clockText(245.9), QString("4:05"));
  QCOMPARE(clockText(3599.0), QString("59:59"));
  QCOMPARE(clockText(3845.0), QString("1:04:05"));
  QCOMPARE(clockText(-5.0), QString("0:00"));
  QCOMPARE(clockText(1e300), QString("99:59:59"));
  QCOMPARE(clockText(std::numeric_limits<double>::quiet_NaN()), QString("0:00"));
  LessonBench bench;
  bench.panel.setTime(65.0, 0.0);
  QCOMPARE(bench.text("lessonTime"), QString("1:05"));
  bench.panel.setTime(65.0, 600.0);
  QCOMPARE(bench.text("lessonTime"), QString("1:05 of 10:00"));
  QVERIFY(!bench.part<QLabel>("lessonTime")->property("bad").toBool());
  bench.panel.setTime(601.0, 600.0);
  QVERIFY(bench.part<QLabel>("lessonTime")->property("bad").toBool());
  QVERIFY(bench.part<QLabel>("lessonTime")->accessibleName().startsWith("The time is over"));
}

// An exercise from anywhere shows no picture from the net.
void LessonPanelTest::textsAreNotMarkup() {
  LessonBench bench;
  bench.panel.setLesson("<h1>x</h1>", {{"a", "<img src='http://example.org/'>", {"<b>b</b>"}}});
  for (const char* name : {"lessonTitle", "lessonText", "lessonHint"}) {
    QCOMPARE(bench.part<QLabel>(name)->textFormat(), Qt::PlainText);
  }
}

void LessonPanelTest::empty() {
  LessonBench bench;
  bench.panel.setLesson({}, {});
  QCOMPARE(bench.panel.shownStep(), -1);
  QCOMPARE(bench.text("lessonProgress"), QString("No steps"));
  QVERIFY(!bench.isSeen("lessonDone") && !bench.isSeen("lessonAskHint") && !bench.isSeen("lessonText"));
  bench.panel.setStepState(0, State::Done);
}

void LessonPanelTest::pictures() {
  LessonBench bench;
  bench.panel.setStepState(0, State::Done);
  bench.panel.setTime(125.0, 180.0);
  lookAt(bench.panel, "lesson");
  QTest::mouseClick(bench.part<QPushButton>("lessonAskHint"), Qt::LeftButton);
  bench.panel.setTime(190.0, 180.0);
  lookAt(bench.panel, "lesson-hint");
}

HANDWHEEL_CONTROLS_TEST(LessonPanelTest)
#include "LessonPanelTest.moc"
