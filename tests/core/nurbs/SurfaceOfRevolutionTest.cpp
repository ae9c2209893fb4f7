// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nurbs/SurfaceOfRevolution.h"

#include "Profiles.h"
#include "TestClass.h"
#include "nurbs/StockCylinder.h"
#include "nurbs/UnitCircle.h"

#include <QTest>

using namespace handwheel;

class SurfaceOfRevolutionTest : public QObject {
  Q_OBJECT

 private slots:
  void circleIsExact();
  void isTheTensorProductOfItsNet();
  void derivativesAreLimitsOfDifferences();
  void normalOfASphere();
  void normalStandsOnBothDerivatives();
  void isStableOnTheAxis();
  void cylinderPointsOutwards();
};

namespace {

Vec3 pointByDefinition(const SurfaceNurbs& nurbs, double u, double v) {
  Vec3 sum = Vec3::Zero();
  double weights = 0.0;
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t j = 0; j < nurbs.poles[i].size(); ++j) {
      const double share = nurbs.weights[i][j] * test::basis(nurbs.circleKnots, i, 2, u) *
                           test::basis(nurbs.profileKnots, j, nurbs.profileDegree, v);
      sum += share * nurbs.poles[i][j];
      weights += share;
    }
  }
  return sum / weights;
}

SurfaceOfRevolution randomSurface() {
  return SurfaceOfRevolution(ProfileCurve::make(test::randomNurbs()).value());
}

}  // namespace

void SurfaceOfRevolutionTest::circleIsExact() {
  for (double radius : {1e-6, 25.0, 5e5}) {
    const SurfaceOfRevolution mantle(StockCylinder{2 * radius, 10, 0}.profile());
    for (int i = 0; i <= 1000; ++i) {
      const Vec3 p = mantle.at(i / 1000.0, 0.3).position;
      QVERIFY(std::abs(p.head<2>().norm() / radius - 1.0) < 1e-12);
      QCOMPARE(p.z(), 3.0);
    }
  }
}

void SurfaceOfRevolutionTest::isTheTensorProductOfItsNet() {
  QVERIFY(rc::check("by the definition", [] {
    const SurfaceOfRevolution s = randomSurface();
    const double u = test::between(0, 1), v = test::between(s.profile().from(), s.profile().to());
    RC_ASSERT((s.at(u, v).position - pointByDefinition(s.nurbs(), u, v)).norm() < 1e-11);
  }));
}

void SurfaceOfRevolutionTest::derivativesAreLimitsOfDifferences() {
  QVERIFY(rc::check("away from knots", [] {
    const SurfaceOfRevolution s = randomSurface();
    const double u = test::between(0, 1), v = test::between(s.profile().from(), s.profile().to()), h = 1e-5;
    for (double knot : s.profile().nurbs().knots) RC_PRE(std::abs(v - knot) > 2 * h);
    for (double knot : unit_circle::knots()) RC_PRE(std::abs(u - knot) > 2 * h);
    const Vec3 byU = (s.at(u + h, v).position - s.at(u - h, v).position) / (2 * h);
    const Vec3 byV = (s.at(u, v + h).position - s.at(u, v - h).position) / (2 * h);
    RC_ASSERT((s.at(u, v).byCircle - byU).norm() < 1e-5 * (1 + byU.norm()));
    RC_ASSERT((s.at(u, v).byProfile - byV).norm() <
              1e-3 * (1 + byV.norm()));  // the tolerance is that of the profile itself
  }));
}

void SurfaceOfRevolutionTest::normalOfASphere() {
  for (double centre : {0.0, 1e7}) {
    const SurfaceOfRevolution s(ProfileCurve::make(test::sphere(3.0, centre)).value());
    for (int i = 0; i <= 20; ++i) {
      for (int j = 0; j <= 20; ++j) {
        const RevolutionPoint p = s.at(i / 20.0, j / 10.0);
        const Vec3 outward = (p.position - Vec3(0, 0, centre)) / 3.0;
        QVERIFY((p.normal - outward).norm() < (centre == 0.0 ? 1e-13 : 1e-8));
      }
    }
  }
}

void SurfaceOfRevolutionTest::normalStandsOnBothDerivatives() {
  QVERIFY(rc::check("unit and perpendicular", [] {
    const SurfaceOfRevolution s = randomSurface();
    const RevolutionPoint p = s.at(test::between(0, 1), test::between(s.profile().from(), s.profile().to()));
    RC_PRE(p.byProfile.norm() > 1e-3);
    RC_ASSERT(std::abs(p.normal.norm() - 1.0) < 1e-13);
    RC_ASSERT(std::abs(p.normal.dot(p.byCircle)) < 1e-12 * (1 + p.byCircle.norm()));
    RC_ASSERT(std::abs(p.normal.dot(p.byProfile)) < 1e-12 * (1 + p.byProfile.norm()));
    if (p.byCircle.norm() > 1e-3) RC_ASSERT((p.byCircle.cross(p.byProfile).normalized() - p.normal).norm() < 1e-9);
  }));
}

void SurfaceOfRevolutionTest::isStableOnTheAxis() {
  const SurfaceOfRevolution cone(ProfileCurve::polyline({{3, 0}, {0, 4}}).value());
  for (double u : {0.0, 0.1, 0.6, 1.0}) {
    const RevolutionPoint tip = cone.at(u, 1.0), side = cone.at(u, 0.25);
    QCOMPARE(tip.position, Vec3(0, 0, 4));
    QCOMPARE(tip.byCircle.norm(), 0.0);
    QVERIFY((tip.normal - side.normal).norm() < 1e-15);
    QVERIFY(std::abs(tip.normal.z() - 0.6) < 1e-15);
  }
}

void SurfaceOfRevolutionTest::cylinderPointsOutwards() {
  const SurfaceOfRevolution mantle(StockCylinder{50, 100, -20}.profile());
  const RevolutionPoint p = mantle.at(0.25, 0.5);
  QVERIFY((p.position - Vec3(0, 25, 30)).norm() < 1e-13);
  QVERIFY((p.normal - Vec3(0, 1, 0)).norm() < 1e-15);
  QVERIFY((p.byProfile - Vec3(0, 0, 100)).norm() < 1e-12);
}

HANDWHEEL_TEST(SurfaceOfRevolutionTest)
#include "SurfaceOfRevolutionTest.moc"
