// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "HierarchyQueries.h"
#include "TestClass.h"
#include "proximity/ClosestPoint.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

Vec3 anyDirection() {
  Vec3 d = anyPoint(-1, 1);
  for (int k = 0; k < 3; ++k)
    if (*rc::gen::inRange(0, 4) == 0) d[k] = 0;
  return d.isZero() ? Vec3(0, 0, -1) : d;
}

}  // namespace

class TriangleHierarchyRayTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { qputenv("RC_PARAMS", qgetenv("RC_PARAMS") + " max_success=300"); }
  void firstHitAgainstBruteForce();
  void whatIsHitIsWhereTheRayIs();
  void firstHitInTheMiddleOfATriangle();
  void firstHitKnown_data();
  void firstHitKnown();
  void noRaySlipsThrough_data();
  void noRaySlipsThrough();
  void alongTheAxesOfAGrid();
  void distanceIsInLengthsOfTheDirection();
};

void TriangleHierarchyRayTest::firstHitAgainstBruteForce() {
  QVERIFY(rc::check([] {
    const Placed soup = anySoup();
    const TriangleHierarchy h = hierarchyOf(soup.surface);
    for (int i = 0; i < 20; ++i) {
      // From 1e14 the origin's own rounding is wider than a triangle; from 0 ties at the distance 0 occur.
      const double reach = *rc::gen::element(0.0, 1.0, 10.0, 1e7, 1e14);
      const Vec3 target = *rc::gen::arbitrary<bool>() ? soup(anyPoint(0, 1)) : soup.anyCorner();
      const Vec3 direction = anyDirection() * soup.scale;
      const Vec3 origin = target - reach * direction;
      const auto expected = bruteFirstHit(soup.surface, origin, direction);
      const auto hit = h.firstHit(origin, direction);
      RC_ASSERT(hit.has_value() == expected.has_value());
      if (!hit) continue;
      // The lengths are only scaled by powers of two, so they agree to the last bit.
      RC_ASSERT(hit->distance == expected->distance);
      RC_ASSERT(hit->triangle == expected->triangle);
    }
  }));
}

// On grids many triangles are seen so nearly edge-on that their areas are all rounding. The ray goes along an axis
// through each corner in turn.
void TriangleHierarchyRayTest::whatIsHitIsWhereTheRayIs() {
  QVERIFY(rc::check([] {
    const double scale = *rc::gen::element(1.0, 1e-6, 1e7);
    const Surface s = moved(soup(100, 0.1, 16, *rc::gen::arbitrary<std::uint32_t>()), scale, Vec3::Zero());
    const Vec3 axis = Vec3::Unit(*rc::gen::inRange(0, 3));
    const double reach = *rc::gen::element(0.0, 1.0, 10.0) * scale;
    for (const Vec3& target : s.points) {
      const Vec3 origin = target - reach * axis;
      const auto hit = bruteFirstHit(s, origin, axis);
      if (!hit) continue;
      const auto t = s.corners(hit->triangle);
      const Box box = Box(t[0]).extend(t[1]).extend(t[2]);
      RC_ASSERT(box.exteriorDistance(origin + hit->distance * axis) <= 1e-13 * (scale + reach));
    }
  }));
}

// Through a point known to lie within a triangle: that triangle or one before it.
void TriangleHierarchyRayTest::firstHitInTheMiddleOfATriangle() {
  QVERIFY(rc::check([] {
    const Surface s = soup(100, 0.2, 0, *rc::gen::arbitrary<std::uint32_t>());
    const TriangleHierarchy h = hierarchyOf(s);
    const auto t = s.corners(*rc::gen::inRange<std::size_t>(0, 100));
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const Vec3 direction = anyDirection();
    RC_PRE(std::abs(normal.dot(direction)) > 1e-6);
    const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
    const auto hit = h.firstHit(middle - 3.0 * direction, direction);
    RC_ASSERT(hit.has_value());
    RC_ASSERT(hit->distance <= 3.0 + 1e-9);
    // The hit point lies on the ray.
    const auto met = s.corners(hit->triangle);
    const Vec3 at = middle + (hit->distance - 3.0) * direction;
    RC_ASSERT((closestOnTriangle(at, met[0], met[1], met[2]) - at).norm() < 1e-9);
  }));
}

void TriangleHierarchyRayTest::firstHitKnown_data() {
  QTest::addColumn<QList<double>>("ray");
  QTest::addColumn<double>("distance");  // negative: none
  // The triangle is (0,0,0) (4,0,0) (0,4,0).
  QTest::newRow("from above") << QList<double>{1, 1, 5, 0, 0, -1} << 5.0;
  QTest::newRow("from below") << QList<double>{1, 1, -5, 0, 0, 1} << 5.0;
  QTest::newRow("slanted") << QList<double>{3, 1, 2, -1, 0, -1} << 2.0;
  QTest::newRow("from the surface") << QList<double>{1, 1, 0, 0, 0, 1} << 0.0;
  QTest::newRow("behind") << QList<double>{1, 1, 5, 0, 0, 1} << -1.0;
  QTest::newRow("beside") << QList<double>{3, 3, 5, 0, 0, -1} << -1.0;
  QTest::newRow("through an edge") << QList<double>{2, 2, 5, 0, 0, -1} << 5.0;
  QTest::newRow("through a corner") << QList<double>{0, 4, 5, 0, 0, -1} << 5.0;
  QTest::newRow("parallel above") << QList<double>{-1, 1, 1, 1, 0, 0} << -1.0;
  QTest::newRow("within the plane") << QList<double>{-1, 1, 0, 1, 0, 0} << -1.0;
  QTest::newRow("negative zeros") << QList<double>{1, 1, 5, -0.0, -0.0, -1} << 5.0;
  QTest::newRow("long direction") << QList<double>{1, 1, 5, 0, 0, -1e200} << 5e-200;
  QTest::newRow("short direction") << QList<double>{1, 1, 5, 0, 0, -1e-200} << 5e200;
}

