// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseRuns.h"
#include "TestClass.h"
#include "fidelity/CaseShapes.h"
#include "volume/SurfaceToVolume.h"
#include "volume/repair/VolumeRepair.h"

#include <QTest>

using namespace handwheel;

// The measurements of the reduction of a volume's surface, which take longer than all others of volumes.
class VolumeReductionCasesTest : public QObject {
  Q_OBJECT

 private slots:
  // The ball takes twice as long as the block.
  void everyCaseRuns_data() {
    test::addCases(test::CaseGroup::VolumeReduction, {{"volume.reduction", 0, 0}, {"volume.reduction", 1, 1}});
  }
  void everyCaseRuns() { test::runCase(); }
  void reductionOfASmallBall();
};

// Each run gives the same triangles. The ball that is measured has 16 times as many, and 128 voxels along it.
void VolumeReductionCasesTest::reductionOfASmallBall() {
  const TriangleSoup ball = sphereSoup(3, 25.0);
  const double within = test::measured().find("volume.reduction")->setting.standard;
  TriangleSoup first;
  for (int run = 0; run < 2; ++run) {
    const Result<VolumeRepair> repair = repairByVolume(ball, {.voxel = usualVoxel(ball, 32.0), .within = within});
    QVERIFY(repair.hasValue());
    QVERIFY(repair->mesh.liveFaceCount() < repair->sampledTriangles);
    const TriangleSoup reduced = repair->mesh.compact().soup;
    if (run == 0) first = reduced;
    QVERIFY(reduced.points == first.points);
    QVERIFY(reduced.triangles == first.triangles);
  }
}

HANDWHEEL_TEST(VolumeReductionCasesTest)
#include "VolumeReductionCasesTest.moc"
