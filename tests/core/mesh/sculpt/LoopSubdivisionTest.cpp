// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/LoopSubdivision.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "SubdivisionShapes.h"
#include "TestClass.h"
#include "mesh/selection/RegionGrowing.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;
using test::built;
using test::fan;
using test::sameBits;

class LoopSubdivisionTest : public QObject {
  Q_OBJECT

 private slots:
  void splitsByTheOutline_data();
  void splitsByTheOutline();
  void cutsAlongTheShorterDiagonal();
  void masks();
  void quadraticsOnTheLattice();
  void commutesWithAffineMaps();
  void anyPatch();
  void nonManifoldNeighbours_data();
  void nonManifoldNeighbours();
};

namespace {

// Returns true if everything outside is unchanged: faces outside the patch, and vertices with such a face.
bool isSameOutside(const HalfEdgeMesh& before, const HalfEdgeMesh& after, const FaceSelection& patch) {
  for (Face f = 0; f < before.faceSlots(); ++f) {
    if (patch.contains(f) || !before.isLive(f)) continue;
    if (before.triangle(f) != after.triangle(f)) return false;
    for (const Vertex v : before.triangle(f))
      if (!sameBits(before.position(v), after.position(v))) return false;
  }
  return true;
}

// Edges of the patch with faces of it on both sides.
std::size_t edgesInside(const HalfEdgeMesh& mesh, const FaceSelection& patch) {
  std::size_t halves = 0;
  patch.forEach([&](Face f) {
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h)
      halves += mesh.hasOpposite(h) && patch.contains(HalfEdgeMesh::face(mesh.opposite(h)));
  });
  return halves / 2;
}

}  // namespace

void LoopSubdivisionTest::splitsByTheOutline_data() {
  QTest::addColumn<TriangleSoup>("soup");
  QTest::addColumn<int>("after");
  QTest::newRow("none in the outline") << test::tetrahedron() << 16;
  QTest::newRow("one each") << fan(6) << 18;
  QTest::newRow("two each") << test::grid(2, 2, false, false, [](auto i, auto j) { return Vec3(i, j, 0); }) << 4;
  QTest::newRow("one and two") << test::grid(2, 3, false, false, [](auto i, auto j) { return Vec3(i, j, 0); })
                               << 2 * 2 + 2 * 3;
}

void LoopSubdivisionTest::splitsByTheOutline() {
  QFETCH(TriangleSoup, soup);
  QFETCH(int, after);
  HalfEdgeMesh mesh = built(soup);
  const std::size_t border = test::countBorder(mesh);
  const double area = test::area(soup);
  const SubdivisionStep step = subdivide(mesh, FaceSelection::all(mesh));
  QVERIFY(step.failure == SubdivisionFailure::None);
  QCOMPARE(validate(mesh), std::string());
  QCOMPARE(mesh.liveFaceCount(), std::size_t(after));
  QCOMPARE(step.faces.count(), std::size_t(after));
  QCOMPARE(test::countBorder(mesh), border);  // no point in the outline
  if (border > 0) QVERIFY(std::abs(test::area(mesh.compact().soup) - area) < 1e-12);
}

// A triangle over a long edge, one of whose sides is on the outline: of the quadrilateral between that and the two
// points, the cut is the shorter diagonal.
void LoopSubdivisionTest::cutsAlongTheShorterDiagonal() {
  TriangleSoup soup;
  soup.points = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0.5, 3, 0), Vec3(-4, 3, 0), Vec3(5, 3, 0)};
  soup.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}};
  HalfEdgeMesh mesh = built(soup);
  QVERIFY(subdivide(mesh, FaceSelection::all(mesh)).failure == SubdivisionFailure::None);
  const auto point = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return Vec3(0.375 * (soup.points[a] + soup.points[b]) + 0.125 * (soup.points[c] + soup.points[d]));
  };
  const Vec3 right = point(1, 2, 0, 4), left = point(2, 0, 1, 3);
  const auto hasEdge = [&](const Vec3& p, const Vec3& q) {
    for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
      if ((mesh.position(mesh.from(h)) - p).norm() + (mesh.position(mesh.to(h)) - q).norm() < 1e-12) return true;
    return false;
  };
  const bool isLeftShorter = (left - soup.points[1]).norm() < (right - soup.points[0]).norm();
  QCOMPARE(hasEdge(left, soup.points[1]) || hasEdge(soup.points[1], left), isLeftShorter);
  QCOMPARE(hasEdge(right, soup.points[0]) || hasEdge(soup.points[0], right), !isLeftShorter);
}

// By hand from 4-1 and 4-2: valence 3 gives 7/16 of the vertex and 3/16 of each neighbour; valence 6, 5/8 and 1/16.
void LoopSubdivisionTest::masks() {
  HalfEdgeMesh mesh = built(test::tetrahedron());
  const Vertex origin = test::vertexAt(mesh, Vec3::Zero());
  QVERIFY(subdivide(mesh, FaceSelection::all(mesh)).failure == SubdivisionFailure::None);
  QVERIFY((mesh.position(origin) - Vec3(3, 3, 3) / 16.0).norm() < 1e-15);
  HalfEdgeMesh six = built(fan(6));
  const Vertex middle = test::vertexAt(six, Vec3::Zero());
  six.setPosition(middle, Vec3::UnitZ());
  QVERIFY(subdivide(six, FaceSelection::all(six)).failure == SubdivisionFailure::None);
  QCOMPARE(six.position(middle).z(), 0.625);
  for (Vertex v = 7; v < six.vertexSlots(); ++v) QVERIFY(std::abs(six.position(v).z() - 0.375) < 1e-15);
}

