// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Surfaces.h"
#include "proximity/ClosestPoint.h"
#include "proximity/RayTriangle.h"
#include "proximity/TriangleHierarchy.h"

#include <rapidcheck.h>

#include <QTest>
#include <limits>
#include <numbers>

using namespace handwheel;
using test::Surface;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TriangleHierarchy hierarchyOf(const Surface& s) {
  return {s.points, s.triangles};
}

bool usable(const std::array<Vec3, 3>& t) {
  return t[0].allFinite() && t[1].allFinite() && t[2].allFinite();
}

std::optional<RayHit> bruteFirstHit(const Surface& s, const Vec3& origin, const Vec3& direction) {
  const RayTriangleTest test(origin, direction);
  std::optional<RayHit> best;
  for (std::uint32_t i = 0; i < s.triangles.size(); ++i) {
    const auto t = s.corners(i);
    const auto distance = usable(t) ? test.hit(t[0], t[1], t[2]) : std::nullopt;
    if (distance && (!best || *distance < best->distance)) best = RayHit{i, *distance};
  }
  return best;
}

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

std::vector<std::uint32_t> bruteInBox(const Surface& s, const Box& box) {
  std::vector<std::uint32_t> inside;
  for (std::uint32_t i = 0; i < s.triangles.size(); ++i) {
    const auto t = s.corners(i);
    Box own;
    for (const Vec3& p : t) own.extend(p);
    if (usable(t) && own.intersects(box)) inside.push_back(i);
  }
  return inside;
}

std::vector<std::uint32_t> inBox(const TriangleHierarchy& h, const Box& box) {
  std::vector<std::uint32_t> inside;
  h.forEachInBox(box, [&](std::uint32_t t) {
    inside.push_back(t);
    return true;
  });
  std::sort(inside.begin(), inside.end());
  return inside;
}

rc::Gen<double> within(double low, double high) {
  return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint32_t>()),
                      [=](std::uint32_t v) { return low + (high - low) * (v / 4294967296.0); });
}

Vec3 anyPoint(double low, double high) {
  return {*within(low, high), *within(low, high), *within(low, high)};
}

Vec3 anyDirection() {
  Vec3 d = anyPoint(-1, 1);
  for (int k = 0; k < 3; ++k)
    if (*rc::gen::inRange(0, 4) == 0) d[k] = 0;
  return d.isZero() ? Vec3(0, 0, -1) : d;
}

// A soup in the unit cube, and where to put it.
struct Placed {
  Surface surface;
  double scale;
  Vec3 shift;

  Vec3 operator()(const Vec3& p) const { return p * scale + shift; }
  Vec3 anyCorner() const { return surface.points[*rc::gen::inRange<std::size_t>(0, surface.points.size())]; }
};

Placed anySoup() {
  const auto count = *rc::gen::inRange<std::size_t>(1, 400);
  const double size = *rc::gen::element(0.02, 0.1, 0.7);
  const int steps = *rc::gen::element(0, 3, 16);
  const double scale = *rc::gen::element(1.0, 1e-6, 1e7);
  const Vec3 shift = *rc::gen::element(Vec3(0, 0, 0), Vec3(1e7, -1e7, 1e7));
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  return {test::moved(test::soup(count, size, steps, seed), scale, shift), scale, shift};
}

}  // namespace

class TriangleHierarchyTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { qputenv("RC_PARAMS", qgetenv("RC_PARAMS") + " max_success=300"); }
  void empty();
  void unusableNeverEnter();
  void firstHitAgainstBruteForce();
  void firstHitInTheMiddleOfATriangle();
  void firstHitKnown_data();
  void firstHitKnown();
  void noRaySlipsThrough_data();
  void noRaySlipsThrough();
  void alongTheAxesOfAGrid();
  void distanceIsInLengthsOfTheDirection();
  void nearestAgainstBruteForce();
  void nearestOnASphere();
  void closestKnown_data();
  void closestKnown();
  void closestIsOptimal();
  void nearestKeepsToTheLimit();
  void inBoxAgainstBruteForce();
  void inBoxBoundariesAndStop();
  void strayVertexDoesNoHarm();
  void manyEqualTriangles();
  void keepsItsOwnCopy();
};

