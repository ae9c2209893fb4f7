// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/defects/Defects.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

namespace {

Defects defectsOf(const TriangleSoup& s) {
  return findDefects(buildMesh(s).mesh);
}

}  // namespace

class DefectsTest : public QObject {
  Q_OBJECT

 private slots:
  void soundShapes_data();
  void soundShapes();
  void touchingCubes();
  void nonOrientable();
  void inconsistent();
  void threeFacesAtAnEdge();
  void badFaces();
  void nearVertices();
  void components();
  void volumeFarAway();
  void boxOfWhatIsThere();
  void selfIntersections();
};

void DefectsTest::soundShapes_data() {
  QTest::addColumn<TriangleSoup>("soup");
  QTest::addColumn<int>("loops");
  QTest::newRow("cube") << test::cube() << 0;
  QTest::newRow("torus") << test::torus(8, 6) << 0;
  QTest::newRow("disc") << test::disc(8, 3) << 1;
  QTest::newRow("sphere with holes") << test::sphereWithHoles(3, 4, 0.4) << 4;
}

void DefectsTest::soundShapes() {
  QFETCH(TriangleSoup, soup);
  QFETCH(int, loops);
  const Defects d = defectsOf(soup);
  QCOMPARE(d.loops.size(), std::size_t(loops));
  QVERIFY(d.nonManifoldEdges.empty() && d.nonManifoldVertices.empty() && d.degenerateFaces.empty());
  QVERIFY(d.duplicateFaces.empty() && d.nearVertices.empty());
  QCOMPARE(d.components.size(), std::size_t{1});
  QVERIFY(!d.components[0].debris);
  QCOMPARE(d.components[0].faceCount, soup.triangles.size());
  QVERIFY(std::abs(d.components[0].area - test::area(soup)) < 1e-9);
}

void DefectsTest::touchingCubes() {
  const HalfEdgeMesh mesh = buildMesh(test::twoCubesSharingAnEdge()).mesh;
  const Defects edge = findDefects(mesh);
  QCOMPARE(edge.nonManifoldEdges.size(), std::size_t{1});
  const auto [a, b] = edge.nonManifoldEdges[0];
  const std::set<test::Coordinates> ends = {test::coordinates(mesh.position(a)), test::coordinates(mesh.position(b))};
  QVERIFY(ends == (std::set<test::Coordinates>{{1, 1, 0}, {1, 1, 1}}));
  QVERIFY(edge.nonManifoldVertices.empty());  // the edge accounts for them

  const HalfEdgeMesh corner = buildMesh(test::twoCubesSharingAVertex()).mesh;
  const Defects vertex = findDefects(corner);
  QVERIFY(vertex.nonManifoldEdges.empty());
  QCOMPARE(vertex.nonManifoldVertices.size(), std::size_t{1});
  QVERIFY(corner.position(vertex.nonManifoldVertices[0]) == Vec3(1, 1, 1));
}

// Around each vertex of these surfaces the faces hang together; only the mesh had to cut them, along its seams.
void DefectsTest::nonOrientable() {
  for (const TriangleSoup& s : {test::moebiusStrip(24, 3), test::kleinBottle(20, 8)}) {
    const Defects d = defectsOf(s);
    QVERIFY(d.nonManifoldEdges.empty());
    QVERIFY(!d.nonOrientableEdges.empty());
    QCOMPARE(d.nonManifoldVertices.size(), std::size_t{0});
  }
  for (const TriangleSoup& s : {test::cube(), test::disc(7, 2), test::boxWithInnerWall()})
    QVERIFY(defectsOf(s).nonOrientableEdges.empty());
}

// In a cube with two reversed neighbours these two are found; in one with eleven reversed faces, the twelfth. They
// cause no holes.
void DefectsTest::inconsistent() {
  for (const std::vector<Face>& odd : {std::vector<Face>{2, 3}, std::vector<Face>{7}}) {
    HalfEdgeMesh mesh = buildMesh(test::cube()).mesh;
    if (odd.size() == 1) mesh = buildMesh(test::turnedOver(test::cube())).mesh;
    reverseFaces(mesh, odd);
    const Defects d = findDefects(mesh);
    QCOMPARE(d.inconsistentFaces, odd);
    QCOMPARE(findInconsistentFaces(mesh), odd);
    QVERIFY(d.loops.empty() && d.nonOrientableEdges.empty() && d.nonManifoldEdges.empty());
    QVERIFY(!d.state(0).oriented && d.state(0).closed);
  }
  QVERIFY(defectsOf(test::cube()).inconsistentFaces.empty());
  QVERIFY(defectsOf(test::moebiusStrip(24, 3)).inconsistentFaces.empty());
}

void DefectsTest::threeFacesAtAnEdge() {
  const Defects d = defectsOf(test::boxWithInnerWall());
  QCOMPARE(d.nonManifoldEdges.size(), std::size_t{4});
  QVERIFY(d.loops.empty());
  QVERIFY(d.nonManifoldVertices.empty());
}

