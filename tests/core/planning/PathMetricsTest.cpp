// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/PathMetrics.h"

#include "Scenes.h"
#include "TestClass.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// An arm of two links of 500 mm, and an obstructing ball at x = 800 mm.
class PlanarScene {
 public:
  PlanarScene() : m_robot(planarArm({500.0, 500.0}, 30.0)), m_scene(sceneOf(m_robot)) {
    addBall(m_scene, {800.0, 0.0, 0.0}, 100.0, 1);
  }
  const RobotScene& scene() const { return m_scene; }
  SerialArm arm() const {
    std::vector<DhRow> rows(2);
    rows[0].a = rows[1].a = 500.0;
    return armOf(rows);
  }

 private:
  RobotModel m_robot;
  RobotScene m_scene;
};

}  // namespace

// Tests the measurements of paths against formulas.
class PathMetricsTest : public QObject {
  Q_OBJECT

 private slots:
  // The example of the specification.
  void securityIsTheHarmonicMean() {
    const std::vector<double> clearances{1.0, 0.1, 1.1, 0.9, 1.2};
    QVERIFY(std::abs(securityIndex(clearances) - 0.36) < 5e-3);
    QCOMPARE(securityIndex(std::vector<double>{1.0, 0.0}), 0.0);
    QCOMPARE(securityIndex(std::vector<double>{1.0, -1.0}), 0.0);
    QCOMPARE(securityIndex({}), 0.0);
  }

  void manipulabilityOfTwoLinks() {
    std::vector<DhRow> rows(2);
    rows[0].a = 300.0;
    rows[1].a = 200.0;
    const SerialArm arm = armOf(rows);
    QVERIFY(rc::check("l1 l2 sin q2", [&] {
      ArmValues values(2);
      values << *rc::gen::inRange(-300, 301) / 100.0, *rc::gen::inRange(-300, 301) / 100.0;
      // √det(Jᵀ·J) with the rows of the turn, which are 1, in it: the columns are (−l1 s1 − l2 s12, l1 c1 + l2 c12, 1)
      // and (−l2 s12, l2 c12, 1).
      const double l1 = 0.6, l2 = 0.4, c = std::cos(values[1]);
      const double first = l1 * l1 + l2 * l2 + 2.0 * l1 * l2 * c + 1.0, second = l2 * l2 + 1.0,
                   both = l2 * l2 + l1 * l2 * c + 1.0;
      RC_ASSERT(std::abs(manipulabilityOf(arm, values, 500.0) - std::sqrt(first * second - both * both)) < 1e-9);
    }));
  }

  void ofAPath() {
    const PlanarScene made;
    ArmValues a(2), b(2);
    a << -1.5, 0.0;
    b << -0.5, 0.5;
    const PathMetrics metrics = metricsOf(made.scene(), made.arm(), {a, b});
    QVERIFY(std::abs(metrics.length - std::sqrt(1.25)) < 1e-12);
    QVERIFY(metrics.samples.size() >= 50);
    QCOMPARE(metrics.samples.front().at, 0.0);
    QVERIFY(std::abs(metrics.samples.back().at - 1.0) < 1e-12);
    for (const PathSample& sample : metrics.samples)
      QVERIFY(sample.clearance >= metrics.leastClearance && sample.limitMargin >= metrics.leastMargin);
    // The lowest clearance is at the point nearest to the ball, whose surface is at 700 mm; the rest by hand.
    for (const PathSample& sample : metrics.samples) {
      const ArmValues values = a + sample.share * (b - a);
      QVERIFY((values - sample.values).norm() < 1e-12);
      double clearance = 1e9;
      for (const double x :
           {60.0, 90.0, 120.0, 150.0, 180.0, 210.0, 240.0, 270.0, 300.0, 330.0, 360.0, 390.0, 420.0, 450.0, 480.0}) {
        const Eigen::Vector2d first(std::cos(values[0]), std::sin(values[0]));
        const Eigen::Vector2d second(std::cos(values.sum()), std::sin(values.sum()));
        for (const Eigen::Vector2d& centre : {Eigen::Vector2d(x * first), Eigen::Vector2d(500.0 * first + x * second)})
          clearance = std::min(clearance, (centre - Eigen::Vector2d(800.0, 0.0)).norm() - 130.0);
      }
      QVERIFY(std::abs(clearance - sample.clearance) < 1e-9);
      QVERIFY(std::abs(sample.limitMargin - (3.0 - values.cwiseAbs().maxCoeff()) / 6.0) < 1e-12);
    }
    // A single waypoint, and none.
    QCOMPARE(metricsOf(made.scene(), made.arm(), {a}).samples.size(), std::size_t{1});
    QVERIFY(metricsOf(made.scene(), made.arm(), {}).samples.empty());
  }
};

HANDWHEEL_TEST(PathMetricsTest)
#include "PathMetricsTest.moc"
