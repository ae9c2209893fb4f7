// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeResampling.h"

#include "ClosedSurface.h"
#include "TestClass.h"
#include "volume/VolumeFilters.h"
#include "volume/VolumeSampler.h"
#include "volume/VolumeShapes.h"
#include "volume/surface/DownsampledVolume.h"
#include "volume/surface/VolumeToSurface.h"

#include <QtTest>
#include <cmath>
#include <memory>
#include <set>
#include <tuple>
#include <vector>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// The part between two spheres, its middle 8 mm from the origin; in voxels of 0.25 mm.
SparseVolume thinShell(double wall) {
  SparseVolume made(Vec3(0.04, -0.07, 0.11), 0.25);
  for (int z = -5; z < 5; ++z)
    for (int y = -5; y < 5; ++y)
      for (int x = -5; x < 5; ++x) {
        auto samples = std::make_shared<VolumeBlock>();
        for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
          const VoxelIndex at = 8 * VoxelIndex(x, y, z) + VoxelIndex(i & 7, i >> 3 & 7, i >> 6);
          const double depth = 0.5 * wall - std::abs(made.centre(at).norm() - 8.0);
          samples->depths[static_cast<std::size_t>(i)] = depthSample(depth / made.voxel());
        }
        made.setContent({x, y, z}, contentOf(std::move(samples)));
      }
  return made;
}

// Returns true if a path through empty voxels, over faces, edges and corners, leads from the origin beyond the
// distance.
bool leaksOut(const SparseVolume& volume, int farthest) {
  const auto key = [](const VoxelIndex& at) { return std::tuple(at.x(), at.y(), at.z()); };
  std::set<std::tuple<int, int, int>> seen{key(VoxelIndex::Zero())};
  std::vector<VoxelIndex> next{VoxelIndex::Zero()};
  while (!next.empty()) {
    const VoxelIndex at = next.back();
    next.pop_back();
    if (at.cwiseAbs().maxCoeff() > farthest) return true;
    for (int k = 0; k < 27; ++k) {
      const VoxelIndex beside = at + VoxelIndex(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
      if (volume.sample(beside) < 0 && seen.insert(key(beside)).second) next.push_back(beside);
    }
  }
  return false;
}

}  // namespace

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
    const VolumeSampler sampler(*made);
    for (int i = 0; i < 200; ++i) {
      const Vec3 out = Vec3(std::sin(i), std::cos(3.0 * i), std::sin(2.0 * i + 1.0)).normalized();
      const double depth = 2.5 * voxel * std::sin(5.0 * i);
      // Made anew, distances are of first order: along diagonals too large by up to a quarter.
      const double known = voxel > from ? 0.25 * std::abs(depth) : 0.0;
      const double found = sampler.depthAt((radius - depth) * out).depth;
      QVERIFY2(std::abs(found - depth) < 0.1 * voxel + most + known,
               qPrintable(QString("%1 %2").arg(found / voxel).arg(depth / voxel)));
    }
    QVERIFY(made->sample(SparseVolume::blockOf(VoxelIndex::Zero())) > 0);
  }

  // A wall of a third of a voxel, which is thicker than a voxel of the volume that is halved twice: no path from inside
  // to outside, neither through voxels nor through the surface, which is two spheres.
  void halvedWallsStayClosed() {
    const double wall = 1.0 / 3.0;
    const SparseVolume once = downsampledVolume(thinShell(wall)), made = downsampledVolume(once);
    QCOMPARE(once.voxel(), 0.5);
    QCOMPARE(made.voxel(), 1.0);
    QCOMPARE(made.origin(), Vec3(0.04, -0.07, 0.11));
    QVERIFY(once.sample(VoxelIndex::Zero()) < 0 && made.sample(VoxelIndex::Zero()) < 0);
    QVERIFY(!leaksOut(once, 20));
    QVERIFY(!leaksOut(made, 10));
    QVERIFY(isClosedManifold(surfaceOf(once)));
    const TriangleSoup surface = surfaceOf(made);
    QVERIFY(isClosedManifold(surface));
    // A sample inside is at most one voxel of 0.25 mm and then one of 0.5 mm along each axis away from the wall, and
    // the surface in a cell of 1 mm beside it.
    const double most = std::sqrt(3.0) * 1.75 + 0.5 * wall;
    bool isInner = false, isOuter = false;
    for (const Vec3& p : surface.points) {
      QVERIFY(std::abs(p.norm() - 8.0) < most);
      isInner |= p.norm() < 8.0;
      isOuter |= p.norm() > 8.0;
    }
    QVERIFY(isInner && isOuter);
  }

  // A ball grows by no more than a voxel of what is halved along each axis, and its depths are distances.
  void halvedBall() {
    const double radius = 10.0, voxel = 0.2;
    const SparseVolume made = downsampledVolume(ballOfVoxels(radius, voxel));
    const TriangleSoup surface = surfaceOf(made);
    QVERIFY(isClosedManifold(surface));
    QCOMPARE(surface.points.size(), surface.triangles.size() / 2 + 2);
    for (const Vec3& p : surface.points)
      QVERIFY(p.norm() > radius - 0.05 && p.norm() < radius + std::sqrt(3.0) * voxel + 0.05);
    QVERIFY(made.sample(VoxelIndex::Zero()) == VolumeBlock::kFull);
    QVERIFY(downsampledVolume(SparseVolume(Vec3::Zero(), 1.0)).isEmpty());
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
