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

struct LessonFixture {
  LessonFixture() {
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
  LessonFixture fixture;
  QSignalSpy shown(&fixture.panel, &LessonPanel::stepShown);
  QCOMPARE(fixture.panel.shownStep(), 0);
  QCOMPARE(fixture.text("lessonTitle"), QString("Your first shoulder"));
  QCOMPARE(fixture.text("lessonProgress"), QString("0 of 4 steps"));
  fixture.panel.setStepState(0, State::Done);
  QCOMPARE(fixture.panel.shownStep(), 1);
  QVERIFY(fixture.text("lessonText").startsWith("Turn the cross slide"));
  fixture.panel.setStepState(2, State::Done);  // out of order
  QCOMPARE(fixture.panel.shownStep(), 1);
  fixture.panel.setStepState(1, State::Failed);
  QCOMPARE(fixture.panel.shownStep(), 3);
  fixture.panel.setStepState(3, State::Done);
  QCOMPARE(fixture.panel.shownStep(), 3);
  QCOMPARE(fixture.text("lessonProgress"), QString("4 of 4 steps"));
  fixture.panel.setStepState(1, State::Open);  // undone
  QCOMPARE(fixture.panel.shownStep(), 1);
  QCOMPARE(shown.size(), 3);
  const QVariant spoken = fixture.part<QListWidget>("lessonSteps")->item(0)->data(Qt::AccessibleTextRole);
  QCOMPARE(spoken.toString(), QString("Clamp the bar, done"));
}

void LessonPanelTest::whoLooksElsewhereStaysThere() {
  LessonFixture fixture;
  fixture.part<QListWidget>("lessonSteps")->setCurrentRow(2);
  QCOMPARE(fixture.panel.shownStep(), 2);
  QVERIFY(fixture.text("lessonText").startsWith("Turn to 30 mm"));
  fixture.panel.setStepState(0, State::Done);
  QCOMPARE(fixture.panel.shownStep(), 2);
  fixture.panel.setStepState(99, State::Done);
  QCOMPARE(fixture.panel.shownStep(), 2);
}

void LessonPanelTest::hintsOnDemand() {
  LessonFixture fixture;
  QSignalSpy hints(&fixture.panel, &LessonPanel::hintShown);
  QVERIFY(!fixture.panel.isHintShown() && fixture.isSeen("lessonAskHint"));
  QTest::mouseClick(fixture.part<QPushButton>("lessonAskHint"), Qt::LeftButton);
  QVERIFY(fixture.panel.isHintShown() && !fixture.isSeen("lessonAskHint"));
  QCOMPARE(fixture.text("lessonHint"), QString("The chuck is in the panel Machine."));
  QCOMPARE(hints.size(), 1);
  fixture.panel.setStepState(0, State::Done);
  QVERIFY(!fixture.panel.isHintShown());
  fixture.part<QListWidget>("lessonSteps")->setCurrentRow(0);
  QVERIFY(fixture.panel.isHintShown());  // it was asked for
  fixture.part<QListWidget>("lessonSteps")->setCurrentRow(3);
  QVERIFY(!fixture.isSeen("lessonAskHint"));  // it has none
  QCOMPARE(hints.size(), 1);
  // Two hints, one at a time.
  fixture.part<QListWidget>("lessonSteps")->setCurrentRow(1);
  auto* ask = fixture.part<QPushButton>("lessonAskHint");
  QTest::mouseClick(ask, Qt::LeftButton);
  QCOMPARE(fixture.text("lessonHint"), QString("A double click on the dial sets it to zero."));
  QVERIFY(ask->isVisible());
  QTest::mouseClick(ask, Qt::LeftButton);
  QVERIFY(fixture.text("lessonHint").endsWith("a tenth of a division.") && !ask->isVisible());
  QCOMPARE(hints.size(), 3);
  QCOMPARE(hints[1], QList<QVariant>({1, 1}));
  QCOMPARE(hints[2], QList<QVariant>({1, 2}));
  // A continued lesson shows the hints again that were requested.
  std::vector<LessonStep> again = shoulderSteps();
  again[0].shownHints = 5;
  fixture.panel.setLesson("Goes on", again);
  QVERIFY(fixture.panel.isHintShown() && !ask->isVisible());
  fixture.panel.setLesson("Once more", shoulderSteps());
  QVERIFY(!fixture.panel.isHintShown());
}

void LessonPanelTest::stepsByHand() {
  LessonFixture fixture;
  QSignalSpy done(&fixture.panel, &LessonPanel::stepDone);
  QTest::mouseClick(fixture.part<QPushButton>("lessonDone"), Qt::LeftButton);
  QCOMPARE(done.size(), 1);
  QCOMPARE(done[0][0].toInt(), 0);
  fixture.panel.setStepState(0, State::Done);
  QVERIFY(!fixture.isSeen("lessonDone"));  // the program finds out about the next one
}

void LessonPanelTest::time() {
  QCOMPARE(clockText(0.0), QString("0:00"));
  QCOMPARE(clockText(245.9), QString("4:05"));
  QCOMPARE(clockText(3599.0), QString("59:59"));
  QCOMPARE(clockText(3845.0), QString("1:04:05"));
  QCOMPARE(clockText(-5.0), QString("0:00"));
  QCOMPARE(clockText(1e300), QString("99:59:59"));
  QCOMPARE(clockText(std::numeric_limits<double>::quiet_NaN()), QString("0:00"));
  LessonFixture fixture;
  fixture.panel.setTime(65.0, 0.0);
  QCOMPARE(fixture.text("lessonTime"), QString("1:05"));
  fixture.panel.setTime(65.0, 600.0);
  QCOMPARE(fixture.text("lessonTime"), QString("1:05 of 10:00"));
  QVERIFY(!fixture.part<QLabel>("lessonTime")->property("bad").toBool());
  fixture.panel.setTime(601.0, 600.0);
  QVERIFY(fixture.part<QLabel>("lessonTime")->property("bad").toBool());
  QVERIFY(fixture.part<QLabel>("lessonTime")->accessibleName().startsWith("The time is over"));
}

// An exercise from anywhere shows no picture from the net.
void LessonPanelTest::textsAreNotMarkup() {
  LessonFixture fixture;
  fixture.panel.setLesson("<h1>x</h1>", {{"a", "<img src='http://example.org/'>", {"<b>b</b>"}}});
  for (const char* name : {"lessonTitle", "lessonText", "lessonHint"}) {
    QCOMPARE(fixture.part<QLabel>(name)->textFormat(), Qt::PlainText);
  }
}

void LessonPanelTest::empty() {
  LessonFixture fixture;
  fixture.panel.setLesson({}, {});
  QCOMPARE(fixture.panel.shownStep(), -1);
  QCOMPARE(fixture.text("lessonProgress"), QString("No steps"));
  QVERIFY(!fixture.isSeen("lessonDone") && !fixture.isSeen("lessonAskHint") && !fixture.isSeen("lessonText"));
  fixture.panel.setStepState(0, State::Done);
}

void LessonPanelTest::pictures() {
  LessonFixture fixture;
  fixture.panel.setStepState(0, State::Done);
  fixture.panel.setTime(125.0, 180.0);
  lookAt(fixture.panel, "lesson");
  QTest::mouseClick(fixture.part<QPushButton>("lessonAskHint"), Qt::LeftButton);
  fixture.panel.setTime(190.0, 180.0);
  lookAt(fixture.panel, "lesson-hint");
}

HANDWHEEL_CONTROLS_TEST(LessonPanelTest)
#include "LessonPanelTest.moc"
