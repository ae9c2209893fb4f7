// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/SparseVolume.h"

#include "TestClass.h"

#include <rapidcheck.h>

#include <QtTest>
#include <array>
#include <map>

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
