// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "TurningExercises.h"
#include "document/exercise/ExerciseDocument.h"
#include "document/exercise/ExerciseProperties.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;
using Json = nlohmann::json;

namespace {

const ExerciseKind& kindOfThreads() {
  static const ExerciseKind kKind(turningOnly());
  return kKind;
}

// A bar of ⌀20 × 100 whose thread is marked between Z 72 and Z 98. withPitch: the pitch is marked, too.
ExerciseSnapshot threadToMark(const std::string& tolerance, bool withPitch) {
  Json description = shoulderDescription();
  description["task"]["diameter"] = 19.8;
  description["criteria"] = Json::array();
  description["steps"] = Json::array();
  const auto add = [&](const char* figure) {
    Json c = {{"id", figure}, {"name", figure}, {"figure", figure}, {"arguments", {72, 98}}};
    if (!tolerance.empty()) c["tolerance"] = tolerance, c["points"] = 10;
    description["criteria"].push_back(std::move(c));
  };
  if (withPitch) add("thread_pitch");
  for (const char* const figure : {"major_diameter", "pitch_diameter", "minor_diameter"}) add(figure);
  return *exerciseFrom(kindOfThreads(), description);
}

// A thread of this pitch, cut by a V of 60° with the nose of a pitch of 2.5 mm to the pitch diameter 18.25 mm. The V is
// half the pitch wide there: a height of P · √3/4 above its corner, which is one nose radius below the bottom.
Json threadOf(double pitch) {
  const double nose = 2.5 * std::sqrt(3.0) / 12.0, bottom = 18.25 / 2.0 - pitch * std::sqrt(3.0) / 4.0 + nose;
  return {{"passes",
           {{{"nose_radius", nose},
             {"feed", pitch},
             {"thread", {{"pitch", pitch}}},
             {"points", {{bottom + nose, 105.0}, {bottom + nose, 66.0}}}}}}};
}

const Mark& markOf(const Marking& marking, const char* figure) {
  return *marking.find(figure);
}

bool isNear(const std::optional<double>& value, double expected) {
  return value && std::abs(*value - expected) < 5e-4;
}

}  // namespace

// The tolerance class of a thread gives limits to its pitch and its three diameters.
class ThreadMarksTest : public QObject {
  Q_OBJECT

 private slots:
  // ISO 965-2: M20 × 2.5 - 6g has 19.623 … 19.958, 18.164 … 18.334, and 16.540 … 16.891 at the root. It is typed once.
  void oneClassForAllFigures() {
    const auto changed =
        withExerciseProperty(threadToMark({}, true), "criterion.pitch_diameter.tolerance", std::string("M20x2.5 - 6g"));
    QVERIFY(changed.hasValue());
    for (const MarkingCriterion& c : changed->exercise.criteria) QCOMPARE(c.tolerance, std::string("M20×2.5-6g"));
    const auto of = [&](const char* figure) { return *changed->exercise.find(figure); };
    QVERIFY(isNear(of("major_diameter").lower, 19.623) && isNear(of("major_diameter").upper, 19.958));
    QVERIFY(isNear(of("pitch_diameter").lower, 18.164) && isNear(of("pitch_diameter").upper, 18.334));
    QVERIFY(isNear(of("minor_diameter").lower, 16.540) && isNear(of("minor_diameter").upper, 16.891));
    QVERIFY(isNear(of("thread_pitch").nominal, 2.5) && of("thread_pitch").hasLimit());
    // A symmetric tolerance is that of one figure alone.
    const auto pitch = withExerciseProperty(*changed, "criterion.thread_pitch.tolerance", std::string("±0.02"));
    QVERIFY(pitch && isNear(pitch->exercise.find("thread_pitch")->upper, 2.52));
    QCOMPARE(pitch->exercise.find("major_diameter")->tolerance, std::string("M20×2.5-6g"));
    QVERIFY(!withExerciseProperty(*changed, "criterion.major_diameter.tolerance", std::string("M20-6k")));
    QVERIFY(!withExerciseProperty(*changed, "criterion.major_diameter.tolerance", std::string("h9")));
  }

  // A class alone is that of the coarse thread of the nominal size; without one it is refused.
  void aClassAlone() {
    const ExerciseSnapshot exercise = threadToMark({}, false);
    QVERIFY(!withExerciseProperty(exercise, "criterion.major_diameter.tolerance", std::string("6g")));
    auto sized = withExerciseProperty(exercise, "criterion.major_diameter.nominal", std::string("20"));
    QVERIFY(sized.hasValue());
    sized = withExerciseProperty(*sized, "criterion.major_diameter.tolerance", std::string("6g"));
    QVERIFY(sized.hasValue());
    QVERIFY(isNear(sized->exercise.find("pitch_diameter")->upper, 18.334));
  }

  // The right pitch diameter at another pitch is no thread that fits: it has no points, whether the pitch is marked or
  // only in the designation.
  void aWrongPitch() {
    for (const bool withPitch : {true, false}) {
      const ExerciseSnapshot exercise = threadToMark("M20×2.5-6g", withPitch);
      const Marking right = markWork(exercise, *workFrom(exercise, threadOf(2.5)), {});
      QVERIFY2(right.find("pitch_diameter")->verdict == Verdict::Met,
               right.find("pitch_diameter")->reason.inEnglish().c_str());
      const Marking wrong = markWork(exercise, *workFrom(exercise, threadOf(2.0)), {});
      const Mark& mark = markOf(wrong, "pitch_diameter");
      QVERIFY(mark.verdict == Verdict::NotMeasured && mark.points == 0.0);
      QCOMPARE(mark.remark.inEnglish(), std::string("the pitch of 2 mm is not that of the thread"));
      if (withPitch) QVERIFY(markOf(wrong, "thread_pitch").verdict == Verdict::TooSmall);
      QVERIFY(markOf(wrong, "minor_diameter").verdict != Verdict::NotMeasured);
    }
  }
};

HANDWHEEL_TEST(ThreadMarksTest)
#include "ThreadMarksTest.moc"
