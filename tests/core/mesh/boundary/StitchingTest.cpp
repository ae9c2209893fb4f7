// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/Stitching.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/defects/Defects.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"
#include "mesh/structure/PositionKey.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

namespace {

// A unit cube whose six sides have corners of their own, each shifted by at most `apart`.
TriangleSoup looseCube(double apart, std::uint32_t seed = 1) {
  std::mt19937 random(seed);
  const TriangleSoup cube = test::cube();
  TriangleSoup s;
  for (std::size_t side = 0; side < 6; ++side) {
    std::map<std::uint32_t, std::uint32_t> number;
    for (std::size_t f : {2 * side, 2 * side + 1}) {
      Triangle t = cube.triangles[f];
      for (std::uint32_t& v : t) {
        const auto [at, isNew] = number.try_emplace(v, static_cast<std::uint32_t>(s.points.size()));
        if (isNew) {
          const Vec3 shift(random() / 4294967296.0, random() / 4294967296.0, random() / 4294967296.0);
          s.points.push_back(cube.points[v] + apart * (shift - Vec3::Constant(0.5)));
        }
        v = at->second;
      }
      s.triangles.push_back(t);
    }
  }
  return s;
}

// Replaces a triangle's edge by edges through the points at these shares of it: the neighbour keeps the long edge.
void split(TriangleSoup& s, std::size_t f, int corner, const std::vector<double>& shares) {
  const Triangle t = s.triangles[f];
  const std::uint32_t a = t[corner], b = t[(corner + 1) % 3], apex = t[(corner + 2) % 3];
  std::uint32_t last = a;
  std::vector<Triangle> fan;
  for (double w : shares) {
    const auto v = static_cast<std::uint32_t>(s.points.size());
    s.points.push_back((1.0 - w) * s.points[a] + w * s.points[b]);
    fan.push_back({last, v, apex});
    last = v;
  }
  fan.push_back({last, b, apex});
  s.triangles[f] = fan.front();
  s.triangles.insert(s.triangles.end(), fan.begin() + 1, fan.end());
}

std::vector<Vertex> stitch(HalfEdgeMesh& mesh) {
  return stitchBoundaries(mesh, std::vector<bool>(mesh.vertexSlots(), false));
}

}  // namespace

class StitchingTest : public QObject {
  Q_OBJECT

 private slots:
  void roundedApart();
  void tooFarApart();
  void tJunction();
  void severalOnOneEdge();
  void severalEdgesOfOneFace();
  void slightlyOffTheEdge();
  void keptOpenStays();
  void shapesInPieces();
  void nothingToGain();
  void verticesBeyondTheFixedOnes();
  void cornersThatOnlyTouchStay();
  void refusedPairsHideNone();
  void aTearWithAVertexMoreOnOneSide();
};

void StitchingTest::roundedApart() {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const HalfEdgeMesh before = buildMesh(looseCube(1e-7, seed)).mesh;
    QCOMPARE(test::countBorder(before), std::size_t{24});
    HalfEdgeMesh mesh = before;
    const std::vector<Vertex> moved = stitch(mesh);
    QCOMPARE(validate(mesh), std::string());
    QVERIFY(test::countEdges(mesh).sound());
    QCOMPARE(moved.size(), std::size_t{24 - 8});
    QCOMPARE(test::eulerCharacteristic(mesh), 2l);
    QVERIFY(std::abs(test::volume(mesh.compact().soup) - 1.0) < 1e-6);
    // Unmoved vertices keep their positions; moved ones are at the old position of a nearby vertex.
    const std::set<Vertex> movedSet(moved.begin(), moved.end());
    for (Vertex v = 0; v < before.vertexSlots(); ++v) {
      if (!movedSet.contains(v))
        QVERIFY(test::sameBits(mesh.position(v), before.position(v)));
      else
        QVERIFY((mesh.position(v) - before.position(v)).norm() < 1e-6);
    }
  }
}

