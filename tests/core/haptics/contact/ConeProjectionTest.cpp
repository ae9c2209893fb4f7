// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/contact/ConeProjection.h"

#include <rapidcheck.h>
#include <QtTest>

#include <vector>

using namespace handwheel;

namespace {

Vec3 someVector() {
  const auto number = rc::gen::map(rc::gen::inRange(-1000, 1001), [](int i) { return 0.001 * i; });
  return {*number, *number, *number};
}

// The same by another method: Hildreth's, which lets one plane after the other push, and converges to the nearest
// point.
Vec3 byHildreth(const Vec3& goal, const std::vector<HalfSpace>& planes) {
  std::vector<double> push(planes.size(), 0.0);
  Vec3 y = goal;
  for (int round = 0; round < 200'000; ++round) {
    double change = 0.0;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const double more = std::max(planes[i].least - planes[i].normal.dot(y), -push[i]);
      push[i] += more;
      y += more * planes[i].normal;
      change = std::max(change, std::abs(more));
    }
    if (change < 1e-13) break;
  }
  return y;
}

}  // namespace

class ConeProjectionTest : public QObject {
  Q_OBJECT

 private slots:
  void staysWherePlanesLeaveIt() {
    const std::vector<HalfSpace> floor{{Vec3::UnitZ(), 0.0}};
    QCOMPARE(nearestInCone({1.0, 2.0, 3.0}, {}, 0.0), Vec3(1.0, 2.0, 3.0));
    QCOMPARE(nearestInCone({1.0, 2.0, 3.0}, floor, 0.0), Vec3(1.0, 2.0, 3.0));
    QCOMPARE(nearestInCone({1.0, 2.0, -3.0}, floor, 0.0), Vec3(1.0, 2.0, 0.0));
  }

  // The corner of a room: only the walls that hold it count.
  void isPushedOutOfARoom() {
    const std::vector<HalfSpace> room{{Vec3::UnitX(), 0.0}, {Vec3::UnitY(), 0.0}, {Vec3::UnitZ(), 0.0}};
    QCOMPARE(nearestInCone({-1.0, -2.0, -3.0}, room, 0.0), Vec3(0.0, 0.0, 0.0));
    QCOMPARE(nearestInCone({-1.0, -2.0, 3.0}, room, 0.0), Vec3(0.0, 0.0, 3.0));
    QCOMPARE(nearestInCone({1.0, -2.0, 3.0}, room, 0.0), Vec3(1.0, 0.0, 3.0));
  }

  void isTheNearestPoint() {
    QVERIFY(rc::check([] {
      // All planes pass through the origin, so that a point fits.
      std::vector<HalfSpace> planes;
      const int count = *rc::gen::inRange(1, 9);
      for (int i = 0; i < count; ++i) {
        const Vec3 normal = someVector();
        RC_PRE(normal.norm() > 0.01);
        planes.push_back({normal.normalized(), -0.001 * *rc::gen::inRange(0, 100)});
      }
      const Vec3 goal = someVector();
      const Vec3 y = nearestInCone(goal, planes, 1e-9);
      for (const HalfSpace& plane : planes) RC_ASSERT(plane.normal.dot(y) >= plane.least - 1e-8);
      RC_ASSERT((y - goal).norm() <= (byHildreth(goal, planes) - goal).norm() + 1e-6);
    }));
  }

  // For nearly equal planes a sum of huge multipliers would lose every digit.
  void bearsPlanesThatAreNearlyParallel() {
    for (const double angle : {0.0, 1e-15, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3}) {
      const Vec3 tilted = Vec3(std::sin(angle), 0.0, std::cos(angle));
      const std::vector<HalfSpace> planes{{Vec3::UnitZ(), 0.0}, {tilted, 0.0}};
      const Vec3 y = nearestInCone({0.1, 0.2, -1.0}, planes, 1e-7);
      QVERIFY(y.allFinite());
      QVERIFY(y.z() >= -2e-7 && tilted.dot(y) >= -2e-7);
      QVERIFY(std::abs(y.y() - 0.2) < 1e-6);
    }
  }

  void missesLeastWhereNothingFits() {
    const std::vector<HalfSpace> slit{{Vec3::UnitZ(), 1.0}, {-Vec3::UnitZ(), 1.0}};
    QVERIFY(nearestInCone({0.5, 0.5, 0.0}, slit, 0.0).allFinite());
  }
};

HANDWHEEL_TEST(ConeProjectionTest)
#include "ConeProjectionTest.moc"
