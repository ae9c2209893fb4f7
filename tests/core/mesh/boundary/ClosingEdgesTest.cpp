// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/ClosingEdges.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/boundary/Stitching.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

namespace {

TriangleSoup gridToTear(std::uint32_t n) {
  return test::grid(n, n, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0); });
}

VertexPairs pairsThatClose(const HalfEdgeMesh& mesh) {
  const VertexPairs near = nearBoundaryVertices(mesh);
  return closingPairs(near, closingEdges(mesh, near));
}

}  // namespace

class ClosingEdgesTest : public QObject {
  Q_OBJECT

 private slots:
  void ofASlit();
  void partnersOfARow();
  void noneWhereOnlyCornersMeet();
  void noneAlongAShortEdge();
  void runs();
  void manySheetsOverOneEdge();
};

// A sheet that is torn along a line, by less than the reach: all pairs along it but none elsewhere. Each edge takes the
// two pairs at its ends.
void ClosingEdgesTest::ofASlit() {
  TriangleSoup soup = gridToTear(5);
  test::append(soup, test::moved(soup, {4.0 + 1e-6, 0, 0}));
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const VertexPairs near = nearBoundaryVertices(mesh);
  QCOMPARE(near.size(), std::size_t{5});
  QVERIFY(pairsThatClose(mesh) == near);
  const std::vector<ClosingEdge> edges = closingEdges(mesh, near);
  QCOMPARE(edges.size(), std::size_t{4});
  for (const ClosingEdge& edge : edges) {
    QCOMPARE(edge.pairs.size(), std::size_t{2});
    QCOMPARE(edge.endPositions.size(), std::size_t{4});
  }
}

void ClosingEdgesTest::partnersOfARow() {
  TriangleSoup soup = gridToTear(5);
  test::append(soup, test::moved(soup, {4.0 + 1e-6, 0, 0}));
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const VertexPairs near = nearBoundaryVertices(mesh);
  const std::vector<ClosingEdge> edges = closingEdges(mesh, near);
  for (const auto& pair : near) {
    const VertexPairs both = withPartners({pair}, near, edges);
    QCOMPARE(both.size(), std::size_t{2});
    QVERIFY(std::find(both.begin(), both.end(), pair) != both.end());
    // They are neighbours along the tear.
    QCOMPARE((mesh.position(both[0].first) - mesh.position(both[1].first)).norm(), 1.0);
  }
  QVERIFY(withPartners(near, near, edges) == near);
}

// Two squares whose corners are nearer than the reach share no edge when they are merged.
void ClosingEdgesTest::noneWhereOnlyCornersMeet() {
  TriangleSoup soup = gridToTear(3);
  test::append(soup, test::moved(soup, {2.0 + 1e-6, 2.0 + 1e-6, 0}));
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  QCOMPARE(nearBoundaryVertices(mesh).size(), std::size_t{1});
  QVERIFY(pairsThatClose(mesh).empty());
  QVERIFY(closingEdges(mesh, {}).empty());
}

// An edge of the border that is shorter than the reach stays, unless a tear beside it closes only with its ends merged.
void ClosingEdgesTest::noneAlongAShortEdge() {
  const TriangleSoup soup{{{0, 0, 0}, {1e-6, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}, {1, 2, 3}}};
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  QCOMPARE(nearBoundaryVertices(mesh), (VertexPairs{{0, 1}}));
  QVERIFY(pairsThatClose(mesh).empty());
  HalfEdgeMesh stitched = mesh;
  QVERIFY(stitchBoundaries(stitched, {}).empty());
  QCOMPARE(stitched.liveFaceCount(), std::size_t{2});

  TriangleSoup torn = soup;
  test::append(torn, {{{1, 1e-6, 0}, {0, 1e-6, 0}, {0, -1, 0}}, {{0, 1, 2}}});
  HalfEdgeMesh joined = buildMesh(torn).mesh;
  stitchBoundaries(joined, {});
  QCOMPARE(joined.liveFaceCount(), std::size_t{2});  // the one at the short edge shrinks
  QCOMPARE(findBoundaryLoops(joined).size(), std::size_t{1});
  QCOMPARE(findBoundaryLoops(joined)[0].halfEdges.size(), std::size_t{4});
}

// Two tears, which share no pair, are two runs.
void ClosingEdgesTest::runs() {
  const TriangleSoup sheet = gridToTear(5);
  TriangleSoup soup = sheet;
  test::append(soup, test::moved(sheet, {4.0 + 1e-6, 0, 0}));
  test::append(soup, test::moved(sheet, {8.0 + 2e-6, 0, 0}));
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const VertexPairs near = nearBoundaryVertices(mesh);
  const auto runs = connectedRuns(closingEdges(mesh, near), near.size());
  QCOMPARE(runs.size(), std::size_t{2});
  for (const std::vector<ClosingEdge>& run : runs) QCOMPARE(run.size(), std::size_t{4});
}

// The pairs of a stack of sheets over one edge are each named once.
void ClosingEdgesTest::manySheetsOverOneEdge() {
  TriangleSoup soup;
  const int sheets = 200;
  for (int i = 0; i < sheets; ++i) {
    const double angle = 3.0 * i / sheets, shift = i * 1e-9;
    const Vec3 out(std::cos(angle), std::sin(angle), 0.5);
    test::append(soup, {{Vec3(0, 0, shift), Vec3(0, shift, 1), out}, {i % 2 ? Triangle{0, 1, 2} : Triangle{1, 0, 2}}});
  }
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const VertexPairs near = nearBoundaryVertices(mesh);
  const std::vector<ClosingEdge> edges = closingEdges(mesh, near);
  QCOMPARE(edges.size(), std::size_t{1});
  std::set<std::size_t> distinct(edges[0].pairs.begin(), edges[0].pairs.end());
  QCOMPARE(distinct.size(), edges[0].pairs.size());
  QCOMPARE(closingPairs(near, edges).size(), near.size());
}

HANDWHEEL_TEST(ClosingEdgesTest)
#include "ClosingEdgesTest.moc"