void TriangleHierarchyTest::empty() {
  for (const TriangleHierarchy& h : {TriangleHierarchy(), hierarchyOf({}), hierarchyOf({{Vec3(1, 2, 3)}, {}})}) {
    QVERIFY(h.empty());
    QVERIFY(h.bounds().isEmpty());
    QVERIFY(!h.firstHit(Vec3(0, 0, 0), Vec3(0, 0, 1)));
    QVERIFY(!h.nearest(Vec3(0, 0, 0)));
    QVERIFY(h.forEachInBox(Box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), [](std::uint32_t) { return false; }));
  }
}

void TriangleHierarchyTest::unusableNeverEnter() {
  Surface s = test::soup(50, 0.3, 0, 1);
  const double infinity = std::numeric_limits<double>::infinity();
  s.points[0] = Vec3(kNaN, 0.5, 0.5);
  s.points[31].y() = infinity;
  s.points[62].z() = -infinity;
  const TriangleHierarchy h = hierarchyOf(s);
  const Box everything(Vec3::Constant(-infinity), Vec3::Constant(infinity));
  QCOMPARE(inBox(h, everything).size(), std::size_t{47});
  QVERIFY(h.bounds().min().allFinite() && h.bounds().max().allFinite());
  for (const Vec3& bad : {Vec3(kNaN, 0, 0), Vec3(0, infinity, 0)}) {
    QVERIFY(!h.nearest(bad));
    QVERIFY(!h.firstHit(bad, Vec3(1, 0, 0)));
    QVERIFY(!h.firstHit(Vec3(0, 0, 0), bad));
  }
  QVERIFY(!h.firstHit(Vec3(0.5, 0.5, 0.5), Vec3(0, 0, 0)));
}

void TriangleHierarchyTest::firstHitAgainstBruteForce() {
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
      // The lengths are scaled by powers of two on the way, so they agree to the last bit.
      RC_ASSERT(hit->distance == expected->distance);
      RC_ASSERT(hit->triangle == expected->triangle);
    }
  }));
}

// Through a point known to lie within a triangle: that triangle or one before it.
void TriangleHierarchyTest::firstHitInTheMiddleOfATriangle() {
  QVERIFY(rc::check([] {
    const Surface s = test::soup(100, 0.2, 0, *rc::gen::arbitrary<std::uint32_t>());
    const TriangleHierarchy h = hierarchyOf(s);
    const auto t = s.corners(*rc::gen::inRange<std::size_t>(0, 100));
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const Vec3 direction = anyDirection();
    RC_PRE(std::abs(normal.dot(direction)) > 1e-6);
    const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
    const auto hit = h.firstHit(middle - 3.0 * direction, direction);
    RC_ASSERT(hit.has_value());
    RC_ASSERT(hit->distance <= 3.0 + 1e-9);
    // What was hit lies on the ray.
    const auto met = s.corners(hit->triangle);
    const Vec3 at = middle + (hit->distance - 3.0) * direction;
    RC_ASSERT((closestOnTriangle(at, met[0], met[1], met[2]) - at).norm() < 1e-9);
  }));
}

void TriangleHierarchyTest::firstHitKnown_data() {
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

void TriangleHierarchyTest::firstHitKnown() {
  QFETCH(QList<double>, ray);
  QFETCH(double, distance);
  const TriangleHierarchy h = hierarchyOf({{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)}, {{0, 1, 2}}});
  const auto hit = h.firstHit(Vec3(ray[0], ray[1], ray[2]), Vec3(ray[3], ray[4], ray[5]));
  QCOMPARE(hit.has_value(), distance >= 0.0);
  if (hit) QCOMPARE(hit->distance, distance);
}

