// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/Bridging.h"

#include "HandWorkChecks.h"
#include "HoleShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/boundary/BoundaryWelding.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

class BridgingTest : public QObject {
  Q_OBJECT

 private slots:
  void aroundTheBorder();
  void splitsAHole();
  void tiesAnIsland();
  void twoEdgesApart();
  void neighboursAndThePartBetween();
  void anyTwoPoints();
  void weldsNeighbours();
  void weldsTwoEdgesApart();
  void weldsAcross();
  void weldsAnIsland();
  void weldRefuses();
  void weldsAnyTwoPoints();
  void withinABox();
};

namespace {

std::size_t loopCount(const HalfEdgeMesh& mesh) {
  return findBoundaryLoops(mesh).size();
}

BoundaryPair between(const HalfEdgeMesh& mesh, const Vec3& a, const Vec3& b) {
  return {test::borderAt(mesh, a), test::borderAt(mesh, b)};
}

HalfEdgeMesh anyMesh() {
  const double scale = *rc::gen::element(1e-6, 1.0, 1e6);
  const double offset = scale == 1.0 ? *rc::gen::element(0.0, 1e7) : 0.0;
  const TriangleSoup soup =
      *rc::gen::element(test::plateWithPinchedHole(), test::plateWithIsland(), test::sphereWithHoles(2, 4, 0.4),
                        test::moebiusStrip(12, 1), test::cylinder(3, 2, 1.0, 3.0, false));
  return buildMesh(test::moved(soup, Vec3::Constant(offset), scale)).mesh;
}

// Two points of the border, most often such as are near each other.
BoundaryPair anyEnds(const HalfEdgeMesh& mesh) {
  std::vector<HalfEdge> border;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
    if (mesh.isBorder(h)) border.push_back(h);
  if (border.empty()) return {};
  const auto any = [&] { return border[*rc::gen::inRange<std::size_t>(0, border.size())]; };
  BoundaryPair ends{any(), any()};
  switch (*rc::gen::inRange(0, 5)) {
    case 0:
      ends.b = mesh.nextOpen(ends.a);
      break;
    case 1:
      ends.b = mesh.nextOpen(mesh.nextOpen(ends.a));
      break;
    case 2:
      ends.b = previousOpen(mesh, previousOpen(mesh, ends.a));
      break;
    default:
      break;
  }
  return ends;
}

}  // namespace

void BridgingTest::aroundTheBorder() {
  for (const TriangleSoup& soup : {test::plateWithPinchedHole(), test::moebiusStrip(12, 1), test::disc(5, 2)}) {
    const HalfEdgeMesh mesh = buildMesh(soup).mesh;
    for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
      if (mesh.isBorder(h)) QCOMPARE(previousOpen(mesh, mesh.nextOpen(h)), h);
  }
}

void BridgingTest::splitsAHole() {
  HalfEdgeMesh mesh = buildMesh(test::plateWithHole()).mesh;
  const HalfEdgeMesh before = mesh;
  const FaceLocator near = test::nearFaces(mesh);
  const Bridge bridge = findBridge(near, between(mesh, Vec3(0, -2, 0), Vec3(0, 2, 0)));
  QCOMPARE(bridge.problem, JoinProblem::None);
  QCOMPARE(bridge.triangles.size(), std::size_t(2));
  QCOMPARE(addFaces(mesh, bridge.triangles, near), JoinProblem::None);
  QCOMPARE(test::worse(before, mesh), std::string());
  QVERIFY(test::othersStay(before, mesh, {}));
  QCOMPARE(loopCount(mesh), loopCount(before) + 1);
  // The line between the points is an edge, over two border edges of length 1.
  for (const Triangle& t : bridge.triangles) {
    const TrianglePoints p = {mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])};
    QCOMPARE(0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm(), 2.0);
  }
}

void BridgingTest::tiesAnIsland() {
  HalfEdgeMesh mesh = buildMesh(test::plateWithIsland()).mesh;
  const HalfEdgeMesh before = mesh;
  QCOMPARE(loopCount(before), std::size_t(3));
  const FaceLocator near = test::nearFaces(mesh);
  const Bridge bridge = findBridge(near, between(mesh, Vec3(-2, 0, 0), Vec3(-6, 0, 0)));
  QCOMPARE(bridge.problem, JoinProblem::None);
  QCOMPARE(addFaces(mesh, bridge.triangles, near), JoinProblem::None);
  QCOMPARE(test::worse(before, mesh), std::string());
  QCOMPARE(loopCount(mesh), std::size_t(2));
  QCOMPARE(test::pieces(mesh).size(), std::size_t(1));
}

