// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/RepairPrediction.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "volume/SurfaceToVolume.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

class RepairPredictionTest : public QObject {
  Q_OBJECT

 private slots:
  // The counts are right to a factor of two, on flat and on round surfaces, one or several.
  void countedWork() {
    TriangleSoup overlapping = cube(10.0);
    append(overlapping, moved(cube(10.0), Vec3(6.0, 6.0, 6.0)));
    TriangleSoup plate = cube(1.0);
    for (Vec3& p : plate.points) p = p.cwiseProduct(Vec3(30.0, 30.0, 3.0));
    for (const TriangleSoup& surface :
         {cube(10.0), moved(icosphere(4), Vec3::Zero(), 10.0), overlapping, plate, icosphere(1)}) {
      const VolumeRepairOptions options{.voxel = usualVoxel(surface, 30.0)};
      const RepairWork work = predictedRepairWork(surfaceArea(surface), surface.triangles.size(), options);
      const Result<VolumeRepair> repair = repairByVolume(surface, options);
      QVERIFY(repair.hasValue());
      const double sampled = work.sampled / static_cast<double>(repair->sampledTriangles);
      QVERIFY2(sampled > 0.5 && sampled < 2.0, qPrintable(QString::number(sampled)));
      const double triangles = work.triangles / static_cast<double>(repair->mesh.liveFaceCount());
      QVERIFY2(triangles > 0.5 && triangles < 2.0, qPrintable(QString::number(triangles)));
    }
  }

  // The time goes by the sampled triangles: four times as many for half the voxel.
  void time() {
    const auto seconds = [](double voxel) { return predictedRepairSeconds(60'000.0, 1'000, {.voxel = voxel}); };
    QVERIFY(seconds(0.1) > 3.5 * seconds(0.2) && seconds(0.1) < 4.0 * seconds(0.2));
    // Without triangles to take away it is less.
    QVERIFY(predictedRepairSeconds(60'000.0, 1'000, {.voxel = 0.1, .isReduced = false}) < 0.5 * seconds(0.1));
  }
};

HANDWHEEL_TEST(RepairPredictionTest)
#include "RepairPredictionTest.moc"
