// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseRuns.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "fidelity/CaseShapes.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

FidelityCase onMesh(const char* id, const TriangleSoup& soup) {
  const auto shared = std::make_shared<const TriangleSoup>(soup);
  return casesOnMesh(id, "mesh", [shared] { return shared; }).at(0);
}

}  // namespace

// The measured settings of meshes.
class MeshCasesTest : public QObject {
  Q_OBJECT

 private slots:
  // Other settings run on the same scans, and the spheres are measured like the toruses.
  void everyCaseRuns_data() {
    test::addCases(test::CaseGroup::Mesh, {{"mesh.fill_continuity", 2, 0},
                                           {"mesh.patch_density", 3, 0},
                                           {"mesh.piece_edges", 1, 0},
                                           {"mesh.decimation_error", 1, 0}});
  }
  void everyCaseRuns() { test::runCase(); }
  void creasesCarryEdgesThroughHoles();
  void tornVerticesOfAMesh();
  void patchesOfAMesh();
  void standInsOfAMesh();
  void fewerTrianglesOfAMesh();
  void smallAndDegenerateMeshes_data();
  void smallAndDegenerateMeshes();
};

// The purpose of the method: if a sharp edge goes through a hole, a patch that continues it is nearer to the part.
void MeshCasesTest::creasesCarryEdgesThroughHoles() {
  const FidelityRegistry::Entry& entry = *test::measured().find("mesh.fill_method");
  std::size_t scans = 0;
  for (const FidelityCase& c : entry.cases) {
    if (c.name.find("scanned") == std::string::npos) continue;
    ++scans;
    const double fair = test::errorAt(c, *valueOf(entry.setting, "fair")),
                 crease = test::errorAt(c, *valueOf(entry.setting, "ridge"));
    QVERIFY2(crease < fair, qPrintable(QString("%1: %2 and %3").arg(c.name.c_str()).arg(crease).arg(fair)));
  }
  QCOMPARE(scans, std::size_t{2});
}

// About half of what is parted are tears, half gaps: no tolerance leaves the tears, a huge one eats the gaps.
void MeshCasesTest::tornVerticesOfAMesh() {
  const FidelityCase c = onMesh("mesh.near_weld", torusSoup(60, 40, 20.0, 6.0));
  QCOMPARE(test::errorAt(c, 1e-5), 0.0);
  QVERIFY(test::errorAt(c, 1e-8) > 30.0 && test::errorAt(c, 1e-8) < 70.0);
  QVERIFY(test::errorAt(c, 1e-3) > 20.0 && test::errorAt(c, 1e-3) < 70.0);
}

void MeshCasesTest::patchesOfAMesh() {
  const TriangleSoup soup = sphereSoup(4, 10.0);
  const FidelityCase method = onMesh("mesh.fill_method", soup), density = onMesh("mesh.patch_density", soup);
  const FidelityRegistry::Entry& entry = *test::measured().find("mesh.fill_method");
  const double fair = test::errorAt(method, *valueOf(entry.setting, "fair"));
  QVERIFY(fair < 0.5);                                                   // % of the hole: it continues the curvature,
  QVERIFY(test::errorAt(method, *valueOf(entry.setting, "ear")) > 2.0);  // a flat lid cannot do this
  QCOMPARE(test::errorAt(density, test::measured().find("mesh.patch_density")->setting.standard), fair);
  QVERIFY(casesOnMesh("nurbs.chord_mm", "mesh", nullptr).empty());
}

// A small mesh is drawn as it is; what stands in for a large one lies closer the more triangles it has.
void MeshCasesTest::standInsOfAMesh() {
  const FidelityCase small = onMesh("view.coarse_triangles", sphereSoup(4, 10.0));
  QCOMPARE(small.run(2000.0, 1, {}).error, 0.0);
  QCOMPARE(small.run(2000.0, 1, {}).cost, 5120.0);
  const FidelityCase large = onMesh("view.coarse_triangles", sphereSoup(6, 10.0));  // 81,920 faces
  const FidelitySample few = large.run(2000.0, 1, {}), more = large.run(10000.0, 1, {});
  QVERIFY(few.cost < more.cost && few.cost > 1000.0 && more.cost < 20000.0);
  QVERIFY(few.error > more.error && more.error > 0.0);
  QVERIFY(few.error < 1.0);  // % of the diagonal: half a cell
  QCOMPARE(test::errorAt(large, 2000.0), few.error);
}

// The distance is kept and made use of: at a hundred times of it there are far fewer triangles.
void MeshCasesTest::fewerTrianglesOfAMesh() {
  const FidelityCase ball = onMesh("mesh.decimation_error", sphereSoup(4, 10.0));
  const FidelitySample fine = ball.run(1e-4, 1, {}), coarse = ball.run(1e-2, 1, {});
  QVERIFY(fine.error <= 0.01);  // %
  QVERIFY(coarse.error > 0.5 && coarse.error <= 1.0);
  QVERIFY(coarse.cost > 0.0 && coarse.cost < 0.1 * fine.cost && fine.cost <= 100.0);
  const FidelitySample cube = onMesh("mesh.decimation_error", test::cube()).run(1e-2, 1, {});
  QCOMPARE(cube.error, 0.0);
  QCOMPARE(cube.cost, 100.0);  // every corner counts
}

void MeshCasesTest::smallAndDegenerateMeshes_data() {
  QTest::addColumn<int>("shape");
  QTest::newRow("one triangle") << 0;
  QTest::newRow("tetrahedron") << 1;
  QTest::newRow("Klein bottle") << 2;
  QTest::newRow("no area") << 3;
  QTest::newRow("far away") << 4;
}

// For any mesh of the user: no crash, and no error that is not a number.
void MeshCasesTest::smallAndDegenerateMeshes() {
  QFETCH(int, shape);
  const TriangleSoup soups[] = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}},
                                test::tetrahedron(),
                                test::kleinBottle(20, 10),
                                {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 0, 1}}},
                                test::moved(test::icosphere(3), Vec3(1e7, 1e7, 1e7))};
  for (const auto& entry : test::measured().entries()) {
    for (const FidelityCase& c :
         casesOnMesh(entry.setting.id, "mesh", [&] { return std::make_shared<const TriangleSoup>(soups[shape]); })) {
      for (double value : {entry.setting.least, entry.setting.standard, entry.setting.largest}) {
        const FidelitySample sample = c.run(value, 1, {});
        QVERIFY(!std::isnan(sample.error) && sample.error >= 0.0);
        QVERIFY(std::isfinite(sample.cost) && sample.cost >= 0.0);
      }
    }
  }
}

HANDWHEEL_TEST(MeshCasesTest)
#include "MeshCasesTest.moc"
