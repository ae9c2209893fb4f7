// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/PathMetrics.h"

#include "Scenes.h"
#include "TestClass.h"
#include "planning/PathVerification.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// An arm of two links of 500 mm, and a ball in its way at x = 800 mm.
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

// What is measured of paths, against formulas.
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
    // One place alone, and none.
    QCOMPARE(metricsOf(made.scene(), made.arm(), {a}).samples.size(), std::size_t{1});
    QVERIFY(metricsOf(made.scene(), made.arm(), {}).samples.empty());
  }

  // Past the ball twice: the verification does not stop at the first.
  void verificationListsAll() {
    const PlanarScene made;
    ArmValues a(2), b(2);
    a << -0.9, 0.0;
    b << 0.9, 0.0;
    const VerifiedPath result = verified(made.scene(), {a, b, a}, {});
    QVERIFY(!result.isCertified());
    QCOMPARE(result.certified.size(), std::size_t{2});
    QVERIFY(!result.certified[0] && !result.certified[1]);
    QVERIFY(result.collisions.size() >= 2);
    QCOMPARE(result.collisions.front().motion, std::size_t{0});
    QCOMPARE(result.collisions.back().motion, std::size_t{1});
    for (const PathCollision& each : result.collisions) {
      QVERIFY(each.from <= each.deepestAt && each.deepestAt <= each.to);
      const JointPath path{a, b, a};
      const ArmValues at = path[each.motion] + each.deepestAt * (path[each.motion + 1] - path[each.motion]);
      QVERIFY(made.scene().nearest(at, 1.0).distance <= 0.0);
    }
    const VerifiedPath free = verified(made.scene(), {a, a}, {});
    QVERIFY(free.isCertified() && free.collisions.empty());
  }
};

HANDWHEEL_TEST(PathMetricsTest)
#include "PathMetricsTest.moc"
