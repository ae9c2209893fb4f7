// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeParts.h"

#include "ClosedSurface.h"
#include "TestClass.h"
#include "volume/ClayDab.h"
#include "volume/VolumeToSurface.h"

#include <rapidcheck.h>

#include <QtTest>
#include <map>

using namespace handwheel;
using namespace handwheel::test;

namespace {

SparseVolume balls(const std::vector<std::pair<Vec3, double>>& all, double voxel) {
  SparseVolume volume(Vec3::Zero(), voxel);
  for (const auto& [centre, radius] : all) {
    ClayDab dab;
    dab.action = ClayAction::Add;
    dab.centre = centre;
    dab.radius = radius;
    applyDab(volume, dab);
  }
  return volume;
}

// The parts by a search from voxel to voxel.
std::vector<std::size_t> searched(const SparseVolume& volume, int low, int high) {
  std::map<std::array<int, 3>, bool> inside;
  for (int z = low; z < high; ++z)
    for (int y = low; y < high; ++y)
      for (int x = low; x < high; ++x)
        if (volume.sample({x, y, z}) > 0) inside[{x, y, z}] = false;
  std::vector<std::size_t> sizes;
  for (auto& [first, wasSeen] : inside) {
    if (wasSeen) continue;
    wasSeen = true;
    std::vector<std::array<int, 3>> waiting{first};
    std::size_t size = 0;
    while (!waiting.empty()) {
      const auto at = waiting.back();
      waiting.pop_back();
      ++size;
      for (std::size_t k = 0; k < 6; ++k) {
        auto to = at;
        to[k / 2] += k % 2 != 0 ? 1 : -1;
        const auto found = inside.find(to);
        if (found == inside.end() || found->second) continue;
        found->second = true;
        waiting.push_back(to);
      }
    }
    sizes.push_back(size);
  }
  std::sort(sizes.rbegin(), sizes.rend());
  return sizes;
}

}  // namespace

class VolumePartsTest : public QObject {
  Q_OBJECT

 private slots:
  void likeASearch() {
    QVERIFY(rc::check([] {
      SparseVolume volume(Vec3::Zero(), 1.0);
      const int share = *rc::gen::inRange(1, 9);
      for (int i = 0; i < 8; ++i) {
        const VoxelIndex at(i & 1, i >> 1 & 1, i >> 2);
        const int what = *rc::gen::inRange(0, 4);
        if (what == 0) continue;
        if (what == 1) {
          volume.setContent(at - VoxelIndex::Ones(), {nullptr, true});
          continue;
        }
        auto block = std::make_shared<VolumeBlock>();
        for (auto& depth : block->depths)
          depth = *rc::gen::inRange(0, 10) < share ? std::int16_t{4000} : std::int16_t{-4000};
        volume.setContent(at - VoxelIndex::Ones(), {std::move(block), false});
      }
      RC_ASSERT(partsOf(volume).voxels == searched(volume, -8, 8));
    }));
  }

  // The large ones stay where they are to the last sample, also those that are inside others.
  void theLargestStay() {
    const std::vector<std::pair<Vec3, double>> kept{{Vec3(-9, 0, 0), 5.0}, {Vec3(9, 1, 2), 4.0}};
    auto all = kept;
    all.emplace_back(Vec3(0.3, 0.1, -7.0), 2.0);
    all.emplace_back(Vec3(0.0, 9.0, 0.0), 1.0);
    SparseVolume volume = balls(all, 0.2);
    const SparseVolume expected = balls(kept, 0.2);
    const VolumeParts parts = keepLargest(volume, 2);
    QCOMPARE(parts.voxels.size(), std::size_t{4});
    QVERIFY(std::is_sorted(parts.voxels.rbegin(), parts.voxels.rend()));
    QCOMPARE(volume.material(), expected.material());
    QCOMPARE(partsOf(volume).voxels.size(), std::size_t{2});
    const TriangleSoup surface = surfaceOf(volume), wanted = surfaceOf(expected);
    QVERIFY(isClosedManifold(surface));
    QCOMPARE(surface.points, wanted.points);
    QCOMPARE(surface.triangles, wanted.triangles);
  }

  // A part beside a kept one, across an edge of voxels: nothing of it stays.
  void neighbours() {
    SparseVolume volume = balls({{Vec3::Zero(), 3.0}, {Vec3(4.3, 0.0, 0.0), 1.0}}, 0.1);
    const double ball = balls({{Vec3::Zero(), 3.0}}, 0.1).material();
    keepLargest(volume, 1);
    QCOMPARE(volume.material(), ball);
    QCOMPARE(partsOf(volume).voxels.size(), std::size_t{1});
  }

  void none() {
    SparseVolume volume(Vec3::Zero(), 1.0);
    QVERIFY(partsOf(volume).voxels.empty());
    QVERIFY(keepLargest(volume, 3).voxels.empty());
    volume = balls({{Vec3::Zero(), 3.0}}, 0.2);
    keepLargest(volume, 0);
    QVERIFY(volume.isEmpty());
  }
};

HANDWHEEL_TEST(VolumePartsTest)
#include "VolumePartsTest.moc"