void TriangleHierarchyTest::noRaySlipsThrough_data() {
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
void TriangleHierarchyTest::noRaySlipsThrough() {
  QFETCH(double, radius);
  QFETCH(double, from);
  QFETCH(double, shift);
  const Vec3 centre(shift, -shift, shift);
  const Surface s = test::sphere(20, centre, radius);
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
void TriangleHierarchyTest::alongTheAxesOfAGrid() {
  constexpr int n = 16;
  for (int axis = 0; axis < 3; ++axis) {
    Surface s;
    const auto place = [&](double u, double v, double w) {
      Vec3 p;
      p[(axis + 1) % 3] = u;
      p[(axis + 2) % 3] = v;
      p[axis] = w;
      return p;
    };
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) s.points.push_back(place(i, j, 0));
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
          const auto hit = h.firstHit(place(i / 2.0, j / 2.0, side), place(0, 0, -side));
          QVERIFY(hit.has_value());
          QCOMPARE(hit->distance, 1.0);
        }
    QVERIFY(!h.firstHit(place(-0.001, 1, 7), place(0, 0, -1)));
    QVERIFY(!h.firstHit(place(1, n + 0.001, 7), place(0, 0, -1)));
  }
}

void TriangleHierarchyTest::distanceIsInLengthsOfTheDirection() {
  const TriangleHierarchy h = hierarchyOf(test::sphere(4));
  QCOMPARE(h.firstHit(Vec3(5, 0, 0), Vec3(-2, 0, 0))->distance, 2.0);
  QCOMPARE(h.firstHit(Vec3(0, 0, 0), Vec3(0, 0.125, 0))->distance, 8.0);
}

void TriangleHierarchyTest::nearestAgainstBruteForce() {
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
    }
  }));
}

// The sphere's triangles lie between its radius and the radius times the cosine of half an edge's angle.
void TriangleHierarchyTest::nearestOnASphere() {
  const TriangleHierarchy h = hierarchyOf(test::sphere(64));
  const double least = std::cos(std::numbers::pi / 64);
  QVERIFY(rc::check([&] {
    const Vec3 p = anyPoint(-3, 3);
    const double distance = std::sqrt(h.nearest(p)->squaredDistance);
    RC_ASSERT(distance >= std::abs(p.norm() - 1.0) - 2 * (1.0 - least));
    RC_ASSERT(distance <= std::abs(p.norm() - 1.0) + 2 * (1.0 - least));
  }));
}