void BridgingTest::twoEdgesApart() {
  const HalfEdgeMesh mesh = buildMesh(test::plateWithHole()).mesh;
  const Bridge bridge = findBridge(test::nearFaces(mesh), between(mesh, Vec3(-1, -2, 0), Vec3(-2, -1, 0)));
  QCOMPARE(bridge.problem, JoinProblem::None);
  QCOMPARE(bridge.triangles.size(), std::size_t(1));
}

void BridgingTest::neighboursAndThePartBetween() {
  const HalfEdgeMesh mesh = buildMesh(test::plateWithHole()).mesh;
  const FaceLocator near = test::nearFaces(mesh);
  const auto problem = [&](const Vec3& a, const Vec3& b) { return findBridge(near, between(mesh, a, b)).problem; };
  QVERIFY(problem(Vec3(-1, -2, 0), Vec3(-1, -2, 0)) == JoinProblem::SamePoint);
  // From the hole to the outer rim, through the plate.
  QVERIFY(problem(Vec3(-2, 0, 0), Vec3(-5, 0, 0)) != JoinProblem::None);
  QVERIFY(problem(Vec3(-2, 0, 0), Vec3(-5, 0, 0)) != JoinProblem::SamePoint);
}

void BridgingTest::anyTwoPoints() {
  QVERIFY(rc::check([] {
    HalfEdgeMesh mesh = anyMesh();
    for (int i = 0; i < 10; ++i) {
      const BoundaryPair ends = anyEnds(mesh);
      if (ends.a == kNone) break;
      const HalfEdgeMesh before = mesh;
      const Bridge bridge = findBridge(test::nearFaces(mesh), ends);
      RC_ASSERT((bridge.problem == JoinProblem::None) == !bridge.triangles.empty());
      if (bridge.problem != JoinProblem::None) continue;
      RC_ASSERT(addFaces(mesh, bridge.triangles, test::nearFaces(mesh)) == JoinProblem::None);
      RC_ASSERT(test::worse(before, mesh) == "");
      RC_ASSERT(test::othersStay(before, mesh, {}));
    }
  }));
}

void BridgingTest::weldsNeighbours() {
  const HalfEdgeMesh mesh = buildMesh(test::plateWithHole()).mesh;
  const BoundaryWeld weld = weldBoundary(test::nearFaces(mesh), between(mesh, Vec3(-1, -2, 0), Vec3(0, -2, 0)));
  QCOMPARE(weld.problem, JoinProblem::None);
  QCOMPARE(test::worse(mesh, weld.mesh), std::string());
  QVERIFY(test::othersStay(mesh, weld.mesh, weld.changed));
  QCOMPARE(weld.mesh.liveFaceCount(), mesh.liveFaceCount() - 1);
  QCOMPARE(weld.shapes.triangles.size(), weld.changed.size() - 1);
}

// The gap of a disc without one of its sectors.
void BridgingTest::weldsTwoEdgesApart() {
  TriangleSoup soup = test::disc(24, 3);
  std::erase_if(soup.triangles, [&](const Triangle& t) {
    const Vec3 middle = (soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]) / 3.0;
    const double angle = std::atan2(middle.y(), middle.x());
    return angle > 0.0 && angle < 2.0 * M_PI / 24;
  });
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  for (const std::uint32_t ring : {0u, 1u, 2u}) {
    const BoundaryPair ends = between(mesh, soup.points[24 * ring], soup.points[24 * ring + 1]);
    BoundaryWeld weld = weldBoundary(test::nearFaces(mesh), ends);
    QCOMPARE(weld.problem, JoinProblem::None);
    QCOMPARE(test::worse(mesh, weld.mesh), std::string());
    QVERIFY(test::othersStay(mesh, weld.mesh, weld.changed));
    QCOMPARE(weld.mesh.liveFaceCount(), mesh.liveFaceCount());
    QCOMPARE(test::countBorder(weld.mesh), test::countBorder(mesh) - 2);
    mesh = std::move(weld.mesh);
  }
  QCOMPARE(test::countBorder(mesh), std::size_t(23));
}

