// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/EdgeCollapse.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"
#include "mesh/structure/Shells.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

class EdgeCollapseTest : public QObject {
  Q_OBJECT

 private slots:
  void wholeFan();
  void anEdgeOfASphere();
  void smallestSurfaces();
  void bordersStayApart();
  void anEar();
  void largeFans();
  void topologyStays();
};

namespace {

bool collapses(HalfEdgeMesh& mesh, HalfEdge h, const Vec3& p) {
  if (!mesh.isProper(HalfEdgeMesh::face(h)) || !canCollapse(mesh, h)) return false;
  const Vertex kept = mesh.from(h);
  const HalfEdge leaving = collapseEdge(mesh, h, p);
  if (mesh.from(leaving) != kept || mesh.position(kept) != p) qFatal("it leaves another vertex");
  return true;
}

std::vector<HalfEdge> fanOf(const HalfEdgeMesh& mesh, HalfEdge h) {
  std::vector<HalfEdge> fan;
  forEachInFan(mesh, h, [&](HalfEdge g) {
    fan.push_back(g);
    return true;
  });
  return fan;
}

}  // namespace

void EdgeCollapseTest::wholeFan() {
  for (const TriangleSoup& soup : {test::icosphere(1), test::disc(7, 2), test::moebiusStrip(9, 2)}) {
    const HalfEdgeMesh mesh = buildMesh(soup).mesh;
    for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
      std::vector<HalfEdge> visited = fanOf(mesh, h), fan = mesh.fan(h);
      QCOMPARE(visited.front(), h);
      std::sort(visited.begin(), visited.end());
      std::sort(fan.begin(), fan.end());
      QCOMPARE(visited, fan);
    }
  }
}

void EdgeCollapseTest::anEdgeOfASphere() {
  HalfEdgeMesh mesh = buildMesh(test::icosphere(2)).mesh;
  const std::size_t faces = mesh.liveFaceCount();
  QVERIFY(collapses(mesh, 17, Vec3(0.5, 0.5, 0.5)));
  QCOMPARE(mesh.liveFaceCount(), faces - 2);
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(test::eulerCharacteristic(mesh), 2l);
}

// Surfaces without a collapsible edge: a tetrahedron, a triangle, two back to back.
void EdgeCollapseTest::smallestSurfaces() {
  TriangleSoup pillow{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}, {0, 2, 1}}};
  TriangleSoup one = pillow;
  one.triangles.pop_back();
  for (const TriangleSoup& soup : {test::tetrahedron(), pillow, one}) {
    const HalfEdgeMesh mesh = buildMesh(soup).mesh;
    for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) QVERIFY(!canCollapse(mesh, h));
  }
}

// Across a strip one cell wide, two borders would touch; around a hole of three edges it would close.
void EdgeCollapseTest::bordersStayApart() {
  const HalfEdgeMesh ring = buildMesh(test::annulus(3, 1, 1.0, 2.0)).mesh;
  for (HalfEdge h = 0; h < ring.halfEdgeSlots(); ++h) QVERIFY(!canCollapse(ring, h));
  const HalfEdgeMesh wide = buildMesh(test::annulus(4, 1, 1.0, 2.0)).mesh;
  for (HalfEdge h = 0; h < wide.halfEdgeSlots(); ++h) QCOMPARE(canCollapse(wide, h), wide.isBorder(h));
}

void EdgeCollapseTest::anEar() {
  const HalfEdgeMesh square =
      buildMesh({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}, {{0, 1, 2}, {0, 2, 3}}}).mesh;
  for (HalfEdge h = 0; h < 6; ++h) {
    HalfEdgeMesh mesh = square;
    const Vec3 p = mesh.position(mesh.from(h));
    QCOMPARE(collapses(mesh, h, p), square.isBorder(h));
    QCOMPARE(validate(mesh), std::string());
    QCOMPARE(mesh.liveFaceCount(), square.isBorder(h) ? std::size_t{1} : std::size_t{2});
    QCOMPARE(test::countBorder(mesh), square.isBorder(h) ? std::size_t{3} : std::size_t{4});
  }
}

void EdgeCollapseTest::largeFans() {
  const HalfEdgeMesh mesh = buildMesh(test::disc(20'000, 1)).mesh;
  const auto isMiddle = [&](Vertex v) { return mesh.position(v).isZero(); };
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    const bool isSpoke = isMiddle(mesh.from(h)) || isMiddle(mesh.to(h));
    QCOMPARE(canCollapse(mesh, h), !isSpoke);
  }
}

void EdgeCollapseTest::topologyStays() {
  QVERIFY(rc::check("random collapses keep parts, handles and holes", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const std::vector<TriangleSoup> shapes{test::icosphere(1),
                                           test::torus(7, 5),
                                           test::moebiusStrip(12, 2),
                                           test::sphereWithHoles(2, 3, 0.3),
                                           test::disc(6, 3),
                                           test::annulus(7, 2, 1.0, 2.0),
                                           test::kleinBottle(12, 8),
                                           test::cylinder(5, 3, 1.0, 2.0, false),
                                           test::randomBlocks(random, 8, 3)};
    HalfEdgeMesh mesh = buildMesh(*rc::gen::elementOf(shapes)).mesh;
    const long euler = test::eulerCharacteristic(mesh);
    const std::size_t pieces = findShells(mesh).size();
    for (int i = 0; i < 200; ++i) {
      const auto h = static_cast<HalfEdge>(random() % mesh.halfEdgeSlots());
      if (!mesh.isProper(HalfEdgeMesh::face(h)) || !canCollapse(mesh, h)) continue;
      // Apart from all others, so that positions tell vertices apart.
      const Vec3 p = 0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))) + Vec3::Constant(1e-6 * i);
      collapseEdge(mesh, h, p);
      RC_ASSERT(validate(mesh) == std::string());
    }
    RC_ASSERT(test::eulerCharacteristic(mesh) == euler);
    RC_ASSERT(findShells(mesh).size() == pieces);
    for (Face f = 0; f < mesh.faceSlots(); ++f) RC_ASSERT(!mesh.isLive(f) || mesh.isProper(f));
  }));
}

HANDWHEEL_TEST(EdgeCollapseTest)
#include "EdgeCollapseTest.moc"
