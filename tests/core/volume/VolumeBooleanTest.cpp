// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeBoolean.h"

#include "ClosedSurface.h"
#include "SolidShapes.h"
#include "TestClass.h"
#include "volume/VolumeErrors.h"
#include "volume/surface/VolumeToSurface.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Returns the volume of the intersection of two balls at a distance (two caps).
double lensVolume(double a, double b, double d) {
  return M_PI * (a + b - d) * (a + b - d) * (d * d + 2.0 * d * (a + b) - 3.0 * (a - b) * (a - b)) / (12.0 * d);
}

bool decided(bool a, bool b, VolumeBoolean how) {
  if (how == VolumeBoolean::Unite) return a || b;
  return how == VolumeBoolean::Subtract ? a && !b : a && b;
}

constexpr std::array kAll{VolumeBoolean::Unite, VolumeBoolean::Subtract, VolumeBoolean::Intersect};

}  // namespace

class VolumeBooleanTest : public QObject {
  Q_OBJECT

 private slots:
  // Two balls that overlap, the second in grids as fine, shifted, coarser, and much finer: what they share is a lens.
  void balls_data() {
    QTest::addColumn<double>("voxel");
    QTest::addColumn<double>("shift");
    QTest::newRow("the same grid") << 0.2 << 0.0;
    QTest::newRow("whole blocks apart") << 0.2 << 16.0 * 0.2;
    QTest::newRow("shifted") << 0.2 << 0.07;
    QTest::newRow("coarser") << 0.33 << 0.1;
    QTest::newRow("finer") << 0.13 << 0.05;
    QTest::newRow("much finer") << 0.03 << 0.0;
  }
  void balls() {
    QFETCH(double, voxel);
    QFETCH(double, shift);
    const double a = 5.0, b = 3.5, d = 5.5;
    const SparseVolume first = withBall(SparseVolume(Vec3(1.0, 2.0, 3.0), 0.2), Vec3(1.0, 2.0, 3.0), a);
    const SparseVolume second =
        withBall(SparseVolume(Vec3(1.0 + shift, 2.0, 3.0 - shift), voxel), Vec3(1.0 + d, 2.0, 3.0), b);
    const double lens = lensVolume(a, b, d);
    const std::array exact{ballVolume(a) + ballVolume(b) - lens, ballVolume(a) - lens, lens};
    for (std::size_t i = 0; i < kAll.size(); ++i) {
      const Result<SparseVolume> made = combined(first, second, kAll[i]);
      QVERIFY(made.hasValue());
      QCOMPARE(made->voxel(), 0.2);
      const TriangleSoup surface = surfaceOf(*made);
      QVERIFY(isClosedManifold(surface));
      const double volume = enclosed(surface);
      // Surfaces are off by a quarter of the square of a voxel to the radius, twice.
      const double within = 0.005 * exact[i] + 0.5 * std::pow(std::max(voxel, 0.2), 2.0) / b * 60.0;
      QVERIFY2(std::abs(volume - exact[i]) < within, qPrintable(QString("%1 %2").arg(volume).arg(exact[i])));
      // One body each: Euler's characteristic of a sphere.
      QCOMPARE(surface.points.size(), surface.triangles.size() / 2 + 2);
    }
  }

  // The least number of 16 bits has no opposite among them; files may contain it.
  void theLeastDepth() {
    SparseVolume first(Vec3::Zero(), 1.0), second(Vec3::Zero(), 1.0);
    first.setContent(VoxelIndex::Zero(), {nullptr, true});
    auto block = std::make_shared<VolumeBlock>();
    block->depths.fill(-32768);
    block->depths[0] = 8192;
    second.setContent(VoxelIndex::Zero(), {block, false});
    const Result<SparseVolume> made = combined(first, second, VolumeBoolean::Subtract);
    QVERIFY(made.hasValue());
    QVERIFY(made->sample(VoxelIndex(0, 0, 0)) < 0);
    QVERIFY(made->sample(VoxelIndex(7, 7, 7)) > 0);
  }

  // In one grid each voxel is decided exactly, whatever the volumes are; and so the counts keep the laws of sets.
  void everyVoxel() {
    QVERIFY(rc::check([&] {
      const auto number = [] { return 0.01 * *rc::gen::inRange(-800, 800); };
      const auto body = [&] {
        SparseVolume volume(Vec3::Zero(), 0.5);
        const int balls = *rc::gen::inRange(0, 4);
        for (int i = 0; i < balls; ++i)
          volume = withBall(volume, Vec3(number(), number(), number()), 0.1 + std::abs(number()));
        return volume;
      };
      const SparseVolume a = body(), b = body();
      std::array<double, 3> material{};
      for (std::size_t i = 0; i < kAll.size(); ++i) {
        const Result<SparseVolume> made = combined(a, b, kAll[i]);
        RC_ASSERT(made.hasValue());
        material[i] = made->material();
        for (int z = -40; z < 40; z += 3)
          for (int y = -40; y < 40; y += 3)
            for (int x = -40; x < 40; ++x) {
              const VoxelIndex at(x, y, z);
              RC_ASSERT((made->sample(at) > 0) == decided(a.sample(at) > 0, b.sample(at) > 0, kAll[i]));
            }
        RC_ASSERT(isClosedManifold(surfaceOf(*made)));
      }
      RC_ASSERT(std::abs(material[0] + material[2] - a.material() - b.material()) < 1e-6);
      RC_ASSERT(std::abs(material[1] + material[2] - a.material()) < 1e-6);
    }));
  }