void DefectsTest::badFaces() {
  TriangleSoup s = test::cube();
  s.points.push_back(Vec3(0.5, 0, 0));
  s.triangles.push_back({0, 8, 1});                                                  // 12: a needle
  s.triangles.push_back({2, 2, 3});                                                  // 13
  s.triangles.push_back(s.triangles[3]);                                             // 14: doubled
  s.triangles.push_back({s.triangles[3][1], s.triangles[3][0], s.triangles[3][2]});  // 15: and turned
  const Defects d = defectsOf(s);
  QCOMPARE(d.degenerateFaces, std::vector<Face>({12, 13}));
  QVERIFY(d.duplicateFaces == std::vector<Face>({14, 15}));
}

void DefectsTest::nearVertices() {
  TriangleSoup s = test::cube();
  std::erase_if(s.triangles, [&](const Triangle& t) { return t[0] < 4 && t[1] < 4 && t[2] < 4; });  // the side z = 0
  TriangleSoup lid = test::cube();
  lid.triangles.resize(2);
  lid.points.resize(4);
  test::append(s, test::moved(lid, Vec3(1e-7, 0, 0)));
  const HalfEdgeMesh mesh = buildMesh(s).mesh;
  const Defects d = findDefects(mesh);
  QCOMPARE(d.nearVertices.size(), std::size_t{4});
  for (const auto& [a, b] : d.nearVertices) {
    QVERIFY(a < b);
    const double distance = (mesh.position(a) - mesh.position(b)).norm();
    QVERIFY(distance > 0 && distance < 2e-7);
  }
}

void DefectsTest::components() {
  TriangleSoup s = test::moved(test::tetrahedron(), Vec3(9, 0, 0), 0.01);
  test::append(s, test::icosphere(4));
  test::append(s, test::moved(test::cube(), Vec3(0, 5, 0), 0.5));
  const Defects d = defectsOf(s);
  QCOMPARE(d.components.size(), std::size_t{3});
  QCOMPARE(d.components[0].faceCount, std::size_t{5120});
  QCOMPARE(d.components[1].faceCount, std::size_t{12});
  QCOMPARE(d.components[2].faceCount, std::size_t{4});
  QCOMPARE(d.components[2].faces, std::vector<Face>({0, 1, 2, 3}));  // those of debris alone are listed
  QVERIFY(d.components[0].faces.empty() && d.components[1].faces.empty());
  QVERIFY(std::abs(d.components[1].area - 1.5) < 1e-12);
  QVERIFY(std::abs(d.components[1].volume - 0.125) < 1e-12);
  QVERIFY(std::abs(d.components[0].volume - test::volume(test::icosphere(4))) < 1e-9);
  QVERIFY(!d.components[0].debris && !d.components[1].debris && d.components[2].debris);
}

// Exact where all corners are, however far from the origin; negative inside out.
void DefectsTest::volumeFarAway() {
  for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1e9, -1e9, 1e9), Vec3(-1e12, 0, 1e12)}) {
    const TriangleSoup cube = test::cube(2.0, corner);
    QCOMPARE(findComponents(buildMesh(cube).mesh).at(0).volume, 8.0);
    QCOMPARE(findComponents(buildMesh(test::turnedOver(cube)).mesh).at(0).volume, -8.0);
  }
}

void DefectsTest::boxOfWhatIsThere() {
  HalfEdgeMesh mesh = buildMesh(test::cube(2.0, Vec3(1, 2, 3))).mesh;
  mesh.addVertex(Vec3(99, 0, 0));  // used by nobody
  const InspectedMesh seen = inspected(mesh);
  QVERIFY(seen.defects->box.min() == Vec3(1, 2, 3) && seen.defects->box.max() == Vec3(3, 4, 5));
  QVERIFY(test::sameMesh(seen.mesh, mesh));
  QVERIFY(findDefects(HalfEdgeMesh()).box.isEmpty());
  QVERIFY(findDefects(HalfEdgeMesh()).components.empty());
}

void DefectsTest::selfIntersections() {
  TriangleSoup s = test::cube();
  test::append(s, test::moved(test::tetrahedron(), Vec3(0.9, 0.4, 0.4)));  // pierces the side x = 1
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  mesh.removeFace(0);  // numbers of faces must not shift
  const auto pairs = findSelfIntersections(mesh);
  QVERIFY(pairs && !pairs->empty());
  for (const auto& [a, b] : *pairs) {
    QVERIFY(a < 12 && b >= 12);
    QVERIFY(trianglesMeet(mesh.points(a), mesh.points(b)));
  }
  JobState job;
  job.cancelled = true;
  QVERIFY(!findSelfIntersections(mesh, Progress(job)));
}

HANDWHEEL_TEST(DefectsTest)
#include "DefectsTest.moc"
