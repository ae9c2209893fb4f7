// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshShapes.h"
#include "RepairChecks.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

// Tests the vertices that a repair moves, and its report of them.
class RepairMovesTest : public QObject {
  Q_OBJECT

 private slots:
  void touchedIsWhatWasMoved();
  void touchingRimToBeKeptStays();
};

// A corner that is separated is touched, and its copy, but not the vertices of debris that is removed.
void RepairMovesTest::touchedIsWhatWasMoved() {
  TriangleSoup soup = test::icosphere(3);
  const Vec3 tip = soup.points.front();
  TriangleSoup cube = test::cube(0.5);
  // Outside of the ball: it touches with the corner that looks to its middle.
  for (Vec3& p : cube.points)
    p = Vec3(p.x() * (tip.x() < 0 ? -1 : 1), p.y() * (tip.y() < 0 ? -1 : 1), p.z() * (tip.z() < 0 ? -1 : 1));
  test::append(soup, test::moved(cube, tip));
  test::append(soup, test::moved(test::cube(1e-3), Vec3(3, 3, 3)));
  const HalfEdgeMesh input = buildMesh(soup).mesh;
  QCOMPARE(findDefects(input).nonManifoldVertices.size(), std::size_t{1});
  HalfEdgeMesh mesh = input;
  RepairOptions options;
  options.removeDebris = true;
  const RepairReport report = repair(mesh, options);
  QVERIFY(report.removedDebris > 0);
  QCOMPARE(report.separatedVertices, std::size_t{1});
  QCOMPARE(report.modifiedVertices.size(), std::size_t{2});
  for (const Vertex v : report.modifiedVertices) QVERIFY(input.position(v) == tip);
}

// Two triangles that only touch, in a hole that is to stay open: none of its vertices is moved.
void RepairMovesTest::touchingRimToBeKeptStays() {
  TriangleSoup soup = test::icosphere(3);
  // Two faces at a vertex that share no edge there: their holes touch.
  const std::uint32_t hub = soup.triangles.front()[0];
  std::vector<std::size_t> around;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i)
    if (std::find(soup.triangles[i].begin(), soup.triangles[i].end(), hub) != soup.triangles[i].end())
      around.push_back(i);
  const auto sharesEdge = [&](std::size_t a, std::size_t b) {
    int common = 0;
    for (const std::uint32_t v : soup.triangles[a])
      common += std::find(soup.triangles[b].begin(), soup.triangles[b].end(), v) != soup.triangles[b].end();
    return common > 1;
  };
  const std::size_t first = around.front();
  const auto second =
      std::find_if(around.begin() + 1, around.end(), [&](std::size_t i) { return !sharesEdge(first, i); });
  QVERIFY(second != around.end());
  const std::size_t other = *second;
  soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(std::max(first, other)));
  soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(std::min(first, other)));
  const HalfEdgeMesh input = buildMesh(soup).mesh;
  QCOMPARE(findDefects(input).nonManifoldVertices.size(), std::size_t{1});
  HalfEdgeMesh mesh = input;
  RepairOptions options;
  for (const BoundaryLoop& loop : findBoundaryLoops(input)) options.keepOpen.insert(loop.id);
  const RepairReport report = repair(mesh, options);
  QCOMPARE(report.separatedVertices, std::size_t{0});
  QVERIFY(report.modifiedVertices.empty());
  QVERIFY(test::sameMesh(mesh, input));
  // Nobody keeps them: then they are closed, and nothing touches.
  mesh = input;
  repair(mesh, {});
  QVERIFY(test::countEdges(mesh).sound());
}

HANDWHEEL_TEST(RepairMovesTest)
#include "RepairMovesTest.moc"
