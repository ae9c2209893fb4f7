// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseRuns.h"
#include "TestClass.h"
#include "fidelity/CaseShapes.h"
#include "mesh/structure/MeshBuilder.h"
#include "viewport/surface/SurfaceGeometry.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

// The measured settings other than those of meshes and volumes.
class CasesTest : public QObject {
  Q_OBJECT

 private slots:
  // Cases of the same setting differ in their shapes only; TouchCasesTest slides along the bumpy ball at both speeds.
  // blocksOfAMesh() and MeshCasesTest measure the display on smaller meshes.
  void everyCaseRuns_data() {
    test::addCases(test::CaseGroup::Other, {{"step.chord", 1, 1},
                                            {"view.block_faces", 0, 0},
                                            {"view.coarse_triangles", 0, 0},
                                            {"view.coarse_triangles", 1, 0},
                                            {"plan.resolution", 1, 0},
                                            {"plan.shortcuts", 0, 0},
                                            {"verify.step", 1, 0},
                                            {"proximity.tolerance", 1, 0},
                                            {"proxy.tolerance", 1, 0}});
  }
  void everyCaseRuns() { test::runCase(); }
  void blocksOfAnySize();
  void blocksOfAMesh();
  void sidesOfRoundShapes();
};

// However the faces are parted into blocks: each is drawn once.
void CasesTest::blocksOfAnySize() {
  const HalfEdgeMesh mesh = buildMesh(torusSoup(60, 40, 20.0, 6.0)).mesh;
  for (Face faces : {Face{1}, Face{7}, Face{1000}, kBlockFaces}) {
    QCOMPARE(blockCount(mesh, faces), (4800 + std::size_t{faces} - 1) / faces);
    std::size_t drawn = 0;
    for (std::size_t b = 0; b < blockCount(mesh, faces); ++b) {
      const SurfaceGeometry g = blockGeometry(mesh, b, Vec3::Zero(), faces);
      QVERIFY(g.indices.size() <= 3 * std::size_t{faces});
      drawn += g.indices.size() / 3;
    }
    QCOMPARE(drawn, std::size_t{4800});
  }
}

// A mesh of 40,000 faces is drawn in 10 blocks of 4,096.
void CasesTest::blocksOfAMesh() {
  const FidelitySetting& setting = test::measured().find("view.block_faces")->setting;
  QCOMPARE(setting.least, 4096.0);
  const FidelityCase onTorus = casesOnMesh(setting.id, "torus", torusSource(200, 100, 100.0, 20.0)).at(0);
  for (int run = 0; run < 2; ++run) {
    const FidelitySample sample = onTorus.run(setting.least, 1, {});
    QCOMPARE(sample.error, 10.0);
    QVERIFY(sample.cost > 0.0);
  }
  QCOMPARE(test::errorAt(onTorus, setting.standard), 1.0);
}

// A chord of a circle is furthest from it in its middle: by 1 - cos(pi / n) of the radius.
void CasesTest::sidesOfRoundShapes() {
  const FidelityRegistry::Entry& entry = *test::measured().find("cell.shape_sides");
  for (double n : {8.0, 13.0, 48.0, 128.0}) {
    const double chord = 100.0 * (1.0 - std::cos(M_PI / n));
    const FidelitySample ball = entry.cases.at(0).run(n, 1, {}), cylinder = entry.cases.at(1).run(n, 1, {});
    QVERIFY(std::abs(cylinder.error - chord) < 1e-9);
    QCOMPARE(cylinder.cost, 4.0 * n);
    QVERIFY(ball.error > chord && ball.error < 3.0 * chord);  // bent in both directions
    QCOMPARE(ball.cost, 2.0 * n * (std::floor(n / 2.0) - 1.0));
  }
}

HANDWHEEL_TEST(CasesTest)
#include "CasesTest.moc"
