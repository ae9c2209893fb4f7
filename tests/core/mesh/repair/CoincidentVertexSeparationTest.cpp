// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/CoincidentVertexSeparation.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/defects/Defects.h"
#include "mesh/defects/MeshReport.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>
#include <limits>

using namespace handwheel;

namespace {

TriangleSoup asWritten(const HalfEdgeMesh& mesh, NumberType numbers) {
  TriangleSoup s = mesh.compact().soup;
  for (Vec3& p : s.points) p = rounded(p, numbers);
  return s;
}

std::size_t intersections(const TriangleSoup& s) {
  return reportOn(s, SelfIntersections::Count).selfIntersectingPairs.value();
}

// The distance between neighbouring numbers at the largest coordinate.
double ulp(const Vec3& p, NumberType numbers) {
  const double x = p.cwiseAbs().maxCoeff();
  return numbers == NumberType::Float32 ? double(std::nextafter(float(x), INFINITY)) - double(float(x))
                                        : std::nextafter(x, INFINITY) - x;
}

}  // namespace

class CoincidentVertexSeparationTest : public QObject {
  Q_OBJECT

 private slots:
  void cubesSharingAnEdge();
  void cubesSharingAVertexStay();
  void soundMeshesStay();
  void cakeOfWedges();
  void randomCells();
  void largeFans();
  void largeFansStopSoon();
  void keptBoundariesStay();
  void newOnesMoveRather();
};

void CoincidentVertexSeparationTest::cubesSharingAnEdge() {
  for (NumberType numbers : {NumberType::Float32, NumberType::Float64}) {
    for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(10.3, -7.7, 1000), Vec3(-1, -1, -0.5)}) {
      TriangleSoup s = test::moved(test::twoCubesSharingAnEdge(), corner);
      for (Vec3& p : s.points) p = rounded(p, numbers);
      const HalfEdgeMesh before = buildMesh(s).mesh;
      QCOMPARE(test::countEdges(before).nonManifold, std::size_t{1});
      HalfEdgeMesh mesh = before;
      const std::vector<Vertex> moved = separateCoincidentVertices(mesh, numbers);
      QVERIFY(!moved.empty());
      QCOMPARE(validate(mesh), std::string());
      const TriangleSoup written = asWritten(mesh, numbers);
      QVERIFY(test::countEdges(written).sound());
      QCOMPARE(intersections(written), std::size_t{0});
      const std::set<Vertex> movedSet(moved.begin(), moved.end());
      for (Vertex v = 0; v < mesh.vertexSlots(); ++v) {
        const double distance = (mesh.position(v) - before.position(v)).norm();
        if (!movedSet.contains(v)) QVERIFY(test::sameBits(mesh.position(v), before.position(v)));
        QVERIFY2(distance <= 8 * ulp(before.position(v), numbers), qPrintable(QString::number(distance)));
      }
    }
  }
}

// Welding two corners into one harms no edge.
void CoincidentVertexSeparationTest::cubesSharingAVertexStay() {
  const HalfEdgeMesh before = buildMesh(test::twoCubesSharingAVertex()).mesh;
  HalfEdgeMesh mesh = before;
  QVERIFY(separateCoincidentVertices(mesh, NumberType::Float32).empty());
  QVERIFY(test::sameMesh(mesh, before));
}

void CoincidentVertexSeparationTest::soundMeshesStay() {
  for (const TriangleSoup& s : {test::cube(), test::torus(8, 6), test::disc(8, 3)}) {
    const HalfEdgeMesh before = buildMesh(s).mesh;
    HalfEdgeMesh mesh = before;
    QVERIFY(separateCoincidentVertices(mesh, NumberType::Float32).empty());
    QVERIFY(test::sameMesh(mesh, before));
  }
}

// Tetrahedra around an axis, each closed; in the file the axis has all their faces.
void CoincidentVertexSeparationTest::cakeOfWedges() {
  for (int n = 2; n <= 6; ++n) {
    TriangleSoup s;
    for (int i = 0; i < n; ++i) {
      const double u = 2 * M_PI * i / n, v = 2 * M_PI * (i + 0.6) / n;
      TriangleSoup wedge = test::tetrahedron();
      wedge.points = {Vec3(3, 3, 3), Vec3(3 + std::cos(u), 3 + std::sin(u), 3.5),
                      Vec3(3 + std::cos(v), 3 + std::sin(v), 3.5), Vec3(3, 3, 4)};
      for (Vec3& p : wedge.points) p = rounded(p, NumberType::Float32);
      test::append(s, wedge);
    }
    HalfEdgeMesh mesh = buildMesh(s).mesh;
    separateCoincidentVertices(mesh, NumberType::Float32);
    QCOMPARE(validate(mesh), std::string());
    const TriangleSoup written = asWritten(mesh, NumberType::Float32);
    QVERIFY2(test::countEdges(written).sound(), qPrintable(QString("%1 wedges").arg(n)));
    QCOMPARE(intersections(written), std::size_t{0});
  }
}