void StitchingTest::tooFarApart() {
  // Ten times the reach, which is a share of the diagonal.
  const HalfEdgeMesh before = buildMesh(looseCube(40 * tolerance::kNearWeld)).mesh;
  std::size_t near = 0;
  for (Vertex v = 0; v < before.vertexSlots(); ++v)
    for (Vertex u = 0; u < v; ++u) near += (before.position(u) - before.position(v)).norm() < 2 * tolerance::kNearWeld;
  QCOMPARE(near, std::size_t{0});
  HalfEdgeMesh mesh = before;
  QVERIFY(stitch(mesh).empty());
  QVERIFY(test::sameMesh(mesh, before));
}

void StitchingTest::tJunction() {
  for (std::size_t f = 0; f < 12; ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      TriangleSoup s = test::cube();
      split(s, f, corner, {0.5});
      HalfEdgeMesh mesh = buildMesh(s).mesh;
      QCOMPARE(test::countBorder(mesh), std::size_t{3});
      QVERIFY(stitch(mesh).empty());
      QCOMPARE(validate(mesh), std::string());
      QVERIFY(test::countEdges(mesh).sound());
      QCOMPARE(mesh.liveFaceCount(), std::size_t{14});
      QVERIFY(std::abs(test::volume(mesh.compact().soup) - 1.0) < 1e-12);
    }
  }
}

void StitchingTest::severalOnOneEdge() {
  TriangleSoup s = test::cube();
  split(s, 4, 0, {0.25, 0.5, 0.625, 0.75});
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  QVERIFY(stitch(mesh).empty());
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(test::countEdges(mesh).sound());
  QVERIFY(std::abs(test::volume(mesh.compact().soup) - 1.0) < 1e-12);
}

// The base of a tetrahedron is one triangle, its neighbours have a vertex in the middle of each edge.
void StitchingTest::severalEdgesOfOneFace() {
  for (int edges = 1; edges <= 3; ++edges) {
    TriangleSoup s = test::tetrahedron();
    if (edges > 0) split(s, 0, 1, {0.5});  // the edge 2→1 of {0, 2, 1}
    if (edges > 1) split(s, 1, 1, {0.5});
    if (edges > 2) split(s, 2, 1, {0.5});
    HalfEdgeMesh mesh = buildMesh(s).mesh;
    QCOMPARE(test::countBorder(mesh), std::size_t(3 * edges));
    QVERIFY(stitch(mesh).empty());
    QCOMPARE(validate(mesh), std::string());
    QVERIFY2(test::countEdges(mesh).sound(), qPrintable(QString("%1 edges of a face").arg(edges)));
    QVERIFY(std::abs(test::volume(mesh.compact().soup) - 1.0 / 6.0) < 1e-12);
  }
}

void StitchingTest::slightlyOffTheEdge() {
  TriangleSoup s = test::cube();
  split(s, 4, 0, {0.5});
  s.points.back() += Vec3(0, -1e-6, 1e-6);
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  stitch(mesh);
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(test::countEdges(mesh).sound());
  QVERIFY(std::abs(test::volume(mesh.compact().soup) - 1.0) < 1e-5);
}

void StitchingTest::keptOpenStays() {
  const HalfEdgeMesh before = buildMesh(looseCube(1e-7)).mesh;
  HalfEdgeMesh mesh = before;
  QVERIFY(stitchBoundaries(mesh, std::vector<bool>(before.vertexSlots(), true)).empty());
  QVERIFY(test::sameMesh(mesh, before));

  std::vector<bool> firstSide(before.vertexSlots(), false);
  for (Face f : {0u, 1u})
    for (Vertex v : before.triangle(f)) firstSide[v] = true;
  const std::vector<Vertex> moved = stitchBoundaries(mesh, firstSide);
  QVERIFY(!moved.empty());
  for (Vertex v : moved) QVERIFY(!firstSide[v]);
  for (Vertex v = 0; v < before.vertexSlots(); ++v)
    if (firstSide[v]) QVERIFY(test::sameBits(mesh.position(v), before.position(v)));
  QCOMPARE(test::countBorder(mesh), std::size_t{8});  // the first side's edges and the others' around it
  QCOMPARE(validate(mesh), std::string());
}