  // Boxes of meshes: the second sampled in the grid of the first, so that nothing is interpolated.
  void boxes() {
    const double voxel = 0.25;
    const TriangleSoup large = cube(12.0), small = cube(6.0, Vec3(8.1, 3.0, 3.05));
    const Result<SurfaceVolume> first = volumeOfSurface(large, voxel);
    const Result<SurfaceVolume> second = volumeOfSurface(small, voxel, {}, first->volume.origin());
    QVERIFY(first.hasValue() && second.hasValue());
    const Vec3 blocks = (second->volume.origin() - first->volume.origin()) / (8.0 * voxel);
    QVERIFY((blocks - Vec3(blocks.array().round())).norm() < 1e-9);
    const double shared = 3.9 * 6.0 * 6.0;
    const std::array exact{1728.0 + 216.0 - shared, 1728.0 - shared, shared};
    for (std::size_t i = 0; i < kAll.size(); ++i) {
      const TriangleSoup surface = surfaceOf(*combined(first->volume, second->volume, kAll[i]));
      QVERIFY(isClosedManifold(surface));
      QVERIFY(std::abs(enclosed(surface) / exact[i] - 1.0) < 0.02);
    }
  }

  // Blocks that are far from the other volume are not copied.
  void blocksAreShared() {
    const SparseVolume grid(Vec3::Zero(), 0.2);
    const SparseVolume a = withBall(grid, Vec3::Zero(), 4.0), b = withBall(grid, Vec3(6.0, 0.0, 0.0), 3.0);
    const Result<SparseVolume> both = combined(a, b, VolumeBoolean::Unite);
    std::size_t own = 0;
    for (const VoxelIndex& at : both->blocks()) {
      const SparseVolume::Block block = both->content(at).block;
      own += block != a.content(at).block && block != b.content(at).block;
    }
    QVERIFY(own < both->blockCount() / 4);
    const Result<SparseVolume> apart = combined(a, withBall(grid, Vec3(60.0, 0.0, 0.0), 3.0), VolumeBoolean::Subtract);
    for (const VoxelIndex& at : apart->blocks()) QVERIFY(apart->content(at) == a.content(at));
  }

  void nothingIsLeft() {
    const SparseVolume grid(Vec3::Zero(), 0.2);
    const SparseVolume ball = withBall(grid, Vec3::Zero(), 4.0);
    QVERIFY(combined(ball, ball, VolumeBoolean::Subtract)->isEmpty());
    QVERIFY(combined(grid, ball, VolumeBoolean::Intersect)->isEmpty());
    QVERIFY(combined(ball, grid, VolumeBoolean::Intersect)->isEmpty());
    QCOMPARE(combined(grid, ball, VolumeBoolean::Unite)->material(), ball.material());
    QCOMPARE(combined(ball, ball, VolumeBoolean::Unite)->material(), ball.material());
    QCOMPARE(combined(ball, grid, VolumeBoolean::Subtract)->blockCount(), ball.blockCount());
  }

  void whatCannotBe() {
    const SparseVolume ball = withBall(SparseVolume(Vec3::Zero(), 0.2), Vec3::Zero(), 4.0);
    const SparseVolume far = withBall(SparseVolume(Vec3(1e9, 0.0, 0.0), 0.2), Vec3(1e9, 0.0, 0.0), 4.0);
    QCOMPARE(combined(ball, far, VolumeBoolean::Unite).error().code, VolumeErrors::TooFine);
    // A coarse volume is resampled in voxels of a thousandth.
    const SparseVolume coarse = withBall(SparseVolume(Vec3::Zero(), 100.0), Vec3::Zero(), 3000.0);
    const SparseVolume fine = withBall(SparseVolume(Vec3::Zero(), 0.01), Vec3::Zero(), 0.5);
    QCOMPARE(combined(fine, coarse, VolumeBoolean::Unite).error().code, VolumeErrors::TooLarge);
    JobState job;
    job.cancelled = true;
    QCOMPARE(combined(ball, ball, VolumeBoolean::Unite, Progress(job)).error().code, ErrorCode::Cancelled);
  }
};

HANDWHEEL_TEST(VolumeBooleanTest)
#include "VolumeBooleanTest.moc"
