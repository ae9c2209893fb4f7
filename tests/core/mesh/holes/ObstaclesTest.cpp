// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/Obstacles.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

namespace {

Patch triangleAt(const Vec3& centre, double size) {
  Patch patch;
  patch.loopSize = 3;
  patch.points = {centre + size * Vec3(1, 0, 0), centre + size * Vec3(0, 1, 0), centre + size * Vec3(0, 0, 1)};
  patch.triangles = {{0, 1, 2}};
  return patch;
}

}  // namespace

class ObstaclesTest : public QObject {
  Q_OBJECT

 private slots:
  void againstAllFaces();
  void addedPatches();
  void patchThatMeetsItself();
  void facesWithoutArea();
  void verticesThere();
  void edgesAmong();
};

void ObstaclesTest::againstAllFaces() {
  const HalfEdgeMesh mesh = buildMesh(test::icosphere(2)).mesh;
  const Obstacles obstacles(mesh);
  int hitting = 0, missing = 0;
  QVERIFY(rc::check("a triangle hits exactly when it meets a face", [&] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto unit = [&] { return 3.0 * (random() / 4294967296.0) - 1.5; };
    TrianglePoints t;
    const double size = *rc::gen::element(0.05, 0.3, 1.0);
    const Vec3 centre(unit(), unit(), unit());
    for (Vec3& p : t) p = centre + size * Vec3(unit(), unit(), unit());
    if (random() % 3 == 0) t[0] = mesh.position(random() % mesh.vertexSlots());  // shares a corner
    bool meets = false;
    for (Face f = 0; f < mesh.faceSlots() && !meets; ++f) meets = trianglesMeet(t, mesh.points(f));
    RC_ASSERT(obstacles.hits(t) == meets);
    ++(meets ? hitting : missing);
  }));
  QVERIFY(hitting > 0 && missing > 0);
}

void ObstaclesTest::addedPatches() {
  Obstacles obstacles(buildMesh(test::cube()).mesh);
  const Patch patch = triangleAt(Vec3(5, 5, 5), 1.0);
  QVERIFY(!obstacles.hits(patch));
  obstacles.add(patch);
  const Vec3 middle = Vec3(5, 5, 5) + Vec3::Constant(1.0 / 3.0);
  QVERIFY(obstacles.hits(TrianglePoints{middle, middle + Vec3(1, 1, 1), middle + Vec3(1, 2, 1)}));
  QVERIFY(!obstacles.hits(TrianglePoints{Vec3(9, 9, 9), Vec3(9, 9, 8), Vec3(9, 8, 9)}));
  // A neighbour that shares an edge with it is free.
  QVERIFY(!obstacles.hits(TrianglePoints{patch.points[1], patch.points[0], Vec3(6, 6, 4)}));
}

void ObstaclesTest::patchThatMeetsItself() {
  const Obstacles obstacles(buildMesh(test::cube()).mesh);
  Patch patch = triangleAt(Vec3(5, 5, 5), 1.0);
  patch.points.insert(patch.points.end(), {Vec3(5, 5, 5), Vec3(7, 7, 7), Vec3(7, 8, 7)});
  patch.triangles.push_back({3, 4, 5});
  QVERIFY(obstacles.hits(patch));
}

void ObstaclesTest::facesWithoutArea() {
  TriangleSoup soup = test::cube();
  soup.points.push_back(Vec3(3, 0, 0));
  soup.triangles.push_back({0, 1, 8});  // a needle that leaves the cube along the x axis
  const Obstacles obstacles(buildMesh(soup).mesh);
  QVERIFY(!obstacles.hits(TrianglePoints{Vec3(2, -1, -1), Vec3(2, 1, -1), Vec3(2, 0, 1)}));
}

void ObstaclesTest::verticesThere() {
  Obstacles obstacles(buildMesh(test::cube()).mesh);
  for (const Vec3& p : test::cube().points) QVERIFY(obstacles.hasVertexAt(p));
  // On an edge, inside a face, and next to a corner.
  for (const Vec3& p : {Vec3(0.5, 0, 0), Vec3(0.5, 0.25, 0), Vec3(std::nextafter(1.0, 2.0), 1, 1), Vec3(9, 9, 9)})
    QVERIFY(!obstacles.hasVertexAt(p));
  const Patch patch = triangleAt(Vec3(5, 5, 5), 1.0);
  obstacles.add(patch);
  for (const Vec3& p : patch.points) QVERIFY(obstacles.hasVertexAt(p));
}

void ObstaclesTest::edgesAmong() {
  QVERIFY(rc::check("the edges that join points, by number", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const HalfEdgeMesh mesh =
        buildMesh(*rc::gen::element(test::icosphere(1), test::torus(6, 5), test::disc(6, 3))).mesh;
    std::vector<Vertex> chosen;
    for (Vertex v = 0; v < mesh.vertexSlots(); ++v)
      if (random() % 3 == 0) chosen.push_back(v);
    std::shuffle(chosen.begin(), chosen.end(), random);
    std::vector<Vec3> points;
    std::map<Vertex, std::uint32_t> number;
    for (Vertex v : chosen) {
      number[v] = static_cast<std::uint32_t>(points.size());
      points.push_back(mesh.position(v));
    }
    points.push_back(Vec3(50, 50, 50));  // not of the mesh
    std::set<std::pair<std::uint32_t, std::uint32_t>> wanted;
    for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
      if (number.contains(mesh.from(h)) && number.contains(mesh.to(h)))
        wanted.insert(std::minmax(number[mesh.from(h)], number[mesh.to(h)]));
    const auto found = Obstacles(mesh).edgesAmong(points);
    RC_ASSERT(std::is_sorted(found.begin(), found.end()));
    RC_ASSERT(std::vector(wanted.begin(), wanted.end()) == found);
  }));
}

HANDWHEEL_TEST(ObstaclesTest)
#include "ObstaclesTest.moc"
