// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "exercise/Marking.h"

#include "TestClass.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

using namespace handwheel;

namespace {

MarkingCriterion within(double lower, double upper, double points, double slack) {
  MarkingCriterion c;
  c.id = "d1";
  c.lower = lower;
  c.upper = upper;
  c.points = points;
  c.slack = slack;
  return c;
}

Exercise only(const MarkingCriterion& criterion) {
  Exercise exercise;
  exercise.criteria = {criterion};
  return exercise;
}

Mark markOf(const MarkingCriterion& criterion, std::optional<double> value) {
  return markMeasurements(only(criterion), {{"d1", value, {}}}, {"mm"}).marks[0];
}

double hundredth(int low, int high) {
  return *rc::gen::inRange(100 * low, 100 * high) / 100.0;
}

}  // namespace

class MarkingTest : public QObject {
  Q_OBJECT

 private slots:
  // A failure in an undone try costs only its own points, even for a decisive criterion.
  void earlierTry() {
    Exercise exercise = only(within(0.0, 1.0, 5.0, 0.0));
    exercise.criteria[0].isDecisive = true;
    MarkingCriterion other = within(0.0, 1.0, 3.0, 0.0);
    other.id = "d2";
    exercise.criteria.push_back(other);
    const Marking marking = markMeasurements(exercise, {{"d1", 1.5, {}, true}, {"d2", 0.5, {}}}, {});
    QVERIFY(marking.marks[0].verdict == Verdict::TooLarge);
    QCOMPARE(marking.marks[0].points, 0.0);
    QCOMPARE(marking.points, 3.0);
    QCOMPARE(marking.of, 8.0);
  }

  // A decisive criterion that is not met, or not measured, takes all points, also its own share.
  void decisiveCriterion() {
    Exercise exercise = only(within(0.0, 1.0, 5.0, 2.0));
    exercise.criteria[0].isDecisive = true;
    exercise.criteria[0].name = "Safe";
    MarkingCriterion other = within(0.0, 1.0, 3.0, 0.0);
    other.id = "d2";
    exercise.criteria.push_back(other);
    QCOMPARE(markMeasurements(exercise, {{"d1", 0.5, {}}, {"d2", 0.5, {}}}, {}).points, 8.0);
    const Marking failed = markMeasurements(exercise, {{"d1", 1.5, {}}, {"d2", 0.5, {}}}, {});
    QCOMPARE(failed.points, 0.0);
    QCOMPARE(failed.of, 8.0);
    QVERIFY(failed.marks[1].verdict == Verdict::Met && failed.marks[1].points == 0.0);
    QCOMPARE(failed.marks[1].reason.inEnglish(), std::string("no points, because “Safe” was not met"));
    QCOMPARE(markMeasurements(exercise, {{"d2", 0.5, {}}}, {}).points, 0.0);
  }

  void theReasonOfEachMark() {
    const MarkingCriterion c = within(19.9, 20.0, 10.0, 0.2);
    QCOMPARE(markOf(c, 19.95).points, 10.0);
    QCOMPARE(markOf(c, 19.95).reason.inEnglish(), std::string("19.95 mm is within 19.9 and 20 mm"));
    const Mark small = markOf(c, 19.85);
    QVERIFY(small.verdict == Verdict::TooSmall);
    QCOMPARE(small.points, 7.5);
    QCOMPARE(small.reason.inEnglish(), std::string("19.85 mm is 0.05 mm below the lower limit, 19.9 mm"));
    const Mark large = markOf(c, 20.3);
    QVERIFY(large.verdict == Verdict::TooLarge);
    QCOMPARE(large.points, 0.0);
    QCOMPARE(large.reason.inEnglish(), std::string("20.3 mm is 0.3 mm above the upper limit, 20 mm"));
    const Mark none = markOf(c, std::nullopt);
    QVERIFY(none.verdict == Verdict::NotMeasured && none.points == 0.0 && !none.reason.inEnglish().empty());
    for (const double odd : {std::nan(""), std::numeric_limits<double>::infinity()})
      QVERIFY(markOf(c, odd).verdict == Verdict::NotMeasured);
    MarkingCriterion none1 = c;
    none1.lower.reset();
    QCOMPARE(markOf(none1, 3.0).reason.inEnglish(), std::string("3 mm is not above 20 mm"));
    none1.upper.reset();
    const Mark unlimited = markOf(none1, 3.0);
    QVERIFY(unlimited.verdict == Verdict::NotMeasured && unlimited.points == 0.0 && unlimited.value == 3.0);
    QCOMPARE(unlimited.reason.inEnglish(), std::string("the marking scheme has no limit for it"));
    none1.points = 0.0;  // the form of students
    QCOMPARE(markOf(none1, 3.0).reason.inEnglish(), std::string("3 mm, without a limit"));
    QCOMPARE((ExerciseText{"100%, %2 of %1 %3", {"a", "b"}}).inEnglish(), std::string("100%, b of a "));
  }

