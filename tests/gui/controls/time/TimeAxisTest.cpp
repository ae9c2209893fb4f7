// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/time/TimeAxis.h"

#include "TestClass.h"

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// 10 mm in 4 s, a rest of 2 s, 10 mm more in 2 s.
const std::vector<QPointF> kWithRest{{0, 0}, {4, 10}, {6, 10}, {8, 20}};

TimeAxis axisOf(std::vector<TimeLineRecording> recordings, TimeAxis::Kind kind) {
  TimeAxis axis;
  axis.setRecordings(recordings);
  axis.setKind(kind);
  return axis;
}

}  // namespace

class TimeAxisTest : public QObject {
  Q_OBJECT

 private slots:
  void time();
  void distance();
  void distanceThereAndBack();
  void distanceOnlyWhereAllHaveOne();
  void hostileDistances();
  void thinnedCurvesKeepPeaks();
};

void TimeAxisTest::time() {
  const TimeAxis axis = axisOf({{"a", 8.0, {}, {}, kWithRest}, {"b", 12.0, {}, {}, {}}}, TimeAxis::Kind::Time);
  QCOMPARE(axis.length(), 12.0);
  QCOMPARE(axis.length(0), 8.0);
  QCOMPARE(axis.timeAt(0, 9.5), 8.0);  // it has ended
  QCOMPARE(axis.timeAt(1, 9.5), 9.5);
  QCOMPARE(axis.positionAt(1, 9.5), 9.5);
  QCOMPARE(axis.timeAt(1, -1.0), 0.0);
}

void TimeAxisTest::distance() {
  const TimeAxis axis =
      axisOf({{"a", 8.0, {}, {}, kWithRest}, {"b", 30.0, {}, {}, {{0, 5}, {30, 35}}}}, TimeAxis::Kind::Distance);
  QCOMPARE(axis.length(), 30.0);
  QCOMPARE(axis.length(0), 20.0);
  QCOMPARE(axis.timeAt(0, 5.0), 2.0);
  QCOMPARE(axis.timeAt(0, 10.0), 4.0);  // time of arrival, before the rest
  QCOMPARE(axis.timeAt(0, 15.0), 7.0);
  QCOMPARE(axis.timeAt(0, 25.0), 8.0);
  QCOMPARE(axis.positionAt(0, 5.0), 10.0);
  QCOMPARE(axis.timeAt(1, 15.0), 15.0);  // distances count from their beginnings
  QCOMPARE(axis.positionAt(1, 30.0), 30.0);
  QCOMPARE(axis.positionAt(0, -3.0), 0.0);
}

void TimeAxisTest::distanceThereAndBack() {
  QVERIFY(rc::check("a position's time has that position", [] {
    std::vector<QPointF> points{{0, 0}};
    for (int i = *rc::gen::inRange(1, 50); i > 0; --i) {
      points.emplace_back(points.back().x() + *rc::gen::inRange(1, 100) * 0.01,
                          points.back().y() + *rc::gen::inRange(0, 100) * 0.01);
    }
    points.emplace_back(points.back().x() + 1.0, points.back().y() + 1.0);
    const TimeAxis axis = axisOf({{"a", points.back().x(), {}, {}, points}}, TimeAxis::Kind::Distance);
    const double position = *rc::gen::inRange(0, 1001) * 1e-3 * axis.length();
    RC_ASSERT(std::abs(axis.positionAt(0, axis.timeAt(0, position)) - position) < 1e-9);
  }));
}

void TimeAxisTest::distanceOnlyWhereAllHaveOne() {
  TimeAxis axis = axisOf({{"a", 8.0, {}, {}, kWithRest}, {"b", 12.0, {}, {}, {}}}, TimeAxis::Kind::Distance);
  QVERIFY(!axis.hasDistance() && axis.kind() == TimeAxis::Kind::Time);
  axis = axisOf({{"a", 8.0, {}, {}, {{0, 3}, {8, 3}}}}, TimeAxis::Kind::Distance);
  QVERIFY(!axis.hasDistance());  // it did not move
  axis = axisOf({}, TimeAxis::Kind::Distance);
  QCOMPARE(axis.length(), 0.0);
  axis = axisOf({{"a", 8.0, {}, {}, kWithRest}}, TimeAxis::Kind::Distance);
  QVERIFY(axis.kind() == TimeAxis::Kind::Distance);
  axis.setRecordings({{"b", 1.0, {}, {}, {}}});
  QVERIFY(axis.kind() == TimeAxis::Kind::Time);
}

void TimeAxisTest::hostileDistances() {
  const std::vector<QPointF> wild{{0, 0},         {kNoNumber, 1}, {1, 1},    {0.5, 2}, {2, 0.5},
                                  {3, kNoNumber}, {3, 4},         {99, 100}, {-1, 9}};
  const TimeAxis axis = axisOf({{"a", 4.0, {}, {}, wild}}, TimeAxis::Kind::Distance);
  QCOMPARE(axis.length(), 4.0);  // (0, 0), (1, 1), (3, 4)
  QCOMPARE(axis.timeAt(0, 2.5), 2.0);
  QCOMPARE(axisOf({{"a", kNoNumber, {}, {}, {}}}, TimeAxis::Kind::Time).length(), 0.0);
  QCOMPARE(axisOf({{"a", -5.0, {}, {}, {}}}, TimeAxis::Kind::Time).length(), 0.0);
}

void TimeAxisTest::thinnedCurvesKeepPeaks() {
  std::vector<QPointF> points;
  for (int i = 0; i < 100000; ++i) points.emplace_back(i, std::sin(1e-4 * i));
  points[54321].setY(99.0);
  points[7].setY(-99.0);
  points[20].setY(kNoNumber);
  const std::vector<QPointF> thin = thinnedCurve(points, 1000);
  QVERIFY(thin.size() <= 1000 && thin.size() > 400);
  QVERIFY(std::count(thin.begin(), thin.end(), QPointF(54321, 99)) == 1);
  QVERIFY(std::count(thin.begin(), thin.end(), QPointF(7, -99)) == 1);
  QCOMPARE(thin.front(), points.front());
  QCOMPARE(thin.back(), points.back());
  QVERIFY(std::is_sorted(thin.begin(), thin.end(), [](auto& a, auto& b) { return a.x() < b.x(); }));
  QCOMPARE(thinnedCurve({{0, 1}, {1, kNoNumber}, {2, 3}}, 1000), (std::vector<QPointF>{{0, 1}, {2, 3}}));
  QCOMPARE(thinnedCurve({}, 10), std::vector<QPointF>());
}

HANDWHEEL_TEST(TimeAxisTest)
#include "TimeAxisTest.moc"