void StitchingTest::shapesInPieces() {
  QVERIFY(rc::check("a closed shape in pieces, whose borders were rounded apart, closes again", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const TriangleSoup whole = *rc::gen::element(test::icosphere(2), test::torus(16, 10), test::uvSphere(12, 8));
    const std::vector<Vec3> centres = test::directions(*rc::gen::inRange(2, 8));
    const double apart = *rc::gen::element(1e-9, 1e-7, 1e-6);
    TriangleSoup s;
    std::map<std::pair<std::size_t, std::uint32_t>, std::uint32_t> number;  // number of each piece's copy of a point
    for (Triangle t : whole.triangles) {
      const Vec3 middle = (whole.points[t[0]] + whole.points[t[1]] + whole.points[t[2]]) / 3.0;
      std::size_t piece = 0;
      for (std::size_t i = 0; i < centres.size(); ++i)
        if ((centres[i] - middle).norm() < (centres[piece] - middle).norm()) piece = i;
      for (std::uint32_t& v : t) {
        const auto [at, isNew] = number.try_emplace({piece, v}, static_cast<std::uint32_t>(s.points.size()));
        if (isNew) {
          const auto shift = [&] { return apart * (random() / 4294967296.0 - 0.5); };
          s.points.push_back(whole.points[v] + Vec3(shift(), shift(), shift()));
        }
        v = at->second;
      }
      s.triangles.push_back(t);
    }
    HalfEdgeMesh mesh = buildMesh(s).mesh;
    RC_ASSERT(test::countBorder(mesh) > std::size_t{0});
    stitch(mesh);
    RC_ASSERT(validate(mesh) == std::string());
    RC_ASSERT(test::countEdges(mesh).sound());
    RC_ASSERT(test::allCoordinates(mesh.compact().soup).size() == whole.points.size());
    RC_ASSERT(test::eulerCharacteristic(mesh) == test::eulerCharacteristic(whole));
  }));
}

void StitchingTest::nothingToGain() {
  for (const TriangleSoup& s :
       {test::cube(), test::sphereWithHoles(3, 3, 0.4), test::disc(12, 3), test::boxWithInnerWall()}) {
    const HalfEdgeMesh before = buildMesh(s).mesh;
    HalfEdgeMesh mesh = before;
    QVERIFY(stitch(mesh).empty());
    QVERIFY(test::sameMesh(mesh, before));
  }
}

// A mesh may have grown vertices since the fixed ones were marked.
void StitchingTest::verticesBeyondTheFixedOnes() {
  HalfEdgeMesh mesh = buildMesh(looseCube(1e-7)).mesh;
  QCOMPARE(stitchBoundaries(mesh, {}).size(), std::size_t{24 - 8});
  QVERIFY(test::countEdges(mesh).sound());
}

// A tear is closed; squares that only come near each other at a corner are not moved.
void StitchingTest::cornersThatOnlyTouchStay() {
  TriangleSoup s = looseCube(1e-7);
  const TriangleSoup square =
      test::grid(2, 2, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0); });
  for (int i = 0; i < 12; ++i) test::append(s, test::moved(square, Vec3(3 + i * (1 + 1e-7), i * (1 + 1e-7), 0)));
  const HalfEdgeMesh before = buildMesh(s).mesh;
  HalfEdgeMesh mesh = before;
  const std::vector<Vertex> moved = stitch(mesh);
  QCOMPARE(moved.size(), std::size_t{24 - 8});
  for (const Vertex v : moved) QVERIFY(before.position(v).x() < 2);
  QVERIFY(findDefects(mesh).nonManifoldVertices.empty());
}

