// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/measure/MeshFidelity.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/boundary/BoundaryVertices.h"
#include "mesh/defects/Defects.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

namespace {

// Two squares side by side whose common edge the file tore apart by this much; the diagonal is √5.
HalfEdgeMesh tornSheet(double gap) {
  TriangleSoup s = test::grid(2, 2, false, false, [](auto i, auto j) { return Vec3(i, j, 0); });
  test::append(s, test::grid(2, 2, false, false, [gap](auto i, auto j) { return Vec3(1.0 + i + gap, j, 0); }));
  return buildMesh(s).mesh;
}

Patch firstPatch(const HalfEdgeMesh& mesh, const FillOptions& options) {
  const HoleFiller filler(mesh);
  return filler.propose(findBoundaryLoops(mesh).front(), options).patch;
}

}  // namespace

class MeshFidelityTest : public QObject {
  Q_OBJECT

 private slots:
  void defaultsChangeNothing();
  void valuesReachTheOptions();
  void nearWeldIsRead();
  void densityIsRead();
};

// The options of who never heard of fidelity are those of the default values, bit for bit.
void MeshFidelityTest::defaultsChangeNothing() {
  RepairOptions options;
  apply(FidelityValues(), options);
  QVERIFY(options.fill.method == RepairOptions().fill.method);
  QVERIFY(options.fill.continuity == Continuity::Tangent);
  QCOMPARE(options.fill.density, RepairOptions().fill.density);
  QCOMPARE(options.nearWeld, RepairOptions().nearWeld);
  QCOMPARE(options.fill.pieceEdges, RepairOptions().fill.pieceEdges);
  QCOMPARE(RepairOptions().nearWeld, 1e-5);
  QCOMPARE(RepairOptions().fill.density * RepairOptions().fill.density, std::sqrt(2.0) * std::sqrt(2.0));
}

void MeshFidelityTest::valuesReachTheOptions() {
  FidelityValues values;
  QVERIFY(values.set(nearWeldSetting(), 1e-4));
  QVERIFY(values.set(patchDensitySetting(), 2.0));
  QVERIFY(values.set(pieceEdgesSetting(), 77.0));
  RepairOptions options;
  options.maxEdges = 77;
  const std::pair<const char*, FillMethod> methods[] = {
      {"ear", FillMethod::Ear},      {"minimal", FillMethod::Minimal}, {"refined", FillMethod::Refined},
      {"fair", FillMethod::Fair},    {"area", FillMethod::Area},       {"dihedral", FillMethod::Dihedral},
      {"ridge", FillMethod::Crease}, {"flat", FillMethod::Flat}};
  for (const auto& [word, method] : methods) {
    QVERIFY(values.set(fillMethodSetting(), *valueOf(fillMethodSetting(), word)));
    apply(values, options);
    QVERIFY(options.fill.method == method);
  }
  const std::pair<const char*, Continuity> continuities[] = {
      {"position", Continuity::Position}, {"tangent", Continuity::Tangent}, {"curvature", Continuity::Curvature}};
  for (const auto& [word, continuity] : continuities) {
    QVERIFY(values.set(fillContinuitySetting(), *valueOf(fillContinuitySetting(), word)));
    apply(values, options);
    QVERIFY(options.fill.continuity == continuity);
  }
  QCOMPARE(options.nearWeld, 1e-4);
  QCOMPARE(options.fill.density, 2.0);
  QCOMPARE(options.fill.pieceEdges, std::size_t{77});
  QCOMPARE(options.maxEdges, std::size_t{77});  // none of our business
}

void MeshFidelityTest::nearWeldIsRead() {
  const double diagonal = std::sqrt(5.0);
  for (double nearWeld : {1e-6, 1e-4}) {
    for (double gap : {0.5 * nearWeld * diagonal, 2.0 * nearWeld * diagonal}) {
      const HalfEdgeMesh torn = tornSheet(gap);
      const bool isNear = gap < nearWeld * diagonal;
      QCOMPARE(findDefects(torn, nearWeld).nearVertices.size(), std::size_t{isNear ? 2u : 0u});
      QCOMPARE(inspected(torn, nearWeld).defects->nearVertices.size(), std::size_t{isNear ? 2u : 0u});
      RepairOptions options;
      options.nearWeld = nearWeld;
      options.sheets = SheetHandling::Keep;
      HalfEdgeMesh mesh = torn;
      QCOMPARE(repair(mesh, options).mergedVertices, std::size_t{isNear ? 2u : 0u});
      QCOMPARE(test::countBorder(mesh), std::size_t{isNear ? 6u : 8u});
    }
  }
}

void MeshFidelityTest::densityIsRead() {
  const HalfEdgeMesh mesh = buildMesh(test::sphereWithoutCap(4)).mesh;
  FillOptions options;
  options.tryOthers = false;
  std::size_t last = 0;
  for (double density : {0.5, 1.0, FillOptions().density, 2.5}) {
    options.density = density;
    const std::size_t points = firstPatch(mesh, options).points.size();
    QVERIFY(points > last);
    last = points;
  }
}

HANDWHEEL_TEST(MeshFidelityTest)
#include "MeshFidelityTest.moc"
