// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/measure/Deviation.h"

#include "Extremes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshErrors.h"

#include <QTest>

using namespace handwheel;

// Comparing every mesh at the edge of what can be with a copy.
class DeviationExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  void compares_data();
  void compares();
};

namespace {

double largestCoordinate(const TriangleSoup& soup) {
  double largest = 0.0;
  for (const Vec3& p : soup.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

}  // namespace

void DeviationExtremesTest::compares_data() {
  QTest::addColumn<TriangleSoup>("soup");
  for (const test::ExtremeMesh& mesh : test::allMeshes()) QTest::newRow(mesh.name.c_str()) << mesh.soup();
}

// A copy that is moved is farthest where it sticks out: by as much as it was moved.
void DeviationExtremesTest::compares() {
  QFETCH(TriangleSoup, soup);
  // A power of two: what lies on a line stays on it.
  const double shift = std::exp2(std::floor(std::log2(0.01 * test::lengthOf(soup)))), most = largestCoordinate(soup);
  const HalfEdgeMesh mesh = buildMesh(soup).mesh, moved = buildMesh(test::moved(soup, shift * Vec3::UnitX())).mesh;
  const DeviationOptions options{.samples = 2000};
  const auto found = deviation(mesh, moved, options), none = deviation(mesh, mesh, options);
  if (soup.triangles.empty() || most > 1e60) {
    QVERIFY(!found && !none);
    QCOMPARE(found.error().code, soup.triangles.empty() ? MeshError::NoTriangles : ErrorCode::ValueOutOfRange);
    return;
  }
  QVERIFY(found && none);
  const double rounding = 1e-9 * shift + 1e-15 * most + test::kNothing;
  QVERIFY2(std::abs(found->hausdorff() - shift) <= rounding, qPrintable(QString::number(found->hausdorff() / shift)));
  QVERIFY(none->hausdorff() <= rounding);
  for (const SurfaceDeviation* side : {&found->ofMesh, &found->ofScan}) {
    QVERIFY(side->rms <= shift + rounding && side->meanAbsolute <= side->rms + rounding);
    QVERIFY(std::abs(side->mean) <= side->meanAbsolute + rounding);
  }
}

HANDWHEEL_TEST(DeviationExtremesTest)
#include "DeviationExtremesTest.moc"