// Edges that must not be closed, since four faces would meet there, come first in number; the tear after them is
// closed, however many there are, and one edge of the same run that must not be closed does not keep the rest open.
void StitchingTest::refusedPairsHideNone() {
  TriangleSoup s;
  const auto triangle = [&](const Vec3& a, const Vec3& b, const Vec3& c) { test::append(s, {{a, b, c}, {{0, 1, 2}}}); };
  const int refused = 100;
  for (int i = 0; i < refused; ++i) {
    // Two faces that share an edge, and another that comes near it: a third face there.
    const Vec3 p(3.0 * i, 0, 0), q = p + Vec3(0, 1, 0), off(0, 0, 1e-5);
    triangle(p, q, p + Vec3(1, 0, 0));
    triangle(q, p, p + Vec3(-1, 0, 0));
    triangle(p + off, q + off, p + Vec3(0, 0.5, 1));
    triangle(q + off + off, p + off + off, p + Vec3(0.3, 0.5, 1));
  }
  const TriangleSoup sheet =
      test::grid(5, 5, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j + 20, 0); });
  test::append(s, sheet);
  test::append(s, test::moved(sheet, {4.0 + 1e-5, 0, 0}));
  // A fin on one edge of the tear.
  test::append(s, {{Vec3(4, 21, 0), Vec3(4, 22, 0), Vec3(4, 21.5, 1)}, {{0, 1, 2}}});
  test::append(s, {{Vec3(4, 22, 0), Vec3(4, 21, 0), Vec3(4.2, 21.5, 1)}, {{0, 1, 2}}});
  const HalfEdgeMesh before = buildMesh(s).mesh;
  HalfEdgeMesh mesh = before;
  stitch(mesh);
  QCOMPARE(validate(mesh), std::string());
  std::size_t closed = 0, most = 0;
  std::map<EdgeKey, std::size_t> faces;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
    if (mesh.isProper(HalfEdgeMesh::face(h))) ++faces[positionKey(mesh, h)];
  for (const auto& [edge, count] : faces) {
    closed += count == 2 && edge[0][0] == 4.0 && edge[1][0] == 4.0 && edge[0][1] >= 20.0;
    most = std::max(most, count);
  }
  QVERIFY(closed >= 2);
  QVERIFY2(most <= 4, qPrintable(QString::number(most)));
}

// A–B against A′–M–B′, whose ends rounding has moved apart: M lies on A–B, but merging alone closes nothing.
void StitchingTest::aTearWithAVertexMoreOnOneSide() {
  const double apart = 1e-6;
  TriangleSoup s{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, -1, 0), Vec3(0, apart, 0), Vec3(0.5, apart / 2, 0),
                  Vec3(1, apart, 0), Vec3(0.5, 1, 0)},
                 {{1, 0, 2}, {3, 4, 6}, {4, 5, 6}}};
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  QCOMPARE(test::countBorder(mesh), std::size_t{3 + 5 - 1});
  const VertexPairs listed = stitchablePairs(mesh);
  QVERIFY(listed == (VertexPairs{{1, 3}, {0, 6}}));
  for (const auto& pair : listed) {
    HalfEdgeMesh one = mesh;
    QVERIFY(!stitchBoundaries(one, fixedBut(one, {pair}, tolerance::kNearWeld)).empty());
    QCOMPARE(validate(one), std::string());
    // An edge that is split is closed along all of its length.
    QCOMPARE(test::countBorder(one), std::size_t{4});
  }
  QCOMPARE(stitch(mesh).size(), std::size_t{2});
  QCOMPARE(validate(mesh), std::string());
  QCOMPARE(test::countBorder(mesh), std::size_t{4});
  QVERIFY(stitchablePairs(mesh).empty());
}

HANDWHEEL_TEST(StitchingTest)
#include "StitchingTest.moc"
