// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/CreaseMatching.h"

#include "CreasedShapes.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

namespace {

HoleContext holeIn(const TriangleSoup& part, const Vec3& centre, double radius) {
  const HalfEdgeMesh mesh = buildMesh(test::withHole(part, centre, radius)).mesh;
  return holeContext(mesh, findBoundaryLoops(mesh).at(0));
}

Creases creasesOf(const HoleContext& hole) {
  return matchCreases(hole, findCreaseEnds(hole, tolerance::kCreaseAngle), tolerance::kPatchDensity);
}

}  // namespace

class CreaseMatchingTest : public QObject {
  Q_OBJECT

 private slots:
  void curveOfARimIsItsCircle();
  void spacingIsThatAround();
  void threeEndsMeetInACorner();
  void creaseToACorner();
  void twoCreasesDoNotCross();
  void roughSurfacesHaveNone();
};

// The cubic of an arc of 2a is off the circle by about 4/27 · sin⁶(a/2) / cos²(a/2) radii (Goldapp 1991); the ends'
// directions, from points h apart on the circle, add some h² times the chord.
void CreaseMatchingTest::curveOfARimIsItsCircle() {
  for (double radius : {0.2, 0.4, 0.7}) {
    const HoleContext hole = holeIn(test::roughCylinder(240, 0), Vec3(1, 0, 1), radius);
    const std::vector<Crease> creases = creasesOf(hole).pairs;
    QCOMPARE(creases.size(), std::size_t{1});
    QVERIFY(creases[0].curve.size() >= 5);
    const double a =
        std::asin(0.5 * (hole.points[creases[0].from.chain[0]] - hole.points[creases[0].to.chain[0]]).norm());
    const double h = 2.0 * M_PI / 240.0;
    const double allowed = std::pow(std::sin(a / 2.0), 6) / 6.0 + 2.0 * h * h * a;
    for (const Vec3& p : creases[0].curve) {
      QVERIFY(std::abs(p.z() - 1.0) < 1e-9);
      QVERIFY(std::abs(std::hypot(p.x(), p.y()) - 1.0) < allowed);
    }
  }
}

void CreaseMatchingTest::spacingIsThatAround() {
  const HoleContext hole = holeIn(test::roughCube(40, 0), Vec3(1, 1, 0), 0.3);
  const Crease crease = creasesOf(hole).pairs.at(0);
  const double length = (hole.points[crease.from.chain[0]] - hole.points[crease.to.chain[0]]).norm();
  const double spacing = length / (crease.curve.size() + 1.0);
  QVERIFY(spacing > 0.05 && spacing < 0.05 * std::sqrt(2.0));  // sides and diagonals of the cells
  std::vector<CreaseEnd> ends = findCreaseEnds(hole, tolerance::kCreaseAngle);
  QVERIFY(matchCreases(hole, ends, 0.5 * tolerance::kPatchDensity).pairs.at(0).curve.size() < crease.curve.size());
}

void CreaseMatchingTest::threeEndsMeetInACorner() {
  for (double radius : {0.15, 0.4}) {  // from a few edges on
    const HoleContext hole = holeIn(test::roughCube(20, 0), Vec3(1, 1, 1), radius);
    QCOMPARE(findCreaseEnds(hole, tolerance::kCreaseAngle).size(), std::size_t{3});
    const Creases creases = creasesOf(hole);
    QVERIFY(creases.pairs.empty());
    QCOMPARE(creases.corners.size(), std::size_t{1});
    QVERIFY((creases.corners[0].point - Vec3::Ones()).norm() < 1e-9);
    for (const std::vector<Vec3>& curve : creases.corners[0].curves) {
      for (const Vec3& p : curve)
        QCOMPARE(std::count_if(p.begin(), p.end(), [](double x) { return x > 1.0 - 1e-9; }), 2);
    }
  }
}

// The corner is there yet, at the edge of the hole.
void CreaseMatchingTest::creaseToACorner() {
  TriangleSoup part = test::roughCube(20, 0);
  std::erase_if(part.triangles, [&](const Triangle& t) {
    const Vec3 middle = (part.points[t[0]] + part.points[t[1]] + part.points[t[2]]) / 3.0;
    return middle.z() < 0.999 && middle.z() > 0.4 && middle.x() > 0.6 && middle.y() > 0.6;
  });
  const HalfEdgeMesh mesh = buildMesh(part).mesh;
  const HoleContext hole = holeContext(mesh, findBoundaryLoops(mesh).at(0));
  const Creases creases = creasesOf(hole);
  QCOMPARE(creases.pairs.size(), std::size_t{1});
  QVERIFY(hole.points[creases.pairs[0].to.chain[0]] == Vec3::Ones());
  for (const Vec3& p : creases.pairs[0].curve) QVERIFY((p - Vec3(1, 1, p.z())).norm() < 1e-9);
}

void CreaseMatchingTest::twoCreasesDoNotCross() {
  const HoleContext hole = holeIn(test::roughSlab(30, 0), Vec3(0, 1, 0.1), 0.3);
  QCOMPARE(findCreaseEnds(hole, tolerance::kCreaseAngle).size(), std::size_t{4});
  const std::vector<Crease> creases = creasesOf(hole).pairs;
  QCOMPARE(creases.size(), std::size_t{2});
  for (const Crease& crease : creases)  // along one edge each
    QCOMPARE(hole.points[crease.from.chain[0]].z(), hole.points[crease.to.chain[0]].z());
}

// Spikes everywhere: pairs of ends would be chance.
void CreaseMatchingTest::roughSurfacesHaveNone() {
  HoleContext hole;
  hole.loopSize = 600;
  for (int i = 0; i < 600; ++i) {
    hole.points.emplace_back(std::cos(i), std::sin(i), 0.0);
    hole.edgeLength.push_back(1.0);
  }
  std::vector<CreaseEnd> ends;
  for (std::uint32_t i = 0; i < 300; ++i) ends.push_back({{2 * i, 2 * i + 1}, -hole.points[2 * i], 1.0});
  QVERIFY(matchCreases(hole, ends, tolerance::kPatchDensity).pairs.empty());
  ends.resize(60);
  QVERIFY(!matchCreases(hole, ends, tolerance::kPatchDensity).pairs.empty());
}

HANDWHEEL_TEST(CreaseMatchingTest)
#include "CreaseMatchingTest.moc"
