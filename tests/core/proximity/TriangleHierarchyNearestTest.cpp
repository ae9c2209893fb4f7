// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "HierarchyQueries.h"
#include "TestClass.h"
#include "proximity/ClosestPoint.h"

#include <QTest>
#include <limits>
#include <numbers>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::optional<NearestPoint> bruteNearest(const Surface& s, const Vec3& p) {
  std::optional<NearestPoint> best;
  for (std::uint32_t i = 0; i < s.triangles.size(); ++i) {
    const auto t = s.corners(i);
    if (!usable(t)) continue;
    const Vec3 q = closestOnTriangle(p, t[0], t[1], t[2]);
    if (const double d = (q - p).squaredNorm(); !best || d < best->squaredDistance) best = NearestPoint{i, q, d};
  }
  return best;
}

}  // namespace

class TriangleHierarchyNearestTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { qputenv("RC_PARAMS", qgetenv("RC_PARAMS") + " max_success=300"); }
  void nearestAgainstBruteForce();
  void cutSliversAnswerAlike();
  void nearestOnASphere();
  void closestKnown_data();
  void closestKnown();
  void closestIsOptimal();
  void nearestKeepsToTheLimit();
};

void TriangleHierarchyNearestTest::nearestAgainstBruteForce() {
  QVERIFY(rc::check([] {
    const Placed soup = anySoup();
    const TriangleHierarchy h = hierarchyOf(soup.surface);
    for (int i = 0; i < 20; ++i) {
      const double reach = *rc::gen::element(0.0, 1.0, 10.0, 1e7, 1e14);
      const Vec3 p = reach > 0.0 ? soup(anyPoint(-reach, reach)) : soup.anyCorner();
      const auto expected = bruteNearest(soup.surface, p);
      const auto found = h.nearest(p);
      RC_ASSERT(found.has_value());
      RC_ASSERT(found->squaredDistance == expected->squaredDistance);
      RC_ASSERT(found->triangle == expected->triangle);
      RC_ASSERT(found->point == expected->point);
      const double distance = std::sqrt(expected->squaredDistance);
      RC_ASSERT(h.isWithin(p, distance * (1.0 + 1e-9) + 1e-100));
      RC_ASSERT(!h.isWithin(p, distance * (1.0 - 1e-9)));
    }
  }));
}

// Fans and needles in all directions, some without area: the pieces of a triangle are the triangle.
void TriangleHierarchyNearestTest::cutSliversAnswerAlike() {
  QVERIFY(rc::check([] {
    const double scale = *rc::gen::element(1.0, 1e-6, 1e7), width = *rc::gen::element(0.0, 1e-12, 1e-3, 0.05);
    const Vec3 shift = scale * *rc::gen::element(Vec3(0, 0, 0), Vec3(1e7, -1e7, 1e7)), hub = anyPoint(-1, 1);
    Surface s;
    for (int i = 0; i < 60; ++i) {
      const Vec3 from = i % 2 == 0 ? hub : anyPoint(-1, 1), to = anyPoint(-1, 1);
      const Vec3 apex = from + *within(-0.2, 1.2) * (to - from) + width * anyPoint(-1, 1);
      const auto n = static_cast<std::uint32_t>(s.points.size());
      for (const Vec3& p : {from, to, apex}) s.points.push_back(p * scale + shift);
      s.triangles.push_back({n, n + 1, n + 2});
    }
    const TriangleHierarchy cut(s.points, s.triangles, {}, Slivers::Cut);
    for (int i = 0; i < 20; ++i) {
      const Vec3 p = anyPoint(-2, 2) * scale + shift;
      const auto expected = bruteNearest(s, p), found = cut.nearest(p);
      RC_ASSERT(found.has_value());
      RC_ASSERT(found->squaredDistance == expected->squaredDistance);
      RC_ASSERT(found->triangle == expected->triangle);
      const Vec3 direction = anyPoint(-1, 1);
      const auto hit = cut.firstHit(p, direction), expectedHit = hierarchyOf(s).firstHit(p, direction);
      RC_ASSERT(hit.has_value() == expectedHit.has_value());
      if (hit) RC_ASSERT(hit->triangle == expectedHit->triangle && hit->distance == expectedHit->distance);
    }
  }));
}

