// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/HoleContext.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

namespace {

// Faces within three steps of the loop; each step goes from faces to all that share a vertex with one of them.
std::set<Face> threeRings(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) {
  std::set<Vertex> reached;
  for (HalfEdge h : loop.halfEdges) reached.insert(mesh.from(h));
  std::set<Face> faces;
  for (int ring = 0; ring < 3; ++ring) {
    std::set<Vertex> next = reached;
    for (Face f = 0; f < mesh.faceSlots(); ++f) {
      const Triangle& t = mesh.triangle(f);
      if (std::none_of(t.begin(), t.end(), [&](Vertex v) { return reached.contains(v); })) continue;
      faces.insert(f);
      next.insert(t.begin(), t.end());
    }
    reached = next;
  }
  return faces;
}

}  // namespace

class HoleContextTest : public QObject {
  Q_OBJECT

 private slots:
  void outwardOfALid();
  void aroundAHoleInASphere();
  void smallPart();
};

void HoleContextTest::aroundAHoleInASphere() {
  const HalfEdgeMesh mesh = buildMesh(test::sphereWithHoles(4, 2, 0.3)).mesh;
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  QCOMPARE(loops.size(), std::size_t{2});
  for (const BoundaryLoop& loop : loops) {
    const HoleContext hole = holeContext(mesh, loop);
    const std::size_t n = loop.halfEdges.size();
    QCOMPARE(hole.loopSize, n);
    QCOMPARE(hole.apexes.size(), n);
    QCOMPARE(hole.edgeLength.size(), n);
    Box box;
    for (const Vec3& p : hole.points) box.extend(p);
    QVERIFY(hole.ringBox.min() == box.min() && hole.ringBox.max() == box.max());
    for (std::size_t i = 0; i < n; ++i) {
      const HalfEdge h = loop.halfEdges[i];
      QVERIFY(hole.points[i] == mesh.position(mesh.from(h)));
      QVERIFY(hole.loop()[i] == hole.points[i]);
      const TrianglePoints p = mesh.points(HalfEdgeMesh::face(h));
      QVERIFY(hole.apexes[i] == p[(h + 2) % 3]);
    }
    // The ring's faces are those of three rings, with the same corners in the same turn.
    std::multiset<std::array<test::Coordinates, 3>> is, wanted;
    for (const Triangle& t : hole.ring)
      is.insert({test::coordinates(hole.points[t[0]]), test::coordinates(hole.points[t[1]]),
                 test::coordinates(hole.points[t[2]])});
    for (Face f : threeRings(mesh, loop)) {
      const TrianglePoints p = mesh.points(f);
      wanted.insert({test::coordinates(p[0]), test::coordinates(p[1]), test::coordinates(p[2])});
    }
    QVERIFY(is == wanted);
    std::set<test::Coordinates> different;
    for (const Vec3& p : hole.points) different.insert(test::coordinates(p));
    QCOMPARE(different.size(), hole.points.size());
  }
}

void HoleContextTest::smallPart() {
  TriangleSoup soup = test::tetrahedron();
  soup.triangles.pop_back();
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const HoleContext hole = holeContext(mesh, findBoundaryLoops(mesh).at(0));
  QCOMPARE(hole.points.size(), std::size_t{4});
  QCOMPARE(hole.ring.size(), std::size_t{3});
  QCOMPARE(hole.apexes.size(), std::size_t{3});
  for (const Vec3& apex : hole.apexes) QVERIFY(apex == Vec3::Zero());
}

// An open can: the lids look away from each other, with length 1 because they are flat and convex.
void HoleContextTest::outwardOfALid() {
  const HalfEdgeMesh mesh = buildMesh(test::cylinder(16, 3, 1.0, 2.0, false)).mesh;
  Vec3 sum = Vec3::Zero();
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  QCOMPARE(loops.size(), std::size_t{2});
  for (const BoundaryLoop& loop : loops) {
    const Vec3 outward = holeContext(mesh, loop).outward();
    QVERIFY(std::abs(outward.norm() - 1.0) < 1e-12);
    QVERIFY(std::abs(std::abs(outward.z()) - 1.0) < 1e-12);
    sum += outward;
  }
  QVERIFY(sum.norm() < 1e-12);
}

HANDWHEEL_TEST(HoleContextTest)
#include "HoleContextTest.moc"
