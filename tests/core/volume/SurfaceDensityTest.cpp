// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/SurfaceDensity.h"

#include "ClosedSurface.h"
#include "SolidShapes.h"
#include "TestClass.h"
#include "proximity/TriangleHierarchy.h"
#include "volume/VolumeErrors.h"
#include "volume/surface/VolumeToSurface.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

class SurfaceDensityTest : public QObject {
  Q_OBJECT

 private slots:
  // A ball has its volume, and its surface is within a fraction of a voxel; by distances it is nearer.
  void ball() {
    const TriangleSoup ball = moved(icosphere(4), Vec3(1.0, 2.0, 3.0), 10.0);
    const double voxel = 0.4;
    std::array<double, 2> farthest{};
    for (const VoxelMethod method : {VoxelMethod::Sign, VoxelMethod::Density}) {
      const Result<SurfaceVolume> made = volumeOfSurface(ball, voxel, method, {});
      QVERIFY(made.hasValue());
      const TriangleSoup surface = surfaceOf(made->volume);
      QVERIFY(isClosedManifold(surface));
      QCOMPARE(surface.points.size(), surface.triangles.size() / 2 + 2);
      QVERIFY(std::abs(enclosed(surface) / enclosed(ball) - 1.0) < 5e-3);
      QVERIFY(made->nearShare > 0.999);
      const TriangleHierarchy hierarchy(ball.points, ball.triangles);
      double& most = farthest[static_cast<std::size_t>(method)];
      for (const Vec3& p : surface.points) most = std::max(most, std::sqrt(hierarchy.nearest(p)->squaredDistance));
    }
    QVERIFY(farthest[0] < farthest[1]);
    // Half a voxel is where a density that is full or empty would be.
    QVERIFY2(farthest[1] < 0.25 * voxel, qPrintable(QString::number(farthest[1] / voxel)));
  }

  // The sides of a box may have any offset from the voxels.
  void boxes() {
    for (const double corner : {0.0, 0.13, 0.37}) {
      const TriangleSoup box = cube(8.0, Vec3(corner, 2.0 * corner, 1.0));
      const Result<SurfaceVolume> made = volumeByDensity(box, 0.5);
      QVERIFY(made.hasValue());
      QVERIFY(std::abs(made->expected - 512.0) < 1e-6);
      QVERIFY(std::abs(enclosed(surfaceOf(made->volume)) / 512.0 - 1.0) < 0.03);
    }
  }

  // Open, doubled and overlapping: inside is what is gone round at least once.
  void scans() {
    TriangleSoup two = cube(6.0);
    append(two, cube(6.0, Vec3(3.0, 0.1, 0.2)));
    two.triangles.pop_back();
    const Result<SurfaceVolume> made = volumeByDensity(two, 0.25);
    QVERIFY(made.hasValue());
    QCOMPARE(made->closedBoundaries, std::size_t{1});
    const double exact = 2.0 * 216.0 - 3.0 * 5.9 * 5.8;
    QVERIFY(std::abs(enclosed(surfaceOf(made->volume)) / exact - 1.0) < 0.03);
  }

  void whatCannotBe() {
    QCOMPARE(volumeByDensity(cube(), 1e-7).error().code, VolumeErrors::TooFine);
    QCOMPARE(volumeByDensity(cube(), 1e-5).error().code, VolumeErrors::TooLarge);
    QCOMPARE(volumeByDensity(turnedOver(cube()), 0.1).error().code, VolumeErrors::NothingInside);
    JobState job;
    job.cancelled = true;
    QCOMPARE(volumeByDensity(cube(), 0.1, Progress(job)).error().code, ErrorCode::Cancelled);
  }
};

HANDWHEEL_TEST(SurfaceDensityTest)
#include "SurfaceDensityTest.moc"
