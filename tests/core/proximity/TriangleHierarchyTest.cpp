// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "HierarchyQueries.h"
#include "TestClass.h"

#include <QTest>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kTriangleHierarchyNaN = std::numeric_limits<double>::quiet_NaN();

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

}  // namespace

class TriangleHierarchyTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { qputenv("RC_PARAMS", qgetenv("RC_PARAMS") + " max_success=300"); }
  void empty();
  void unusableNeverEnter();
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
  Surface s = soup(50, 0.3, 0, 1);
  const double infinity = std::numeric_limits<double>::infinity();
  s.points[0] = Vec3(kTriangleHierarchyNaN, 0.5, 0.5);
  s.points[31].y() = infinity;
  s.points[62].z() = -infinity;
  const TriangleHierarchy h = hierarchyOf(s);
  const Box everything(Vec3::Constant(-infinity), Vec3::Constant(infinity));
  QCOMPARE(inBox(h, everything).size(), std::size_t{47});
  QVERIFY(h.bounds().min().allFinite() && h.bounds().max().allFinite());
  for (const Vec3& bad : {Vec3(kTriangleHierarchyNaN, 0, 0), Vec3(0, infinity, 0)}) {
    QVERIFY(!h.nearest(bad));
    QVERIFY(!h.firstHit(bad, Vec3(1, 0, 0)));
    QVERIFY(!h.firstHit(Vec3(0, 0, 0), bad));
  }
  QVERIFY(!h.firstHit(Vec3(0.5, 0.5, 0.5), Vec3(0, 0, 0)));
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
  Surface s = sphere(20);
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

// The triangles cannot be separated.
void TriangleHierarchyTest::manyEqualTriangles() {
  Surface s{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {}};
  s.triangles.assign(100000, {0, 1, 2});
  const TriangleHierarchy h = hierarchyOf(s);
  QCOMPARE(h.firstHit(Vec3(0.2, 0.2, 1), Vec3(0, 0, -1))->triangle, 0u);
  QCOMPARE(h.nearest(Vec3(0.2, 0.2, 1))->triangle, 0u);
  QCOMPARE(inBox(h, h.bounds()).size(), s.triangles.size());
}

void TriangleHierarchyTest::keepsItsOwnCopy() {
  Surface s = sphere(5);
  const Surface before = s;
  const TriangleHierarchy h = hierarchyOf(s);
  s = {};
  for (std::uint32_t i = 0; i < before.triangles.size(); ++i) QCOMPARE(h.corners(i), before.corners(i));
  QVERIFY(h.firstHit(Vec3(0, 0, 5), Vec3(0, 0, -1)));
}

HANDWHEEL_TEST(TriangleHierarchyTest)
#include "TriangleHierarchyTest.moc"
