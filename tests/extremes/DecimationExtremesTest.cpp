// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Extremes.h"

#include "LargeInputs.h"
#include "MeshChecks.h"
#include "TestClass.h"
#include "mesh/measure/Deviation.h"
#include "mesh/simplify/Decimation.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;

// Removing triangles on every mesh at the edge of what can be.
class DecimationExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  void toACount_data() { everyMesh(); }
  void toACount();
  void withinAnError_data() { everyMesh(); }
  void withinAnError();
  void hugeAndFine();

 private:
  static void everyMesh() {
    QTest::addColumn<TriangleSoup>("soup");
    for (const test::ExtremeMesh& mesh : test::allMeshes()) {
      const TriangleSoup soup = mesh.soup();
      if (test::withLargeInputs() || soup.triangles.size() < 50'000) QTest::newRow(mesh.name.c_str()) << soup;
    }
    if (test::withLargeInputs()) return;
    QTest::newRow("1,000 components") << test::scattered(1'000);
    QTest::newRow("fan of 1,000 triangles") << test::uvSphere(1'000, 3);
  }
};

namespace {

// Half of them, or a thousand fewer: around a vertex with thousands of faces each edge takes long.
std::size_t goal(const TriangleSoup& soup) {
  const std::size_t n = soup.triangles.size();
  return n - std::min<std::size_t>(n / 2, 1000);
}

// Returns the problem of a mesh that was made from another by removing triangles; empty for none.
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

// Within the error by what deviation() finds, or as it was.
void DecimationExtremesTest::withinAnError() {
  QFETCH(TriangleSoup, soup);
  const HalfEdgeMesh before = buildMesh(soup).mesh;
  HalfEdgeMesh mesh = before;
  const double error = 1e-3 * test::lengthOf(soup);
  const DecimationReport report = decimate(mesh, {.faces = goal(soup), .error = error, .keepBorders = true});
  QCOMPARE(problemOf(withoutDegenerate(before), mesh), QString());
  QCOMPARE(report.facesAfter, mesh.liveFaceCount());
  if (const auto found = deviation(mesh, before, {.samples = 20'000})) {
    QVERIFY(found->hausdorff() <= error + test::kNothing);
  } else {
    QCOMPARE(report.facesAfter + report.removedDegenerate, report.facesBefore);
  }
}

// Squares of these lengths overflow; the work is done at a size near 1.
void DecimationExtremesTest::hugeAndFine() {
  const HalfEdgeMesh before = buildMesh(test::moved(test::icosphere(3), Vec3::Zero(), 1e170)).mesh;
  HalfEdgeMesh mesh = before;
  const DecimationReport report = decimate(mesh, {.error = 1e168});
  QVERIFY(report.facesAfter < before.liveFaceCount());
  QVERIFY(*report.largestDistance > 0.0 && *report.largestDistance <= 1e168);
}

HANDWHEEL_TEST(DecimationExtremesTest)
#include "DecimationExtremesTest.moc"
