// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/SharedPlanes.h"

#include "MeshShapes.h"
#include "TestClass.h"

#include <QTest>
#include <numbers>

using namespace handwheel;

namespace {

// Two squares of two triangles each, one moved by (0.5, 0.25) along the other and by the height above it.
TriangleSoup squares(double height, double tilt = 0.0) {
  TriangleSoup soup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  TriangleSoup other = soup;
  for (Vec3& p : other.points) p = Vec3(p.x() + 0.5, p.y() + 0.25, height + tilt * p.x());
  test::append(soup, other);
  return soup;
}

const TrianglePair kCrossing[] = {{0, 2}};

}  // namespace

class SharedPlanesTest : public QObject {
  Q_OBJECT

 private slots:
  void oneOfTwo();
  void howNear();
  void threePlanesAtACorner();
  void nearlyParallel();
  void unrelatedPairs();
};

// The second triangles of the squares lie in the plane, too.
void SharedPlanesTest::oneOfTwo() {
  const SharedPlanes found = findSharedPlanes(squares(0.0), kCrossing);
  QCOMPARE(found.planes.size(), std::size_t{1});
  QVERIFY(std::abs(std::abs(found.planes[0].normal.z()) - 1.0) < 1e-15);
  QCOMPARE(found.planesOf.size(), std::size_t{8});
  QVERIFY(std::find(found.pairs.begin(), found.pairs.end(), TrianglePair(1, 3)) != found.pairs.end());
  QVERIFY(found.reach > 0.0);
}

// Sixteen ulps of the largest coordinate, 1.5: of single precision if all have it, else of double.
void SharedPlanesTest::howNear() {
  const double single = 16 * 0x1p-23 * 1.5, twice = 16 * 0x1p-52 * 1.5;
  const auto isShared = [](double height) { return !findSharedPlanes(squares(height), kCrossing).isEmpty(); };
  QVERIFY(isShared(single) && isShared(0x1p-24));  // exact in single precision
  QVERIFY(!isShared(single + 0x1p-20));
  QVERIFY(isShared(twice * 0.99) && !isShared(0.1 * single + 0x1p-50));
  TriangleSoup fine = squares(twice * 2.0);
  fine.points[0].x() = 0.1;  // not representable as a float
  QVERIFY(findSharedPlanes(fine, kCrossing).isEmpty());
}

// If walls of one cube lie in those of another, a corner lies in three planes, which determine its position.
void SharedPlanesTest::threePlanesAtACorner() {
  TriangleSoup soup = test::cube(2.0);
  test::append(soup, test::cube(1.0));
  std::vector<TrianglePair> pairs;
  for (std::uint32_t f = 0; f < 12; ++f)
    for (std::uint32_t g = 12; g < 24; ++g) pairs.emplace_back(f, g);
  const SharedPlanes found = findSharedPlanes(soup, pairs);
  QCOMPARE(found.planes.size(), std::size_t{9});  // three that are shared, and the flat sides of both
  for (const auto& [v, planes] : found.planesOf) QCOMPARE(planes.size(), std::size_t{3});
  QCOMPARE(found.planesOf.size(), std::size_t{16});
}

// Two planes that meet at less than a thousandth of a radian have no line: rounding would move it far. Three of them at
// a common edge are shared by pairs; the steeper fold stays, of the other only one plane does.
void SharedPlanesTest::nearlyParallel() {
  for (const double fold : {0.5e-3, 4e-3}) {
    // A roof whose two sides meet at y = 0, twice, one moved along the ridge.
    TriangleSoup roof{
        {{0, -1, -fold / 2}, {4, -1, -fold / 2}, {0, 0, 0}, {4, 0, 0}, {0, 1, -fold / 2}, {4, 1, -fold / 2}},
        {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}}};
    TriangleSoup soup = roof;
    for (Vec3& p : roof.points) p.x() += 1.0;
    test::append(soup, roof);
    const std::vector<TrianglePair> pairs{{0, 4}, {2, 6}};
    QCOMPARE(findSharedPlanes(soup, pairs).planes.size(), std::size_t(fold < 1e-3 ? 1 : 2));
  }
}

void SharedPlanesTest::unrelatedPairs() {
  QVERIFY(findSharedPlanes(squares(-0.1, 0.5), kCrossing).isEmpty());
  QVERIFY(findSharedPlanes({}, {}).isEmpty());
}

HANDWHEEL_TEST(SharedPlanesTest)
#include "SharedPlanesTest.moc"