void TriangleHierarchyRayTest::firstHitKnown() {
  QFETCH(QList<double>, ray);
  QFETCH(double, distance);
  const TriangleHierarchy h = hierarchyOf({{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)}, {{0, 1, 2}}});
  const auto hit = h.firstHit(Vec3(ray[0], ray[1], ray[2]), Vec3(ray[3], ray[4], ray[5]));
  QCOMPARE(hit.has_value(), distance >= 0.0);
  if (hit) QCOMPARE(hit->distance, distance);
}

void TriangleHierarchyRayTest::noRaySlipsThrough_data() {
  QTest::addColumn<double>("radius");
  QTest::addColumn<double>("from");  // origin's distance from the centre, in radii; 0: from inside
  QTest::addColumn<double>("shift");
  QTest::newRow("from inside") << 1.0 << 0.0 << 0.0;
  QTest::newRow("from inside, far from the origin") << 1.0 << 0.0 << 1e7;
  QTest::newRow("from inside, tiny") << 1e-6 << 0.0 << 0.0;
  QTest::newRow("from outside") << 1.0 << 5.0 << 0.0;
  QTest::newRow("from far away") << 1.0 << 1e7 << 0.0;
  QTest::newRow("tiny, from far away") << 1e-6 << 1e12 << 0.0;
  QTest::newRow("far from the origin, from far away") << 1.0 << 1e13 << 1e7;
}

// Rays aimed at the vertices and at the middles of the edges of a closed surface.
void TriangleHierarchyRayTest::noRaySlipsThrough() {
  QFETCH(double, radius);
  QFETCH(double, from);
  QFETCH(double, shift);
  const Vec3 centre(shift, -shift, shift);
  const Surface s = sphere(20, centre, radius);
  const TriangleHierarchy h = hierarchyOf(s);
  const auto check = [&](const Vec3& target) {
    const Vec3 outward = (target - centre).normalized();
    const Vec3 origin =
        from == 0.0 ? Vec3(centre + 0.1 * radius * Vec3(0.3, 0.2, 0.1)) : Vec3(centre + from * radius * outward);
    return h.firstHit(origin, target - origin).has_value();
  };
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    const auto t = s.corners(i);
    for (std::size_t k = 0; k < 3; ++k) {
      QVERIFY(check(t[k]));
      QVERIFY(check(0.5 * (t[k] + t[(k + 1) % 3])));
      QVERIFY(check(t[k] + (1.0 / 3.0) * (t[(k + 1) % 3] - t[k])));
    }
  }
}

// Axis-parallel rays exactly through the edges, the corners and the box sides of a flat grid.
void TriangleHierarchyRayTest::alongTheAxesOfAGrid() {
  constexpr int n = 16;
  for (int axis = 0; axis < 3; ++axis) {
    Surface s;
    const auto pointAt = [&](double u, double v, double w) {
      Vec3 p;
      p[(axis + 1) % 3] = u;
      p[(axis + 2) % 3] = v;
      p[axis] = w;
      return p;
    };
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) s.points.push_back(pointAt(i, j, 0));
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
        s.triangles.push_back({a, b, b + 1});
        s.triangles.push_back({a, b + 1, a + 1});
      }
    const TriangleHierarchy h = hierarchyOf(s);
    for (int i = 0; i <= 2 * n; ++i)
      for (int j = 0; j <= 2 * n; ++j)
        for (const double side : {7.0, -7.0}) {
          const auto hit = h.firstHit(pointAt(i / 2.0, j / 2.0, side), pointAt(0, 0, -side));
          QVERIFY(hit.has_value());
          QCOMPARE(hit->distance, 1.0);
        }
    QVERIFY(!h.firstHit(pointAt(-0.001, 1, 7), pointAt(0, 0, -1)));
    QVERIFY(!h.firstHit(pointAt(1, n + 0.001, 7), pointAt(0, 0, -1)));
  }
}

void TriangleHierarchyRayTest::distanceIsInLengthsOfTheDirection() {
  const TriangleHierarchy h = hierarchyOf(sphere(4));
  QCOMPARE(h.firstHit(Vec3(5, 0, 0), Vec3(-2, 0, 0))->distance, 2.0);
  QCOMPARE(h.firstHit(Vec3(0, 0, 0), Vec3(0, 0.125, 0))->distance, 8.0);
}

HANDWHEEL_TEST(TriangleHierarchyRayTest)
#include "TriangleHierarchyRayTest.moc"