// A slot is sewn in its middle: two edges become one, and it falls into two.
void BridgingTest::weldsAcross() {
  const HalfEdgeMesh mesh =
      buildMesh(test::plateWithout(20, [](double x, double y) { return std::abs(x) < 1.0 && std::abs(y) < 6.0; })).mesh;
  for (const double far : {-1.0, 1.0}) {
    const BoundaryWeld weld = weldBoundary(test::nearFaces(mesh), between(mesh, Vec3(-far, 0, 0), Vec3(far, 0, 0)));
    // The triangles beside it are one wide and the slot two, so they stretch but do not turn.
    QCOMPARE(weld.problem, JoinProblem::None);
    QCOMPARE(test::worse(mesh, weld.mesh), std::string());
    QVERIFY(test::othersStay(mesh, weld.mesh, weld.changed));
    QCOMPARE(loopCount(weld.mesh), loopCount(mesh) + 1);
    QCOMPARE(test::countBorder(weld.mesh), test::countBorder(mesh) - 2);
    QCOMPARE(test::vertexAt(weld.mesh, Vec3(far, 0, 0)), test::vertexAt(mesh, Vec3(far, 0, 0)));
  }
}

void BridgingTest::weldsAnIsland() {
  const HalfEdgeMesh mesh = buildMesh(test::plateWithIsland()).mesh;
  const BoundaryWeld weld = weldBoundary(test::nearFaces(mesh), between(mesh, Vec3(-2, 0, 0), Vec3(-6, 0, 0)));
  QCOMPARE(weld.problem, JoinProblem::None);
  QCOMPARE(test::worse(mesh, weld.mesh), std::string());
  QCOMPARE(loopCount(weld.mesh), loopCount(mesh) - 1);
  QCOMPARE(test::pieces(weld.mesh).size(), std::size_t(1));
}

void BridgingTest::weldRefuses() {
  const HalfEdgeMesh mesh = buildMesh(test::plateWithHole()).mesh;
  const FaceLocator near = test::nearFaces(mesh);
  const auto problem = [&](const Vec3& a, const Vec3& b) { return weldBoundary(near, between(mesh, a, b)).problem; };
  QVERIFY(problem(Vec3(0, 2, 0), Vec3(0, 2, 0)) == JoinProblem::SamePoint);
  QVERIFY(problem(Vec3(-2, 0, 0), Vec3(-5, 0, 0)) == JoinProblem::FlippedFace);
  const HalfEdgeMesh pinched = buildMesh(test::plateWithPinchedHole()).mesh;
  const BoundaryWeld torn = weldBoundary(test::nearFaces(pinched), between(pinched, Vec3::Zero(), Vec3(2, 1, 0)));
  QVERIFY(torn.problem == JoinProblem::NonManifoldVertex);
}

void BridgingTest::weldsAnyTwoPoints() {
  QVERIFY(rc::check([] {
    HalfEdgeMesh mesh = anyMesh();
    for (int i = 0; i < 10; ++i) {
      const BoundaryPair ends = anyEnds(mesh);
      if (ends.a == kNone) break;
      BoundaryWeld weld = weldBoundary(test::nearFaces(mesh), ends);
      if (weld.problem != JoinProblem::None) continue;
      RC_ASSERT(test::worse(mesh, weld.mesh) == "");
      RC_ASSERT(test::othersStay(mesh, weld.mesh, weld.changed));
      RC_ASSERT(test::countBorder(weld.mesh) < test::countBorder(mesh));
      mesh = std::move(weld.mesh);
    }
  }));
}

// Faces outside of reachOf() make no difference.
void BridgingTest::withinABox() {
  QVERIFY(rc::check([] {
    const HalfEdgeMesh mesh = anyMesh();
    const BoundaryPair ends = anyEnds(mesh);
    const FaceLocator near(mesh, reachOf(mesh, ends)), all = test::nearFaces(mesh);
    const BoundaryWeld weld = weldBoundary(near, ends), other = weldBoundary(all, ends);
    RC_ASSERT(weld.problem == other.problem);
    RC_ASSERT(weld.problem != JoinProblem::None || test::sameMesh(weld.mesh, other.mesh));
    RC_ASSERT(findBridge(near, ends).triangles == findBridge(all, ends).triangles);
  }));
}

HANDWHEEL_TEST(BridgingTest)
#include "BridgingTest.moc"