// The quartic box spline over a lattice reproduces quadratics up to a constant: so where the vertices stand on one, the
// vertices of the next level stand on it shifted by the same height, old and new ones alike.
void LoopSubdivisionTest::quadraticsOnTheLattice() {
  const auto quadratic = [](const Vec3& p) {
    return 0.3 * p.x() * p.x() - 0.7 * p.x() * p.y() + 0.2 * p.y() * p.y() + 2.0 * p.x() - p.y() + 5.0;
  };
  HalfEdgeMesh mesh = built(test::grid(9, 9, false, false, [&](auto i, auto j) {
    Vec3 p(i - 0.5 * j, j * std::sqrt(0.75), 0.0);
    p.z() = quadratic(p);
    return p;
  }));
  const SubdivisionStep step = subdivide(mesh, FaceSelection::all(mesh));
  std::vector<double> heights;
  for (std::size_t i = 0; i < step.stencils.size(); ++i) {
    const Vec3& p = mesh.position(mesh.from(step.stencils.leaving(i)));
    const bool isDeep = p.y() > 1.5 && p.y() < 5.4 && p.x() + 0.5 * p.y() / std::sqrt(0.75) > 1.5 &&
                        p.x() + 0.5 * p.y() / std::sqrt(0.75) < 6.5;
    if (isDeep) heights.push_back(p.z() - quadratic(p));
  }
  QVERIFY(heights.size() > 50);
  for (const double height : heights) QVERIFY(std::abs(height - heights.front()) < 1e-12);
}

void LoopSubdivisionTest::commutesWithAffineMaps() {
  Eigen::Matrix3d map;
  map << 1.2, 0.3, 0.0, -0.2, 0.9, 0.4, 0.1, 0.0, 1.1;
  const Vec3 shift(3, -2, 7);
  TriangleSoup soup = test::withHole(test::bumpySphere(3), Vec3::UnitX(), 0.4);
  HalfEdgeMesh plain = built(soup);
  for (Vec3& p : soup.points) p = map * p + shift;
  HalfEdgeMesh mapped = built(soup);
  const SubdivisionStep step = subdivide(plain, FaceSelection::all(plain));
  QCOMPARE(step.heldBack, std::size_t(0));
  QCOMPARE(subdivide(mapped, FaceSelection::all(mapped)).heldBack, std::size_t(0));
  for (Vertex v = 0; v < plain.vertexSlots(); ++v)
    QVERIFY((map * plain.position(v) + shift - mapped.position(v)).norm() < 1e-13);
}

void LoopSubdivisionTest::anyPatch() {
  const HalfEdgeMesh whole = built(test::withHole(test::bumpySphere(3), Vec3::UnitX(), 0.3));
  const bool ok = rc::check([&] {
    HalfEdgeMesh mesh = whole;
    FaceSelection patch;
    const int seeds = *rc::gen::inRange(1, 4), rings = *rc::gen::inRange(0, 6);
    for (int i = 0; i < seeds; ++i) patch.add(*rc::gen::inRange<Face>(0, static_cast<Face>(whole.faceSlots())));
    for (int i = 0; i < rings; ++i) patch = grownByRing(whole, patch);
    const int levels = *rc::gen::inRange(1, 3);
    for (int level = 0; level < levels; ++level) {
      const HalfEdgeMesh before = mesh;
      const std::size_t inside = edgesInside(mesh, patch);
      const SubdivisionStep step = subdivide(mesh, patch);
      RC_ASSERT(validate(mesh) == std::string());
      RC_ASSERT(isSameOutside(before, mesh, patch));
      RC_ASSERT((step.failure == SubdivisionFailure::NoEdgeInside) == (inside == 0));
      if (inside == 0) RC_SUCCEED("nothing to split");
      RC_ASSERT(step.faces.count() == patch.count() + 2 * inside);
      RC_ASSERT(mesh.vertexSlots() == before.vertexSlots() + inside);
      RC_ASSERT(test::eulerCharacteristic(mesh) == test::eulerCharacteristic(before));
      RC_ASSERT(test::countBorder(mesh) == test::countBorder(before));
      patch = step.faces;
    }
  });
  QVERIFY(ok);
}

void LoopSubdivisionTest::nonManifoldNeighbours_data() {
  QTest::addColumn<TriangleSoup>("soup");
  QTest::newRow("cubes at an edge") << test::twoCubesSharingAnEdge();
  QTest::newRow("cubes at a vertex") << test::twoCubesSharingAVertex();
  QTest::newRow("inner wall") << test::boxWithInnerWall();
  QTest::newRow("Möbius strip") << test::moebiusStrip(12, 3);
  QTest::newRow("Klein bottle") << test::kleinBottle(12, 8);
  QTest::newRow("two faces back to back")
      << TriangleSoup{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}, {0, 2, 1}}};
}

void LoopSubdivisionTest::nonManifoldNeighbours() {
  QFETCH(TriangleSoup, soup);
  const HalfEdgeMesh whole = built(soup);
  for (Face first = 0; first < whole.faceSlots(); ++first) {
    HalfEdgeMesh mesh = whole;
    const FaceSelection patch = grownByRing(mesh, FaceSelection{first});
    subdivide(mesh, patch);
    QCOMPARE(validate(mesh), std::string());
    QVERIFY(isSameOutside(whole, mesh, patch));
    QCOMPARE(test::countSeams(mesh), test::countSeams(whole));
    QCOMPARE(test::countBorder(mesh), test::countBorder(whole));
  }
}

HANDWHEEL_TEST(LoopSubdivisionTest)
#include "LoopSubdivisionTest.moc"
