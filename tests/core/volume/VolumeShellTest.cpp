// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "EnclosedVolume.h"
#include "SolidShapes.h"
#include "TestClass.h"
#include "volume/VolumeOffset.h"
#include "volume/VolumeShapes.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// Walls along the surface of a volume; what walls cannot be is in VolumeOffsetTest.
class VolumeShellTest : public QObject {
  Q_OBJECT

 private slots:
  void shellsOfBalls_data() {
    QTest::addColumn<int>("side");
    QTest::addColumn<double>("wall");
    for (const double wall : {0.5, 1.0, 3.0})
      for (const int side : {0, 1, 2}) QTest::addRow("%d, %g", side, wall) << side << wall;
  }
  void shellsOfBalls() {
    QFETCH(int, side);
    QFETCH(double, wall);
    const double radius = 4.0, voxel = 0.2;
    const auto where = static_cast<WallSide>(side);
    const double out = where == WallSide::Outside ? wall : where == WallSide::Middle ? 0.5 * wall : 0.0;
    const Result<SparseVolume> made = shellOf(ballOfVoxels(radius, voxel), wall, where);
    compareVolume(made, ballVolume(radius + out) - ballVolume(radius + out - wall), 0.01);
    // Two spheres: twice Euler's characteristic of one.
    const TriangleSoup surface = surfaceOf(*made);
    QCOMPARE(surface.points.size(), surface.triangles.size() / 2 + 4);
    QVERIFY(made->sample(VoxelIndex::Zero()) < 0);
  }

  void shellsOfCubes() {
    const double side = 10.0, wall = 1.0;
    const SparseVolume box = boxOfVoxels(Vec3::Constant(side), Vec3(0.0, 1.0, 0.0), 0.2);
    compareVolume(shellOf(box, wall, WallSide::Inside), std::pow(side, 3.0) - std::pow(side - 2.0 * wall, 3.0), 0.02);
    compareVolume(shellOf(box, wall, WallSide::Outside), roundedCubeVolume(side, wall) - std::pow(side, 3.0), 0.02);
  }
};

HANDWHEEL_TEST(VolumeShellTest)
#include "VolumeShellTest.moc"
