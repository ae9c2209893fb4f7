// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeFilters.h"

#include "ClosedSurface.h"
#include "TestClass.h"
#include "volume/VolumeSampler.h"
#include "volume/VolumeShapes.h"
#include "volume/surface/VolumeToSurface.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

class VolumeFiltersTest : public QObject {
  Q_OBJECT

 private slots:
  void blocksAround() {
    const std::vector<VoxelIndex> two{{0, 0, 0}, {1, 0, 0}};
    const std::vector<VoxelIndex> around = withNeighbours(two);
    QCOMPARE(around.size(), std::size_t{36});
    QCOMPARE(around.front(), VoxelIndex(-1, -1, -1));
  }

  // Depths that say no more than the side become distances, up to half a voxel, which is what the sides tell.
  void distancesOfSides() {
    SparseVolume ball = ballOfVoxels(5.0, 0.2);
    for (const VoxelIndex& at : ball.blocks()) {
      auto block = std::make_shared<VolumeBlock>(*ball.content(at).block);
      for (auto& depth : block->depths) depth = depth > 0 ? VolumeBlock::kFull : VolumeBlock::kEmpty;
      ball.setContent(at, {std::move(block), false});
    }
    const double material = ball.material();
    makeDistances(ball, ball.blocks(), DepthWindow::Beside::Corrected);
    QCOMPARE(ball.material(), material);
    const VolumeSampler sampler(ball);
    for (int i = 0; i < 100; ++i) {
      const Vec3 out = Vec3(std::sin(i), std::cos(3.0 * i), std::sin(2.0 * i + 1.0)).normalized();
      const double radius = 5.0 + 0.4 * std::sin(5.0 * i);
      QVERIFY(std::abs(sampler.depthAt(radius * out).depth - (5.0 - radius)) < 0.15);
    }
  }

  // The steps of a ball of cubes go, and the ball stays.
  void smoothed() {
    SparseVolume ball = ballOfVoxels(5.0, 0.2);
    for (const VoxelIndex& at : ball.blocks()) {
      auto block = std::make_shared<VolumeBlock>(*ball.content(at).block);
      for (auto& depth : block->depths) depth = depth > 0 ? std::int16_t{4096} : std::int16_t{-4096};
      ball.setContent(at, {std::move(block), false});
    }
    makeDistances(ball, ball.blocks(), DepthWindow::Beside::Corrected);
    const auto roughness = [&] {
      double sum = 0.0;
      const TriangleSoup surface = surfaceOf(ball);
      for (const Vec3& p : surface.points) sum += std::abs(p.norm() - 5.0);
      return sum / static_cast<double>(surface.points.size());
    };
    const double before = roughness();
    smooth(ball);
    QVERIFY(roughness() < 0.6 * before);
    QVERIFY(std::abs(ball.material() / (4.0 / 3.0 * M_PI * 125.0) - 1.0) < 0.02);
    const TriangleSoup surface = surfaceOf(ball);
    QVERIFY(isClosedManifold(surface));
    // Euler's characteristic of one sphere: no speck is left, and no handle.
    QCOMPARE(surface.points.size(), surface.triangles.size() / 2 + 2);
  }

  void cancelledChangesNothing() {
    SparseVolume ball = ballOfVoxels(5.0, 0.5);
    const double material = ball.material();
    JobState job;
    job.cancelled = true;
    smooth(ball, Progress(job));
    QCOMPARE(ball.material(), material);
  }
};

HANDWHEEL_TEST(VolumeFiltersTest)
#include "VolumeFiltersTest.moc"
