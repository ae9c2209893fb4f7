// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Extremes.h"

#include "MeshChecks.h"
#include "TestClass.h"
#include "mesh/measure/Deviation.h"
#include "mesh/simplify/Decimation.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshErrors.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;

// Removing triangles, and comparing with what was there, on every mesh at the edge of what can be.
class DecimationExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  void toACount_data() { everyMesh(); }
  void toACount();
  void withinAnError_data();
  void withinAnError();
  void hugeAndFine();
  void compares_data() { everyMesh(); }
  void compares();

 private:
  static void everyMesh() {
    QTest::addColumn<TriangleSoup>("soup");
    for (const test::ExtremeMesh& mesh : test::allMeshes()) QTest::newRow(mesh.name.c_str()) << mesh.soup();
  }
};

namespace {

constexpr double kNothing = 1e-150;  // mm; less has no square

double largestCoordinate(const TriangleSoup& soup) {
  double largest = 0.0;
  for (const Vec3& p : soup.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

// Above zero, though squares overflow or underflow or there is nothing at all.
double lengthOf(const TriangleSoup& soup) {
  Box box;
  for (const Vec3& p : soup.points) box.extend(p);
  const double length = box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
  return length > 0.0 ? length : 1.0;
}

// Half of them, or a thousand fewer: around a vertex with thousands of faces each edge takes long.
std::size_t goal(const TriangleSoup& soup) {
  const std::size_t n = soup.triangles.size();
  return n - std::min<std::size_t>(n / 2, 1000);
}

// What is wrong with a mesh that was made from another by removing triangles; empty for nothing.
QString problemOf(const HalfEdgeMesh& before, const HalfEdgeMesh& after) {
  if (const std::string broken = validate(after); !broken.empty()) return QString::fromStdString(broken);
  for (Vertex v = 0; v < after.vertexSlots(); ++v) {
    if (!after.position(v).allFinite()) return QStringLiteral("a coordinate that is none");
  }
  return test::countSeams(after) == test::countSeams(before) ? QString() : QStringLiteral("other seams");
}

HalfEdgeMesh withoutDegenerate(HalfEdgeMesh mesh) {
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (mesh.isLive(f) && !mesh.isProper(f)) mesh.removeFace(f);
  }
  return mesh;
}

}  // namespace

void DecimationExtremesTest::toACount() {
  QFETCH(TriangleSoup, soup);
  const HalfEdgeMesh before = buildMesh(soup).mesh;
  HalfEdgeMesh mesh = before;
  const DecimationReport report =
      decimate(mesh, {.faces = goal(soup), .keepBorders = true, .avoidIntersections = true});
  QCOMPARE(problemOf(withoutDegenerate(before), mesh), QString());
  QCOMPARE(report.facesBefore, soup.triangles.size());
  QCOMPARE(report.facesAfter, mesh.liveFaceCount());
  QCOMPARE(test::countBorder(mesh), test::countBorder(withoutDegenerate(before)));
}

void DecimationExtremesTest::withinAnError_data() {
  QTest::addColumn<TriangleSoup>("soup");
  for (const test::ExtremeMesh& mesh : test::allMeshes()) QTest::newRow(mesh.name.c_str()) << mesh.soup();
}

// Within the error by what deviation() finds, or as it was.
void DecimationExtremesTest::withinAnError() {
  QFETCH(TriangleSoup, soup);
  const HalfEdgeMesh before = buildMesh(soup).mesh;
  HalfEdgeMesh mesh = before;
  const double error = 1e-3 * lengthOf(soup);
  const DecimationReport report = decimate(mesh, {.faces = goal(soup), .error = error, .keepBorders = true});
  QCOMPARE(problemOf(withoutDegenerate(before), mesh), QString());
  QCOMPARE(report.facesAfter, mesh.liveFaceCount());
  if (const auto found = deviation(mesh, before, {.samples = 20'000})) {
    QVERIFY(found->hausdorff() <= error + kNothing);
  } else {
    QCOMPARE(report.facesAfter + report.removedDegenerate, report.facesBefore);
  }
}

// Where the squares of lengths are no numbers, nothing can be proven: nothing goes.
void DecimationExtremesTest::hugeAndFine() {
  const HalfEdgeMesh before = buildMesh(test::moved(test::icosphere(3), Vec3::Zero(), 1e170)).mesh;
  HalfEdgeMesh mesh = before;
  const DecimationReport report = decimate(mesh, {.error = 1e168});
  QVERIFY(test::sameMesh(mesh, before));
  QCOMPARE(report.facesAfter, before.liveFaceCount());
  QCOMPARE(*report.largestDistance, 0.0);
}

// A copy that is moved is farthest where it sticks out: by as much as it was moved.
void DecimationExtremesTest::compares() {
  QFETCH(TriangleSoup, soup);
  // A power of two: what lies on a line stays on it.
  const double shift = std::exp2(std::floor(std::log2(0.01 * lengthOf(soup)))), most = largestCoordinate(soup);
  const HalfEdgeMesh mesh = buildMesh(soup).mesh, moved = buildMesh(test::moved(soup, shift * Vec3::UnitX())).mesh;
  const DeviationOptions options{.samples = 2000};
  const auto found = deviation(mesh, moved, options), none = deviation(mesh, mesh, options);
  if (soup.triangles.empty() || most > 1e60) {
    QVERIFY(!found && !none);
    QCOMPARE(found.error().code, soup.triangles.empty() ? MeshError::NoTriangles : ErrorCode::ValueOutOfRange);
    return;
  }
  QVERIFY(found && none);
  const double rounding = 1e-9 * shift + 1e-15 * most + kNothing;
  QVERIFY2(std::abs(found->hausdorff() - shift) <= rounding, qPrintable(QString::number(found->hausdorff() / shift)));
  QVERIFY(none->hausdorff() <= rounding);
  for (const SurfaceDeviation* side : {&found->ofMesh, &found->ofScan}) {
    QVERIFY(side->rms <= shift + rounding && side->meanAbsolute <= side->rms + rounding);
    QVERIFY(std::abs(side->mean) <= side->meanAbsolute + rounding);
  }
}

HANDWHEEL_TEST(DecimationExtremesTest)
#include "DecimationExtremesTest.moc"