void TriangleHierarchyTest::closestKnown_data() {
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

void TriangleHierarchyTest::closestKnown() {
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
void TriangleHierarchyTest::closestIsOptimal() {
  QVERIFY(rc::check([] {
    const std::array<Vec3, 3> t{anyPoint(0, 1), anyPoint(0, 1), anyPoint(0, 1)};
    const double reach = *rc::gen::element(1.0, 100.0, 1e6);
    const Vec3 p = anyPoint(-reach, reach);
    const Vec3 q = closestOnTriangle(p, t[0], t[1], t[2]);
    const double slack = 1e-13 * std::max(1.0, (p - q).norm()) / (t[1] - t[0]).cross(t[2] - t[0]).norm();
    for (const Vec3& corner : t) RC_ASSERT((p - q).dot(corner - q) <= slack * std::max(1.0, reach));
  }));
}

void TriangleHierarchyTest::nearestKeepsToTheLimit() {
  const TriangleHierarchy h = hierarchyOf(test::sphere(8));
  const Vec3 p(3, 0, 0);
  QVERIFY(!h.nearest(p, 1.999));
  QVERIFY(!h.nearest(p, 2.0));
  QVERIFY(h.nearest(p, 2.001));
  QVERIFY(!h.nearest(p, 0.0));
  QVERIFY(!h.nearest(p, -5.0));
  QVERIFY(!h.nearest(p, kNaN));
  QVERIFY(h.nearest(p, std::numeric_limits<double>::infinity()));
}

void TriangleHierarchyTest::inBoxAgainstBruteForce() {
  QVERIFY(rc::check([] {
    const Placed soup = anySoup();
    const TriangleHierarchy h = hierarchyOf(soup.surface);
    for (int i = 0; i < 20; ++i) {
      // Some with sides through the corners of a triangle, and so exactly on boundaries.
      const auto pick = [&] { return *rc::gen::arbitrary<bool>() ? soup(anyPoint(-0.2, 1.2)) : soup.anyCorner(); };
      Box box(pick());
      box.extend(pick());
      RC_ASSERT(inBox(h, box) == bruteInBox(soup.surface, box));
    }
  }));
}

void TriangleHierarchyTest::inBoxBoundariesAndStop() {
  const Surface s{{Vec3(0.1, 0.1, 0.1), Vec3(0.7, 0.1, 0.1), Vec3(0.1, 0.7, 0.1)}, {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}}};
  const TriangleHierarchy h = hierarchyOf(s);
  QCOMPARE(inBox(h, Box(Vec3(0.7, 0.7, 0.1), Vec3(1, 1, 1))).size(), std::size_t{3});
  QVERIFY(inBox(h, Box(Vec3(std::nextafter(0.7, 1.0), 0, 0), Vec3(1, 1, 1))).empty());
  QVERIFY(inBox(h, Box()).empty());
  int visits = 0;
  const bool finished = h.forEachInBox(h.bounds(), [&](std::uint32_t) { return ++visits < 2; });
  QVERIFY(!finished);
  QCOMPARE(visits, 2);
}

// One vertex very far away must not blur the boxes of the others: picking still finds what it should.
void TriangleHierarchyTest::strayVertexDoesNoHarm() {
  Surface s = test::sphere(20);
  const Surface alone = s;
  s.points.push_back(Vec3(1e25, 1e25, 1e25));
  s.triangles.push_back({0, 1, static_cast<std::uint32_t>(s.points.size() - 1)});
  const TriangleHierarchy h = hierarchyOf(s);
  QVERIFY(rc::check([&] {
    const Vec3 inside = anyPoint(-0.4, 0);
    const Vec3 direction = -anyPoint(0.1, 1);
    RC_ASSERT(h.firstHit(inside, direction)->triangle == bruteFirstHit(alone, inside, direction)->triangle);
    RC_ASSERT(inBox(h, Box(inside, inside + Vec3::Constant(0.1))) ==
              bruteInBox(s, Box(inside, inside + Vec3::Constant(0.1))));
  }));
}

// No way to part them.
void TriangleHierarchyTest::manyEqualTriangles() {
  Surface s{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {}};
  s.triangles.assign(100000, {0, 1, 2});
  const TriangleHierarchy h = hierarchyOf(s);
  QCOMPARE(h.firstHit(Vec3(0.2, 0.2, 1), Vec3(0, 0, -1))->triangle, 0u);
  QCOMPARE(h.nearest(Vec3(0.2, 0.2, 1))->triangle, 0u);
  QCOMPARE(inBox(h, h.bounds()).size(), s.triangles.size());
}

void TriangleHierarchyTest::keepsItsOwnCopy() {
  Surface s = test::sphere(5);
  const Surface before = s;
  const TriangleHierarchy h = hierarchyOf(s);
  s = {};
  for (std::uint32_t i = 0; i < before.triangles.size(); ++i) QCOMPARE(h.corners(i), before.corners(i));
  QVERIFY(h.firstHit(Vec3(0, 0, 5), Vec3(0, 0, -1)));
}

QTEST_APPLESS_MAIN(TriangleHierarchyTest)
#include "TriangleHierarchyTest.moc"