// The sphere's triangles lie between its radius and the radius times the cosine of half an edge's angle.
void TriangleHierarchyNearestTest::nearestOnASphere() {
  const TriangleHierarchy h = hierarchyOf(sphere(64));
  const double least = std::cos(std::numbers::pi / 64);
  QVERIFY(rc::check([&] {
    const Vec3 p = anyPoint(-3, 3);
    const double distance = std::sqrt(h.nearest(p)->squaredDistance);
    RC_ASSERT(distance >= std::abs(p.norm() - 1.0) - 2 * (1.0 - least));
    RC_ASSERT(distance <= std::abs(p.norm() - 1.0) + 2 * (1.0 - least));
  }));
}

void TriangleHierarchyNearestTest::closestKnown_data() {
  QTest::addColumn<QList<double>>("triangle");
  QTest::addColumn<QList<double>>("point");
  QTest::addColumn<QList<double>>("closest");
  const QList<double> ordinary{0, 0, 0, 4, 0, 0, 0, 4, 0};
  QTest::newRow("above the inside") << ordinary << QList<double>{1, 1, 3} << QList<double>{1, 1, 0};
  QTest::newRow("in the inside") << ordinary << QList<double>{1, 2, 0} << QList<double>{1, 2, 0};
  QTest::newRow("beyond an edge") << ordinary << QList<double>{3, 3, 1} << QList<double>{2, 2, 0};
  QTest::newRow("beyond a corner") << ordinary << QList<double>{-1, -1, 1} << QList<double>{0, 0, 0};
  QTest::newRow("far beyond a corner") << ordinary << QList<double>{1e7, 0, 1e7} << QList<double>{4, 0, 0};
  const QList<double> segment{0, 0, 0, 4, 0, 0, 1, 0, 0};
  QTest::newRow("segment, beside") << segment << QList<double>{3, 2, 0} << QList<double>{3, 0, 0};
  QTest::newRow("segment, beyond") << segment << QList<double>{9, 2, 0} << QList<double>{4, 0, 0};
  QTest::newRow("point") << QList<double>{1, 2, 3, 1, 2, 3, 1, 2, 3} << QList<double>{9, 9, 9}
                         << QList<double>{1, 2, 3};
  QTest::newRow("two equal corners") << QList<double>{0, 0, 0, 0, 0, 0, 4, 0, 0} << QList<double>{1, 5, 0}
                                     << QList<double>{1, 0, 0};
}

void TriangleHierarchyNearestTest::closestKnown() {
  QFETCH(QList<double>, triangle);
  QFETCH(QList<double>, point);
  QFETCH(QList<double>, closest);
  const auto vec = [](const QList<double>& v, int i) { return Vec3(v[i], v[i + 1], v[i + 2]); };
  const Surface s{{vec(triangle, 0), vec(triangle, 3), vec(triangle, 6)}, {{0, 1, 2}}};
  const auto found = hierarchyOf(s).nearest(vec(point, 0));
  QVERIFY(found.has_value());
  QVERIFY((found->point - vec(closest, 0)).norm() < 1e-14);
  QCOMPARE(found->squaredDistance, (vec(closest, 0) - vec(point, 0)).squaredNorm());
}

// The condition that marks the nearest point of a convex set: no corner lies on the query's side of the plane through
// it.
void TriangleHierarchyNearestTest::closestIsOptimal() {
  QVERIFY(rc::check([] {
    const std::array<Vec3, 3> t{anyPoint(0, 1), anyPoint(0, 1), anyPoint(0, 1)};
    const double reach = *rc::gen::element(1.0, 100.0, 1e6);
    const Vec3 p = anyPoint(-reach, reach);
    const Vec3 q = closestOnTriangle(p, t[0], t[1], t[2]);
    const double slack = 1e-13 * std::max(1.0, (p - q).norm()) / (t[1] - t[0]).cross(t[2] - t[0]).norm();
    for (const Vec3& corner : t) RC_ASSERT((p - q).dot(corner - q) <= slack * std::max(1.0, reach));
  }));
}

void TriangleHierarchyNearestTest::nearestKeepsToTheLimit() {
  const TriangleHierarchy h = hierarchyOf(sphere(8));
  const Vec3 p(3, 0, 0);
  for (const double limit : {1.999, 2.0, 0.0, -5.0, kNaN}) {
    QVERIFY(!h.nearest(p, limit));
    QVERIFY(!h.isWithin(p, limit));
  }
  for (const double limit : {2.001, std::numeric_limits<double>::infinity()}) {
    QVERIFY(h.nearest(p, limit));
    QVERIFY(h.isWithin(p, limit));
  }
}

HANDWHEEL_TEST(TriangleHierarchyNearestTest)
#include "TriangleHierarchyNearestTest.moc"
