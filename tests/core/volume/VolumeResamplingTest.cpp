// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeResampling.h"

#include "ClosedSurface.h"
#include "TestClass.h"
#include "volume/VolumeReader.h"
#include "volume/VolumeShapes.h"
#include "volume/surface/VolumeToSurface.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

class VolumeResamplingTest : public QObject {
  Q_OBJECT

 private slots:
  // A ball stays where it is, in finer and in coarser voxels, and its depths are distances again.
  void ball_data() {
    QTest::addColumn<double>("voxel");
    for (const double voxel : {0.05, 0.15, 0.2, 0.3, 0.4, 0.7, 1.1}) QTest::addRow("%g", voxel) << voxel;
  }
  void ball() {
    QFETCH(double, voxel);
    const double radius = 10.0, from = 0.2;
    const Result<SparseVolume> made = resampled(ballOfVoxels(radius, from), Vec3(0.03, -0.01, 5.02), voxel);
    QVERIFY(made.hasValue());
    const TriangleSoup surface = surfaceOf(*made);
    QVERIFY(isClosedManifold(surface));
    QCOMPARE(surface.points.size(), surface.triangles.size() / 2 + 2);
    // Linear interpolation errs by a quarter of the square of a voxel to the radius, and cells by as much; points keep
    // a hundredth of a voxel away from samples.
    const double coarsest = std::max(voxel, from), most = 0.5 * coarsest * coarsest / radius + 0.01 * voxel;
    for (const Vec3& p : surface.points)
      QVERIFY2(std::abs(p.norm() - radius) < most, qPrintable(QString::number(p.norm() - radius)));
    const VolumeReader reader(*made);
    for (int i = 0; i < 200; ++i) {
      const Vec3 out = Vec3(std::sin(i), std::cos(3.0 * i), std::sin(2.0 * i + 1.0)).normalized();
      const double depth = 2.5 * voxel * std::sin(5.0 * i);
      // Made anew, distances are of first order: along diagonals too large by up to a quarter.
      const double known = voxel > from ? 0.25 * std::abs(depth) : 0.0;
      const double found = reader.depthAt((radius - depth) * out).depth;
      QVERIFY2(std::abs(found - depth) < 0.1 * voxel + most + known,
               qPrintable(QString("%1 %2").arg(found / voxel).arg(depth / voxel)));
    }
    QVERIFY(made->sample(SparseVolume::blockOf(VoxelIndex::Zero())) > 0);
  }

  void sharedWhereItCan() {
    const SparseVolume ball = ballOfVoxels(5.0, 0.2);
    const Result<SparseVolume> made = resampled(ball, Vec3(-1.6, 3.2, 0.0), 0.2);
    QCOMPARE(made->blockCount(), ball.blockCount());
    for (const VoxelIndex& at : ball.blocks()) QVERIFY(made->content(at + VoxelIndex(1, -2, 0)) == ball.content(at));
    QVERIFY(resampled(SparseVolume(Vec3::Zero(), 1.0), Vec3::Ones(), 0.3)->isEmpty());
  }
};

HANDWHEEL_TEST(VolumeResamplingTest)
#include "VolumeResamplingTest.moc"
