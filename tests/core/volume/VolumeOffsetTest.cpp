// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeOffset.h"

#include "EnclosedVolume.h"
#include "SolidShapes.h"
#include "TestClass.h"
#include "volume/VolumeBoolean.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeSampler.h"
#include "volume/VolumeShapes.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

class VolumeOffsetTest : public QObject {
  Q_OBJECT

 private slots:
  // A ball stays one, near and far beyond the depths that are stored.
  void balls_data() {
    QTest::addColumn<double>("distance");
    for (const double distance : {-2.5, -1.0, -0.3, -0.05, 0.0, 0.05, 0.5, 3.0, 9.0})
      QTest::addRow("%g", distance) << distance;
  }
  void balls() {
    QFETCH(double, distance);
    const double radius = 3.0, voxel = 0.2;
    const Result<SparseVolume> made = movedSurface(ballOfVoxels(radius, voxel), distance);
    QVERIFY(made.hasValue());
    const TriangleSoup surface = surfaceOf(*made);
    QVERIFY(isClosedManifold(surface));
    QCOMPARE(surface.points.size(), surface.triangles.size() / 2 + 2);
    // The cells of the first ball are flat, and those of the second.
    const double bend = voxel * voxel * (1.0 / radius + 1.0 / (radius + distance));
    for (const Vec3& p : surface.points)
      QVERIFY2(std::abs(p.norm() - radius - distance) < 0.01 * voxel + bend,
               qPrintable(QString::number(p.norm() - radius - distance)));
    const VolumeSampler sampler(*made);
    QVERIFY(sampler.depthAt(Vec3::Zero()).depth > 0.0);
    for (const double beside : {-2.0, -1.0, 1.0, 2.0}) {
      if (beside * voxel > 0.5 * (radius + distance)) continue;  // the middle, where distances have a corner
      const Vec3 at = (radius + distance - beside * voxel) * Vec3(2.0, -1.0, 3.0).normalized();
      QVERIFY(std::abs(sampler.depthAt(at).depth / voxel - beside) < 0.35);
    }
  }

  void cubes() {
    const double side = 10.0, voxel = 0.2;
    const SparseVolume box = boxOfVoxels(Vec3::Constant(side), Vec3(1.0, 2.0, 3.0), voxel);
    for (const double distance : {0.3, 3.0})
      compareVolume(movedSurface(box, distance), roundedCubeVolume(side, distance), 0.01);
    // Inwards its edges stay sharp, but for the half voxel that marching cubes cut off.
    for (const double distance : {0.3, 2.0, 4.0})
      compareVolume(movedSurface(box, -distance), std::pow(side - 2.0 * distance, 3.0), 0.03);
    QVERIFY(movedSurface(box, -5.2)->isEmpty());
  }

  // Two blocks side by side, apart by a millimetre: a ball of 0.7 does not get between them, one of 0.4 does.
  void gapsAreClosed() {
    const double voxel = 0.1;
    const Vec3 size(3.0, 4.0, 4.0);
    const SparseVolume one = boxOfVoxels(size, Vec3(0.0, 0.0, 0.0), voxel),
                       other = boxOfVoxels(size, Vec3(4.0, 0.0, 0.0), voxel);
    const SparseVolume both = *combined(one, other, VolumeBoolean::Unite);
    const Result<SparseVolume> closed = withoutGaps(both, 0.7);
    // The filling is as wide as the gap, but for the segment of a circle between the rims on which the ball rests along
    // each side; at the corners it differs slightly, by less than four squares of the segment's height.
    const double segment = 0.49 * std::asin(0.5 / 0.7) - 0.5 * std::sqrt(0.49 - 0.25),
                 filled = 16.0 - 4.0 * 4.0 * segment;
    compareVolume(closed, 2.0 * 48.0 + filled, 0.01);
    const TriangleSoup surface = surfaceOf(*closed);
    QCOMPARE(surface.points.size(), surface.triangles.size() / 2 + 2);
    QVERIFY(VolumeSampler(*closed).depthAt(Vec3(3.5, 2.0, 2.0)).depth > 0.0);
    const Result<SparseVolume> open = withoutGaps(both, 0.4);
    compareVolume(open, 2.0 * 48.0, 0.01);
    QVERIFY(VolumeSampler(*open).depthAt(Vec3(3.5, 2.0, 2.0)).depth < 0.0);
  }

