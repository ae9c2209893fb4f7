// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/BoundaryNeedles.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/boundary/BoundaryVertices.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/repair/Repair.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

namespace {

// A tube of 500 edges around, open at both ends, and on an edge of the upper one a needle that stands into the hole
// beside an end of that edge. width: of the needle's shorter open edge.
TriangleSoup tubeWithNeedle(double width) {
  const std::uint32_t n = 500;
  TriangleSoup soup = test::cylinder(n, 1, 1.0, 4.0, false);
  soup.points.push_back(soup.points[1] + Vec3(0, 0, width));
  soup.triangles.push_back({1, 3, 2 * n});  // 1 and 3 are the first two points of the upper end
  return soup;
}

std::vector<Face> needlesOf(const HalfEdgeMesh& mesh) {
  return findBoundaryNeedles(mesh, findBoundaryLoops(mesh), nearWeldReach(mesh));
}

}  // namespace

class BoundaryNeedlesTest : public QObject {
  Q_OBJECT

 private slots:
  void widths();
  void whatIsNone();
  void holeWithOneIsFilled();
  void reasonOfAFailure();
};

// The reach is 1e-5 of the diagonal, √(2² + 2² + 4²): 4.9e-5.
void BoundaryNeedlesTest::widths() {
  for (const double width : {1e-9, 1e-6, 4.8e-5}) {
    const HalfEdgeMesh mesh = buildMesh(tubeWithNeedle(width)).mesh;
    QCOMPARE(needlesOf(mesh), std::vector<Face>{1000});
  }
  for (const double width : {5e-5, 1e-3, 0.1}) QVERIFY(needlesOf(buildMesh(tubeWithNeedle(width)).mesh).empty());
}

// A triangle by itself, and one as small as the reach but no needle.
void BoundaryNeedlesTest::whatIsNone() {
  QVERIFY(needlesOf(buildMesh({{{0, 0, 0}, {1e-7, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}).mesh).empty());
  const TriangleSoup soup{{{1, 0, 0}, {0, 1, 0}, {1e-6, 0, 0}, {0, 1e-6, 0}, {-1e-6, 0, 0}},
                          {{2, 0, 1}, {2, 1, 3}, {2, 3, 4}}};
  QVERIFY(needlesOf(buildMesh(soup).mesh).empty());
  QVERIFY(findBoundaryNeedles({}, {}, 1.0).empty());
}

// Without the needle both ends are flat loops, which any lid closes. Where they are kept open, it stays.
void BoundaryNeedlesTest::holeWithOneIsFilled() {
  const HalfEdgeMesh input = buildMesh(tubeWithNeedle(1e-6)).mesh;
  HalfEdgeMesh mesh = input;
  const RepairReport report = repair(mesh, {});
  QCOMPARE(report.removedDegenerate, std::size_t{1});
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
  QVERIFY(repair(mesh, {}).removedDegenerate == 0);

  mesh = input;
  RepairOptions options;
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh)) options.keepOpen.insert(loop.id);
  QCOMPARE(repair(mesh, options).removedDegenerate, std::size_t{0});
  QCOMPARE(mesh.liveFaceCount(), std::size_t{1001});
}

// A pole through both ends, so that no patch fits. Only of the end with the needle is that a possible reason.
void BoundaryNeedlesTest::reasonOfAFailure() {
  for (const double width : {1e-6, 0.1}) {
    TriangleSoup soup = tubeWithNeedle(width);
    test::append(soup, test::moved(test::cylinder(8, 10, 0.1, 20.0, true), Vec3(0.0, 0.0, -10.0)));
    const HalfEdgeMesh mesh = buildMesh(soup).mesh;
    const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
    QCOMPARE(loops.size(), std::size_t{2});
    for (BoundaryLoop loop : loops) {
      const bool hasNeedle = loop.halfEdges.size() == 501 && width < 1e-3;
      const FillFailure failure = HoleFiller(mesh).propose(loop, {}).failure;
      QVERIFY(failure == (hasNeedle ? FillFailure::NarrowTriangles : FillFailure::SelfIntersecting));
      loop.isSheetBoundary = true;  // its needles stay in a repair, too
      const FillFailure ofSheet = HoleFiller(mesh).propose(loop, {}).failure;
      QVERIFY(ofSheet == FillFailure::SelfIntersecting || (hasNeedle && ofSheet == FillFailure::Bulging));
    }
  }
}

HANDWHEEL_TEST(BoundaryNeedlesTest)
#include "BoundaryNeedlesTest.moc"