  // Figures have as many digits as are significant in the unit; a value below one step is not shown as zero.
  void figuresAreRounded() {
    for (const auto& [value, unit, text] :
         std::vector<std::tuple<double, const char*, const char*>>{{8.55162, "µm", "8.55"},
                                                                   {29.9490123, "mm", "29.949"},
                                                                   {99.99996, "mm", "100"},
                                                                   {-0.000042, "mm", "-0.00004"},
                                                                   {0.0, "mm", "0"},
                                                                   {1234.567, "N", "1235"},
                                                                   {72.8996, "N·mm", "73"},
                                                                   {0.3216, "N·mm", "0.3"},
                                                                   {17.9621, "K", "18"},
                                                                   {5.4321, "K", "5.4"},
                                                                   {1.23456, "kW", "1.23"},
                                                                   {2e-13, "mm", "0"},  // rounding of the computation
                                                                   {-3e-13, "mm", "0"},
                                                                   {44.98765, "°", "44.99"},
                                                                   {12.345, "s", "12.3"},
                                                                   {3.0, "", "3"}})
      QCOMPARE(measuredText(value, unit), std::string(text));
    MarkingCriterion c = within(0.0, 6.3, 1.0, 0.0);
    QCOMPARE(markMeasurements(only(c), {{"d1", 8.55162, {}}}, {"µm"}).marks[0].reason.inEnglish(),
             std::string("8.55 µm is 2.25 µm above the upper limit, 6.3 µm"));
  }

  // ISO 80000-1: a space before each unit, but none before the signs of a plane angle.
  void anglesHaveNoSpace() {
    const MarkingCriterion c = within(44.0, 46.0, 1.0, 0.0);
    const auto reason = [&](double value, const char* unit) {
      return markMeasurements(only(c), {{"d1", value, {}}}, {unit}).marks[0].reason.inEnglish();
    };
    QCOMPARE(reason(45.0, "°"), std::string("45° is within 44 and 46°"));
    // Limits of an angle follow from sizes: two decimals are shown.
    MarkingCriterion taper;
    taper.id = "t";
    taper.lower = 10.809932;
    taper.upper = 11.809932;
    Exercise angle;
    angle.criteria = {taper};
    QCOMPARE(markMeasurements(angle, {{"t", 11.309932, {}}}, {"°"}).marks[0].reason.inEnglish(),
             std::string("11.31° is within 10.81 and 11.81°"));
    QCOMPARE(reason(47.0, "°"), std::string("47° is 1° above the upper limit, 46°"));
    QCOMPARE(reason(45.0, "mm"), std::string("45 mm is within 44 and 46 mm"));
    QVERIFY(unitAfter("").empty() && unitAfter("°") == "°" && unitAfter("kW") == " kW");
  }

  // At the limit itself all points, without slack none beyond it.
  void limitsBelong() {
    const MarkingCriterion c = within(1.0, 2.0, 3.0, 0.0);
    QCOMPARE(markOf(c, 1.0).points, 3.0);
    QCOMPARE(markOf(c, 2.0).points, 3.0);
    QCOMPARE(markOf(c, 2.0 + 1e-12).points, 3.0);  // rounding
    QCOMPARE(markOf(c, 2.0 + 1e-6).points, 0.0);
  }

  void marksFollowTheScheme() {
    QVERIFY(rc::check("points fall from all to none over the slack", [] {
      const double lower = hundredth(-50, 50), width = hundredth(0, 20), slack = hundredth(1, 20);
      const MarkingCriterion c = within(lower, lower + width, hundredth(0, 100), slack);
      const double beyond = *rc::gen::inRange(-300, 301) / 100.0 * slack;
      const double value = (beyond < 0 ? lower : lower + width) + beyond;
      const double share = std::max(0.0, 1.0 - std::abs(beyond) / slack);
      const Mark mark = markOf(c, value);
      RC_ASSERT(std::abs(mark.points - c.points * share) <= 0.005 + 1e-9);
      RC_ASSERT(mark.points >= 0.0 && mark.points <= mark.of);
      RC_ASSERT((mark.verdict == Verdict::Met) == (beyond == 0.0));
    }));
    QVERIFY(rc::check("the sum is that of the marks as they are shown, and the same every time", [] {
      Exercise exercise;
      std::vector<Measurement> figures;
      const int count = *rc::gen::inRange(0, 30);
      for (int i = 0; i < count; ++i) {
        MarkingCriterion c = within(0.0, 1.0, hundredth(0, 20), 1.0);
        c.id = std::to_string(i);
        exercise.criteria.push_back(c);
        if (i % 3 != 0) figures.push_back({c.id, hundredth(-1, 3), {}});
      }
      const Marking marking = markMeasurements(exercise, figures), again = markMeasurements(exercise, figures);
      long sum = 0;
      for (const Mark& mark : marking.marks) sum += std::lround(100.0 * mark.points);
      RC_ASSERT(std::lround(100.0 * marking.points) == sum);
      RC_ASSERT(marking.points == again.points && marking.marks.size() == exercise.criteria.size());
      for (std::size_t i = 0; i < marking.marks.size(); i += 3)
        RC_ASSERT(marking.marks[i].verdict == Verdict::NotMeasured);
    }));
  }
};

HANDWHEEL_TEST(MarkingTest)
#include "MarkingTest.moc"