  // A bridge between two blocks that holds no ball of 0.6 goes, and the blocks stay but for their edges.
  void thinPartsGo() {
    const double voxel = 0.1;
    SparseVolume part = boxOfVoxels(Vec3(5.0, 5.0, 5.0), Vec3::Zero(), voxel);
    for (const auto& [size, corner] :
         {std::pair{Vec3(5.0, 5.0, 5.0), Vec3(10.0, 0.0, 0.0)}, std::pair{Vec3(6.0, 1.0, 1.0), Vec3(4.5, 2.0, 2.0)}})
      part = *combined(part, boxOfVoxels(size, corner, voxel), VolumeBoolean::Unite);
    const Result<SparseVolume> opened = withoutThinParts(part, 0.6);
    QVERIFY(VolumeSampler(*opened).depthAt(Vec3(7.5, 2.5, 2.5)).depth < 0.0);
    // A cube that a ball rolls through: the rounded one whose inner cube is smaller by its diameter.
    compareVolume(opened, 2.0 * roundedCubeVolume(5.0 - 1.2, 0.6), 0.01);
    const TriangleSoup surface = surfaceOf(*opened);
    QCOMPARE(surface.points.size(), surface.triangles.size() / 2 + 4);
  }

  // Closing only adds and opening only removes, for any part.
  void closingAddsOpeningTakes() {
    const double voxel = 0.25;
    SparseVolume part = ballOfVoxels(3.0, voxel);
    for (int i = 0; i < 6; ++i)
      part = *combined(
          part, boxOfVoxels(Vec3(0.7 + 0.4 * i, 3.0, 1.1), Vec3(2.0 * std::sin(i), 0.5 * i, std::cos(2.0 * i)), voxel),
          i % 3 == 2 ? VolumeBoolean::Subtract : VolumeBoolean::Unite);
    const VolumeSampler before(part);
    const SparseVolume closed = *withoutGaps(part, 0.8), opened = *withoutThinParts(part, 0.8);
    const VolumeSampler afterClosing(closed), afterOpening(opened);
    for (int z = -25; z < 25; ++z)
      for (int y = -25; y < 25; ++y)
        for (int x = -25; x < 25; ++x) {
          const Vec3 p = part.centre(VoxelIndex(x, y, z));
          if (before.depthAt(p).depth > 0.0) QVERIFY(afterClosing.depthAt(p).depth > 0.0);
          if (before.depthAt(p).depth < 0.0) QVERIFY(afterOpening.depthAt(p).depth < 0.0);
        }
  }

  void whatCannotBe() {
    const SparseVolume ball = ballOfVoxels(5.0, 0.2);
    QCOMPARE(shellOf(ball, 0.3, WallSide::Inside).error().code, VolumeErrors::WallTooThin);
    QCOMPARE(shellOf(ball, -1.0, WallSide::Inside).error().code, ErrorCode::ValueOutOfRange);
    QCOMPARE(movedSurface(ball, NAN).error().code, ErrorCode::ValueOutOfRange);
    QCOMPARE(withoutGaps(ball, -1.0).error().code, ErrorCode::ValueOutOfRange);
    QCOMPARE(movedSurface(ball, 1e7).error().code, VolumeErrors::TooFine);
    // A sphere of 1 km in voxels of 0.2 mm.
    const Result<SparseVolume> huge = movedSurface(ball, 1e5);
    QCOMPARE(huge.error().code, VolumeErrors::TooLarge);
    QCOMPARE(huge.error().arguments.size(), std::size_t{3});
    QVERIFY(movedSurface(SparseVolume(Vec3::Zero(), 1.0), 3.0)->isEmpty());
    JobState job;
    job.cancelled = true;
    QCOMPARE(movedSurface(ball, 1.0, Progress(job)).error().code, ErrorCode::Cancelled);
  }
};

HANDWHEEL_TEST(VolumeOffsetTest)
#include "VolumeOffsetTest.moc"
