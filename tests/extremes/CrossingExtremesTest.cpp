// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExtremeRows.h"
#include "MeshChecks.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/repair/intersections/FoldedRegionRemoval.h"
#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "mesh/structure/MeshValidator.h"

#include <numeric>

using namespace handwheel;

// Cutting what crosses itself, and taking out what is tangled, on every extreme mesh.
class CrossingExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  void removesFromEveryMesh_data() { test::everyMesh(kMostFaces); }
  void removesFromEveryMesh();
  void removesFromCubes_data() { placeRows(); }
  void removesFromCubes();
  void takesOutTangles_data() { placeRows(); }
  void takesOutTangles();
  void tanglesOfEveryMesh_data() { test::everyMesh(kMostFaces); }
  void tanglesOfEveryMesh();

 private:
  static constexpr std::size_t kMostFaces = 10'000;

  static void placeRows();
};

namespace {

std::vector<Face> allFaces(const HalfEdgeMesh& mesh) {
  std::vector<Face> faces(mesh.faceSlots());
  std::iota(faces.begin(), faces.end(), 0u);
  return faces;
}

double areaOf(const HalfEdgeMesh& mesh) {
  return test::area(mesh.compact().soup);
}

double borderLength(const HalfEdgeMesh& mesh) {
  double length = 0.0;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
    if (mesh.isBorder(h)) length += (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).stableNorm();
  return length;
}

}  // namespace

void CrossingExtremesTest::placeRows() {
  QTest::addColumn<double>("scale");
  QTest::addColumn<double>("offset");
  for (const double scale : test::kScales) QTest::addRow("%g mm", scale) << scale << 0.0;
  for (const double offset : test::kOffsets) QTest::addRow("10 mm, %g mm away", offset) << 10.0 << offset;
}

// Either the mesh is as it was, or it crosses itself no more and every piece of its surface is still there.
void CrossingExtremesTest::removesFromEveryMesh() {
  QFETCH(test::ExtremeMesh, extreme);
  const HalfEdgeMesh before = buildMesh(extreme.soup()).mesh;
  HalfEdgeMesh mesh = before;
  const IntersectionRemoval report = removeSelfIntersections(mesh, allFaces(mesh), NumberType::Float64, 0);
  QCOMPARE(QString::fromStdString(validate(mesh)), QString());
  if (!report.changed) {
    QVERIFY(test::sameMesh(mesh, before));
    return;
  }
  QCOMPARE(report.intersectionsAfter, std::size_t{0});
  QCOMPARE(countSelfIntersections(mesh, NumberType::Float64), std::size_t{0});
  QVERIFY(borderLength(mesh) <= (1.0 + 1e-9) * borderLength(before));  // edges that cross are split
  QVERIFY(std::abs(areaOf(mesh) / areaOf(before) - 1.0) < 1e-6);
}

// Two cubes, the second shifted: what comes out are their union and, inside it, what they have in common.
void CrossingExtremesTest::removesFromCubes() {
  QFETCH(double, scale);
  QFETCH(double, offset);
  const Vec3 middle(offset, -offset, offset), shift(0.41, 0.27, 0.33);
  TriangleSoup soup = test::cube();
  test::append(soup, test::cube(1.0, shift));
  HalfEdgeMesh mesh = buildMesh(test::moved(soup, middle, scale)).mesh;
  QVERIFY(removeSelfIntersections(mesh, allFaces(mesh), NumberType::Float64, 0).changed);
  QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
  QVERIFY(test::countEdges(mesh).sound());
  std::vector<double> volumes;
  for (const TriangleSoup& body : test::pieces(buildMesh(mesh.compact().soup).mesh))
    volumes.push_back(test::volume(test::moved(body, -middle)) / (scale * scale * scale));
  std::sort(volumes.begin(), volumes.end());
  QCOMPARE(volumes.size(), std::size_t{2});
  const double common = (1.0 - shift.x()) * (1.0 - shift.y()) * (1.0 - shift.z());
  const double error = 1e-9 + test::rounding(test::boxOf(mesh), 256.0) / scale;
  QVERIFY(std::abs(volumes[0] - common) < error);
  QVERIFY(std::abs(volumes[1] - (2.0 - common)) < error);
}

// A hole with a folded border, closed by taking the folds out: a ball again, as near to one as its triangles were.
void CrossingExtremesTest::takesOutTangles() {
  QFETCH(double, scale);
  QFETCH(double, offset);
  const Vec3 middle(offset, -offset, offset);
  const TriangleSoup folded = test::withFoldedBorder(test::sphereWithoutCap(4, 0.12));
  HalfEdgeMesh mesh = buildMesh(test::moved(folded, middle, scale)).mesh;
  QVERIFY(countSelfIntersections(mesh, NumberType::Float64) > 0);
  QVERIFY(replaceFoldedRegions(mesh, findBoundaryLoops(mesh), {}) > 0);
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(countSelfIntersections(mesh, NumberType::Float64), std::size_t{0});
  for (const Vec3& p : mesh.compact().soup.points) QVERIFY(std::abs((p - middle).norm() / scale - 1.0) < 0.01);
}

// Never more that is open or crosses, and no more of the surface gone than may be.
void CrossingExtremesTest::tanglesOfEveryMesh() {
  QFETCH(test::ExtremeMesh, extreme);
  const HalfEdgeMesh before = buildMesh(extreme.soup()).mesh;
  HalfEdgeMesh mesh = before;
  const std::size_t crossings = countSelfIntersections(mesh, NumberType::Float64);
  const std::size_t gone = replaceFoldedRegions(mesh, findBoundaryLoops(mesh), {});
  QCOMPARE(QString::fromStdString(validate(mesh)), QString());
  if (gone == 0 && findBoundaryLoops(before).empty()) QVERIFY(test::sameMesh(mesh, before));
  const test::Edges was = test::countEdges(before), is = test::countEdges(mesh);
  QVERIFY(is.border + is.nonManifold <= was.border + was.nonManifold);
  QVERIFY(countSelfIntersections(mesh, NumberType::Float64) <= crossings);
}

HANDWHEEL_TEST(CrossingExtremesTest)
#include "CrossingExtremesTest.moc"