void CoincidentVertexSeparationTest::randomCells() {
  QVERIFY(rc::check("blocks that touch at edges and corners come apart without crossing", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    HalfEdgeMesh mesh = buildMesh(test::randomBlocks(random, *rc::gen::inRange<std::size_t>(2, 20), 3)).mesh;
    RC_ASSERT(test::countBorder(mesh) == std::size_t{0});
    const std::size_t before = intersections(mesh.compact().soup);
    separateCoincidentVertices(mesh, NumberType::Float32);
    RC_ASSERT(validate(mesh) == std::string());
    const TriangleSoup written = asWritten(mesh, NumberType::Float32);
    RC_ASSERT(test::countEdges(written).sound());
    RC_ASSERT(intersections(written) <= before);
  }));
}

// Each face of a fan meets each other: the work grows with the square of the fan, not with the cube.
void CoincidentVertexSeparationTest::largeFans() {
  std::vector<double> steps;
  for (const std::uint32_t n : {500u, 1'000u}) {
    HalfEdgeMesh mesh = buildMesh(test::twoConesSharingAnEdge(n)).mesh;
    QCOMPARE(test::countEdges(mesh).nonManifold, std::size_t{1});
    WorkBudget effort(std::numeric_limits<std::size_t>::max());
    QVERIFY(!separateCoincidentVertices(mesh, NumberType::Float32, Progress().within(effort)).empty());
    steps.push_back(static_cast<double>(effort.counted()));
    QCOMPARE(validate(mesh), std::string());
    const TriangleSoup written = asWritten(mesh, NumberType::Float32);
    QVERIFY(test::countEdges(written).sound());
    QCOMPARE(intersections(written), std::size_t{0});
  }
  QVERIFY2(steps[1] < 5 * steps[0], qPrintable(QString("%1, %2 steps").arg(steps[0]).arg(steps[1])));
}

// A triangle and a cube touch at a corner: the vertex of an open boundary that is kept stays, the other
// moves.
void CoincidentVertexSeparationTest::keptBoundariesStay() {
  TriangleSoup soup = test::cube();  // (1, 1, 1) is touched by the corner of an open triangle
  test::append(soup, {{Vec3(1, 1, 1), Vec3(2, 1, 1.5), Vec3(1, 2, 1.5)}, {{0, 1, 2}}});
  const HalfEdgeMesh before = buildMesh(soup).mesh;
  const std::set<PointKey> kept{positionKey(Vec3(1, 1, 1))};
  for (const bool isKept : {false, true}) {
    HalfEdgeMesh mesh = before;
    const std::vector<Vertex> moved =
        separateTouchingVertices(mesh, NumberType::Float32, {}, {isKept ? &kept : nullptr, 0});
    QCOMPARE(moved.size(), std::size_t{1});
    // The smaller fan moves unless it is kept.
    QCOMPARE(mesh.points(12)[0] == Vec3(1, 1, 1), isKept);
    QVERIFY(findDefects(buildMesh(asWritten(mesh, NumberType::Float32)).mesh).nonManifoldVertices.empty());
  }
}

// If two cubes touch in a vertex, the vertex of the new one moves, regardless of the fan sizes, and the existing one
// stays.
void CoincidentVertexSeparationTest::newOnesMoveRather() {
  const TriangleSoup low = test::cube(), high = test::cube(1.0, {1, 1, 1});
  for (const bool isLowOld : {false, true}) {
    TriangleSoup soup = isLowOld ? low : high;
    const auto firstNew = static_cast<Vertex>(soup.points.size());
    test::append(soup, isLowOld ? high : low);
    const HalfEdgeMesh before = buildMesh(soup).mesh;
    HalfEdgeMesh mesh = before;
    const std::vector<Vertex> moved = separateTouchingVertices(mesh, NumberType::Float32, {}, {nullptr, firstNew});
    QCOMPARE(moved.size(), std::size_t{1});
    for (Face f = 0; f < 12; ++f) QVERIFY(mesh.points(f) == before.points(f));
    QVERIFY(findDefects(buildMesh(asWritten(mesh, NumberType::Float32)).mesh).nonManifoldVertices.empty());
  }
}

// For any limit, the excess is at most the work for one face and the passes over the mesh that end there.
void CoincidentVertexSeparationTest::largeFansStopSoon() {
  const HalfEdgeMesh before = buildMesh(test::twoConesSharingAnEdge(1'000)).mesh;
  const std::size_t passes = 2 * before.faceSlots();
  for (const std::size_t most : {std::size_t{10'000}, std::size_t{20'000}, std::size_t{40'000}}) {
    HalfEdgeMesh mesh = before;
    WorkBudget effort(most);
    QVERIFY(separateCoincidentVertices(mesh, NumberType::Float32, Progress().within(effort)).empty());
    QVERIFY(effort.isSpent());
    QVERIFY2(effort.counted() <= most + passes, qPrintable(QString::number(effort.counted())));
    QVERIFY(test::sameMesh(mesh, before));
  }
}

HANDWHEEL_TEST(CoincidentVertexSeparationTest)
#include "CoincidentVertexSeparationTest.moc"
