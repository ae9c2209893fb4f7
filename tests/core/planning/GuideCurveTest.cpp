// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/GuideCurve.h"

#include "Scenes.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

// Tests curves to be followed by hand.
class GuideCurveTest : public QObject {
  Q_OBJECT

 private slots:
  // No point of the curve, of many that are tried, is nearer.
  void nearestPoint() {
    QVERIFY(rc::check("none is nearer", [] {
      std::vector<Vec3> points;
      const int count = *rc::gen::inRange(1, 12);
      for (int i = 0; i < count; ++i) points.emplace_back(evenly(-100, 100), evenly(-100, 100), evenly(-100, 100));
      const GuideCurve curve(points);
      const Vec3 from(evenly(-200, 200), evenly(-200, 200), evenly(-200, 200));
      const GuideCurve::Nearest found = curve.nearest(from);
      RC_ASSERT(std::abs((from - found.position).norm() - found.distance) < 1e-9);
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        for (int k = 0; k <= 20; ++k)
          RC_ASSERT((points[i] + k / 20.0 * (points[i + 1] - points[i]) - from).norm() >= found.distance - 1e-9);
      }
    }));
  }

  // On the curve a point stays; at the snap distance and beyond nothing happens; in between it comes nearer, without a
  // leap.
  void drawsToTheCurve() {
    const GuideCurve curve(std::vector<Vec3>{{0, 0, 0}, {100, 0, 0}});
    QCOMPARE(curve.drawn({40, 0, 0}, 10.0), Vec3(40, 0, 0));
    QCOMPARE(curve.drawn({40, 11, 0}, 10.0), Vec3(40, 11, 0));
    QVERIFY((curve.drawn({40, 9.999999, 0}, 10.0) - Vec3(40, 10, 0)).norm() < 1e-4);
    QVERIFY((curve.drawn({40, 5, 0}, 10.0) - Vec3(40, 10 * 0.5 * 0.5 * 0.5, 0)).norm() < 1e-12);
    QCOMPARE(curve.drawn({40, 5, 0}, 0.0), Vec3(40, 5, 0));
  }

  // A line followed at 10 mm/s with a sine beside it: its root mean square is the amplitude by the root of two.
  void figuresOfASine() {
    const GuideCurve curve(std::vector<Vec3>{{0, 0, 0}, {100, 0, 0}});
    FollowingTry following(curve);
    following.add(-1.0, {-500, 0, 0});  // not yet
    QVERIFY(!following.hasBegun());
    for (int i = 0; i <= 10'000; ++i) {
      const double x = 0.01 * i;
      following.add(0.1 * x, {x, 3.0 * std::sin(2.0 * M_PI * x / 10.0), 0});
    }
    following.add(20.0, {100, 80, 0});  // after the end
    const FollowingStatistics figures = following.figures();
    QVERIFY(figures.isComplete());
    QVERIFY2(std::abs(figures.rms - 3.0 / std::sqrt(2.0)) < 0.02, qPrintable(QString::number(figures.rms)));
    QVERIFY(std::abs(figures.most - 3.0) < 1e-3);
    QVERIFY(std::abs(figures.seconds - 9.9) < 0.01);  // it ends a hundredth before the end
  }

  // A closed curve is not at its end at once.
  void closedCurve() {
    std::vector<Vec3> points;
    for (int i = 0; i <= 100; ++i) points.emplace_back(std::cos(0.02 * M_PI * i), std::sin(0.02 * M_PI * i), 0.0);
    const GuideCurve curve(points);
    FollowingTry following(curve);
    for (int i = 0; i <= 50; ++i) following.add(i, points[static_cast<std::size_t>(i)]);
    QVERIFY(!following.isOver());
    QVERIFY(std::abs(following.figures().share - 0.5) < 1e-9);
    for (int i = 51; i <= 100; ++i) following.add(i, points[static_cast<std::size_t>(i)]);
    QVERIFY(following.isOver() && following.figures().most < 1e-9);
  }

  void whatIsNoCurve() {
    const GuideCurve none(std::span<const Vec3>{});
    QVERIFY(std::isinf(none.nearest(Vec3::Zero()).distance));
    QCOMPARE(none.drawn({1, 2, 3}, 10.0), Vec3(1, 2, 3));
    const GuideCurve point(std::vector<Vec3>{{1, 0, 0}, {1, 0, 0}, {std::nan(""), 0, 0}});
    QCOMPARE(point.nearest(Vec3::Zero()).distance, 1.0);
    FollowingTry following(point);
    following.add(0.0, {1, 0, 0});
    QVERIFY(!following.hasBegun());
  }
};

HANDWHEEL_TEST(GuideCurveTest)
#include "GuideCurveTest.moc"
