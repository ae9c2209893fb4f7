// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "exercise/Exercise.h"

#include "TestClass.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

Exercise small() {
  Exercise exercise;
  MarkingCriterion diameter;
  diameter.id = "d1";
  diameter.lower = 19.9;
  diameter.upper = 20.0;
  diameter.points = 10.0;
  diameter.slack = 0.1;
  MarkingCriterion hidden = diameter;
  hidden.id = "force";
  hidden.isHidden = true;
  exercise.criteria = {diameter, hidden};
  exercise.steps = {{"Face", "Face the end", {"Touch off first"}, {"d1", "force"}}};
  return exercise;
}

bool isSound(const Exercise& exercise) {
  return checkExercise(exercise).hasValue();
}

}  // namespace

class ExerciseTest : public QObject {
  Q_OBJECT

 private slots:
  void aStudentGetsNoAnswers() {
    QVERIFY(isSound(small()) && !hasNoAnswers(small()));
    const Exercise without = withoutAnswers(small());
    QVERIFY(isSound(without) && hasNoAnswers(without));
    QCOMPARE(without.criteria.size(), std::size_t{1});
    QCOMPARE(without.points(), 0.0);
    QCOMPARE(without.criteria[0].lower.value(), 19.9);  // the drawing stays
    QCOMPARE(without.steps[0].criteria, std::vector<std::string>{"d1"});
    QCOMPARE(without.steps[0].hints.size(), std::size_t{1});
    QVERIFY(small().find("force") && !without.find("force"));
    QCOMPARE(small().points(), 20.0);
  }

  void whatAnExerciseMustNotHave() {
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf, 1e300, -1.0}) {
      Exercise e = small();
      e.criteria[0].points = bad;
      QVERIFY(!isSound(e));
      e = small();
      e.criteria[0].slack = bad;
      QVERIFY(!isSound(e));
      e = small();
      e.allowedSeconds = bad;
      QVERIFY(!isSound(e));
    }
    for (const double bad : {nan, inf, -inf, 1e300}) {
      Exercise e = small();
      e.criteria[0].upper = bad;
      QVERIFY(!isSound(e));
      e = small();
      e.criteria[0].arguments = {bad};
      QVERIFY(!isSound(e));
    }
    Exercise e = small();
    e.criteria[1].id = "d1";
    QVERIFY(!isSound(e));
    e = small();
    e.criteria[0].id.clear();
    QVERIFY(!isSound(e));
    e = small();
    e.criteria[0].lower = 21.0;
    QVERIFY(!isSound(e));
    e = small();
    e.steps[0].criteria = {"d2"};
    QVERIFY(!isSound(e));
    e = small();
    e.steps[0].text = std::string(Exercise::kLongestText + 1, 'x');
    QVERIFY(!isSound(e));
    e = small();
    e.steps.assign(Exercise::kMostSteps + 1, {});
    QVERIFY(!isSound(e));
    e = small();
    e.criteria[0].arguments.assign(Exercise::kMostArguments + 1, 0.0);
    QVERIFY(!isSound(e));
  }
};

HANDWHEEL_TEST(ExerciseTest)
#include "ExerciseTest.moc"
