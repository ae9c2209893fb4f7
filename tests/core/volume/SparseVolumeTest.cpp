// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/SparseVolume.h"

#include "TestClass.h"
#include "volume/VolumeFilters.h"
#include "volume/VolumeShapes.h"

#include <rapidcheck.h>

#include <QtTest>
#include <array>
#include <cmath>
#include <map>
#include <memory>

using namespace handwheel;

namespace {

VoxelIndex anyBlock() {
  const auto any = [] { return *rc::gen::element(-100000, -9, -8, -1, 0, 1, 7, 8, 63, 64, 100000); };
  const int x = any(), y = any(), z = any();
  return {x, y, z};
}

SparseVolume::Content anyContent() {
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      return {};
    case 1:
      return {nullptr, true};
    default: {
      auto block = std::make_shared<VolumeBlock>();
      for (std::int16_t& d : block->depths) d = depthSample(*rc::gen::inRange(-5000, 5000) / 1000.0);
      return {block, false};
    }
  }
}

// A box from its corner, with true distances also outside of its edges.
SparseVolume boxByFormula(const Vec3& corner, const Vec3& sizes, double voxel) {
  SparseVolume made(Vec3::Zero(), voxel);
  const auto depthAt = [&](const Vec3& p) {
    const Vec3 beyond = (p - corner - 0.5 * sizes).cwiseAbs() - 0.5 * sizes;
    const double outside = beyond.cwiseMax(0.0).norm();
    return outside > 0.0 ? -outside : -beyond.maxCoeff();
  };
  const auto blockAt = [&](const Vec3& p) {
    return SparseVolume::blockOf((p / voxel).array().floor().cast<int>().matrix());
  };
  const VoxelIndex low = blockAt(corner) - VoxelIndex::Ones(), high = blockAt(corner + sizes) + VoxelIndex::Ones();
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x) {
        auto samples = std::make_shared<VolumeBlock>();
        for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
          const VoxelIndex at = 8 * VoxelIndex(x, y, z) + VoxelIndex(i & 7, i >> 3 & 7, i >> 6);
          samples->depths[static_cast<std::size_t>(i)] = depthSample(depthAt(made.centre(at)) / voxel);
        }
        made.setContent({x, y, z}, contentOf(std::move(samples)));
      }
  return made;
}

}  // namespace

class SparseVolumeTest : public QObject {
  Q_OBJECT

 private slots:
  void samplesAreNeverZero() {
    QVERIFY(depthSample(0.0) > 0);
    QVERIFY(depthSample(-1e-9) < 0);
    QCOMPARE(depthSample(1.0), std::int16_t(8192));
    QCOMPARE(depthSample(100.0), VolumeBlock::kFull);
    QCOMPARE(depthSample(-100.0), VolumeBlock::kEmpty);
  }

  // Sums of what clamps between half a voxel outside and inside are exact along the axes. In the square of a voxel
  // around an edge they are too large by up to a quarter of a voxel, and too small by less than a thirtieth.
  void enclosedByABox() {
    const Vec3 sizes(12.3, 7.7, 20.1);
    const double edges = 4.0 * sizes.sum();
    for (const double voxel : {0.25, 0.4, 0.5})
      for (const Vec3& corner : {Vec3(0.0, 0.0, 0.0), Vec3(0.11, -3.17, 5.03), Vec3(-6.2, 0.2, 0.37)}) {
        const double off = boxByFormula(corner, sizes, voxel).enclosed() - sizes.prod();
        const double corners = 8.0 * voxel * voxel * voxel;
        // Depths are rounded to 8192ths.
        const double rounding = 1e-4 * voxel * 2.0 * (sizes.x() * (sizes.y() + sizes.z()) + sizes.y() * sizes.z());
        QVERIFY2(off < 0.25 * voxel * voxel * edges + corners + rounding, qPrintable(QString::number(off)));
        QVERIFY2(off > -0.034 * voxel * voxel * edges - corners - rounding, qPrintable(QString::number(off)));
      }
  }

  // The mean of the balls with radii of up to half a voxel more and less is too large by a quarter of (h / r)². The
  // lattice adds as much at most: its waves, R / (π k²) each, are damped by that mean to a sixth of (h / r)².
  void enclosedByABall() {
    const double radius = 20.0, exact = 4.0 / 3.0 * M_PI * 8000.0;
    for (const double voxel : {0.3, 0.5}) {
      SparseVolume ball = ballOfVoxels(radius, voxel);
      const double enclosed = ball.enclosed();
      const double square = voxel * voxel / (radius * radius);
      QVERIFY2(std::abs(enclosed / exact - 1.0) < 0.5 * square + 1e-5, qPrintable(QString::number(enclosed / exact)));
      // Kept while blocks come and go: to the last bit what is counted anew.
      const SparseVolume whole = ball;
      SparseVolume anew(ball.origin(), voxel);
      whole.forEach([&](const VoxelIndex& at, const SparseVolume::Content& content) {
        anew.setContent(at, content);
        ball.setContent(at, {});
      });
      QCOMPARE(anew.enclosed(), enclosed);
      QCOMPARE(ball.enclosed(), 0.0);
      QCOMPARE(whole.enclosed(), enclosed);
      QCOMPARE(whole.material(), anew.material());
    }
  }

  // It holds what a map of blocks would hold, and a copy keeps what it had.
  void likeAMap() {
    QVERIFY(rc::check([] {
      SparseVolume volume(Vec3(1.0, 2.0, 3.0), 0.5);
      std::map<std::array<int, 3>, SparseVolume::Content> expected;
      const auto key = [](const VoxelIndex& b) { return std::array<int, 3>{b.x(), b.y(), b.z()}; };
      const auto isSame = [&](const SparseVolume& v, const auto& content) {
        std::size_t samples = 0;
        for (const auto& [at, c] : content) {
          RC_ASSERT(v.content(VoxelIndex(at[0], at[1], at[2])) == c);
          samples += c.block != nullptr;
        }
        RC_ASSERT(v.blockCount() == samples);
        RC_ASSERT(v.blocks().size() == samples);
      };
      const int count = *rc::gen::inRange(1, 30);
      for (int i = 0; i < count; ++i) {
        const SparseVolume before = volume;
        const auto expectedBefore = expected;
        const VoxelIndex at = anyBlock();
        const SparseVolume::Content content = anyContent();
        volume.setContent(at, content);
        expected[key(at)] = content;
        isSame(volume, expected);
        isSame(before, expectedBefore);
        const VoxelIndex voxel = 8 * at + VoxelIndex(3, 0, 7);
        const std::int16_t sample = content.block    ? content.block->depths[VolumeBlock::at(3, 0, 7)]
                                    : content.isFull ? VolumeBlock::kFull
                                                     : VolumeBlock::kEmpty;
        RC_ASSERT(volume.sample(voxel) == sample);
      }
      for (const auto& [at, content] : expected) volume.setContent(VoxelIndex(at[0], at[1], at[2]), {});
      RC_ASSERT(volume.isEmpty());
    }));
  }
};

HANDWHEEL_TEST(SparseVolumeTest)
#include "SparseVolumeTest.moc"
