// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/SelfIntersectionRemoval.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>
#include <algorithm>
#include <numeric>

using namespace handwheel;

namespace {

std::vector<Face> allFaces(const HalfEdgeMesh& mesh) {
  std::vector<Face> faces(mesh.faceSlots());
  std::iota(faces.begin(), faces.end(), 0u);
  return faces;
}

// Returns the volumes of the bodies connected through edges, smallest first.
std::vector<double> volumes(const HalfEdgeMesh& mesh) {
  std::vector<double> result;
  for (const TriangleSoup& body : test::pieces(buildMesh(mesh.compact().soup).mesh))
    result.push_back(test::volume(body));
  std::sort(result.begin(), result.end());
  return result;
}

HalfEdgeMesh twoCubes(const Vec3& shift, double scale = 1.0) {
  TriangleSoup s = test::cube();
  test::append(s, test::cube(1.0, shift));
  for (Vec3& p : s.points) p *= scale;
  return buildMesh(s).mesh;
}

}  // namespace

class SelfIntersectionRemovalTest : public QObject {
  Q_OBJECT

 private slots:
  void cubesThatOverlap_data();
  void cubesThatOverlap();
  void onlyWhatWasAskedFor();
  void nothingCrosses();
  void cancelled();
  void facesInOnePlane();
  void tangleIsLeft();
};

void SelfIntersectionRemovalTest::cubesThatOverlap_data() {
  QTest::addColumn<double>("scale");
  QTest::newRow("mm") << 1.0;
  QTest::newRow("tiny") << 1e-6;
  QTest::newRow("huge") << 1e6;
}

// Two unit cubes, the second shifted: what comes out are their union and, inside it, what they have in common.
void SelfIntersectionRemovalTest::cubesThatOverlap() {
  QFETCH(double, scale);
  const Vec3 shift(0.41, 0.27, 0.33);
  HalfEdgeMesh mesh = twoCubes(shift, scale);
  const double common = (1 - 0.41) * (1 - 0.27) * (1 - 0.33);
  const IntersectionRemoval report = removeSelfIntersections(mesh, allFaces(mesh), NumberType::Float64, 0);
  QVERIFY(report.changed);
  QVERIFY(report.intersectionsBefore > 0);
  QCOMPARE(report.intersectionsAfter, std::size_t{0});
  QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(test::countEdges(mesh).sound());
  const std::vector<double> bodies = volumes(mesh);
  QCOMPARE(bodies.size(), std::size_t{2});
  const double cube = scale * scale * scale;
  QVERIFY(std::abs(bodies[0] / cube - common) < 1e-9);
  QVERIFY(std::abs(bodies[1] / cube - (2.0 - common)) < 1e-9);
}

// A second crossing far off is left alone, bit for bit.
void SelfIntersectionRemovalTest::onlyWhatWasAskedFor() {
  TriangleSoup s = test::cube();
  test::append(s, test::cube(1.0, {0.41, 0.27, 0.33}));
  const auto ours = static_cast<Face>(s.triangles.size());
  test::append(s, test::moved(test::cube(), {10, 0, 0}));
  test::append(s, test::moved(test::cube(1.0, {0.41, 0.27, 0.33}), {10, 0, 0}));
  const HalfEdgeMesh before = buildMesh(s).mesh;
  HalfEdgeMesh mesh = before;
  const IntersectionRemoval report =
      removeSelfIntersections(mesh, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, NumberType::Float64,
                              countSelfIntersections(before, NumberType::Float64));
  QVERIFY(report.changed);
  QCOMPARE(report.intersectionsAfter, report.intersectionsBefore / 2);
  for (Face f = ours; f < before.faceSlots(); ++f) {
    QVERIFY(mesh.isLive(f));
    QVERIFY(mesh.points(f) == before.points(f));
  }
  // No corner of the cut ones is gone.
  for (Vertex v = 0; v < before.vertexSlots(); ++v) QVERIFY(mesh.position(v) == before.position(v));
}

void SelfIntersectionRemovalTest::nothingCrosses() {
  const HalfEdgeMesh before = buildMesh(test::icosphere(3)).mesh;
  HalfEdgeMesh mesh = before;
  QVERIFY(!removeSelfIntersections(mesh, allFaces(mesh), NumberType::Float32, 0).changed);
  QCOMPARE(mesh.faceSlots(), before.faceSlots());
  HalfEdgeMesh empty;
  QVERIFY(!removeSelfIntersections(empty, {}, NumberType::Float32, 0).changed);
}

void SelfIntersectionRemovalTest::cancelled() {
  HalfEdgeMesh mesh = twoCubes({0.41, 0.27, 0.33});
  JobState state;
  state.cancelled = true;
  QVERIFY(!removeSelfIntersections(mesh, allFaces(mesh), NumberType::Float64, 0, Progress(state)).changed);
  QCOMPARE(mesh.liveFaceCount(), std::size_t{24});
}

// Two cubes with faces in the same planes become their union.
void SelfIntersectionRemovalTest::facesInOnePlane() {
  HalfEdgeMesh mesh = twoCubes({0.5, 0.5, 0.0});
  QVERIFY(removeSelfIntersections(mesh, allFaces(mesh), NumberType::Float64, 0).changed);
  QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
  QVERIFY(std::abs(test::volume(mesh.compact().soup) - 1.75) < 1e-9);
}

// A triangle cut by more others than may cut one is left, with all of them.
void SelfIntersectionRemovalTest::tangleIsLeft() {
  TriangleSoup s{{{0, 0, 0}, {1000, 0, 0}, {0, 1000, 0}}, {{0, 1, 2}}};
  for (std::uint32_t i = 0; i <= tolerance::kCutsPerFace; ++i) {
    const double x = 1.0 + 2.0 * i;
    const auto n = static_cast<std::uint32_t>(s.points.size());
    s.points.insert(s.points.end(), {{x, 1, -1}, {x + 1, 1, -1}, {x, 1.5, 1}});
    s.triangles.push_back({n, n + 1, n + 2});
  }
  const HalfEdgeMesh before = buildMesh(s).mesh;
  HalfEdgeMesh mesh = before;
  const IntersectionRemoval report = removeSelfIntersections(mesh, allFaces(mesh), NumberType::Float64, 0);
  QCOMPARE(report.intersectionsBefore, tolerance::kCutsPerFace + 1);
  QCOMPARE(report.intersectionsAfter, report.intersectionsBefore);
  QVERIFY(!report.changed);
  QVERIFY(test::sameMesh(mesh, before));
}

HANDWHEEL_TEST(SelfIntersectionRemovalTest)
#include "SelfIntersectionRemovalTest.moc"
