// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeParts.h"

#include "ClosedSurface.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeShapes.h"
#include "volume/surface/VolumeToSurface.h"

#include <rapidcheck.h>

#include <QtTest>
#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using Voxel = std::array<int, 3>;

// Blocks of noise, some of them full or empty, around the origin.
SparseVolume noise(std::mt19937& random, int density) {
  SparseVolume volume(Vec3::Zero(), 1.0);
  for (int z = -1; z < 2; ++z)
    for (int y = -1; y < 2; ++y)
      for (int x = -1; x < 2; ++x) {
        const unsigned kind = random() % 8;
        if (kind == 0) continue;
        if (kind == 1) {
          volume.setContent(VoxelIndex(x, y, z), {nullptr, true});
          continue;
        }
        auto block = std::make_shared<VolumeBlock>();
        for (std::int16_t& depth : block->depths)
          depth = static_cast<int>(random() % 100) < density ? std::int16_t{2000} : std::int16_t{-2000};
        volume.setContent(VoxelIndex(x, y, z), {std::move(block), false});
      }
  return volume;
}

// The parts by a search from voxel to voxel, each as its set of voxels; the largest first.
std::vector<std::set<Voxel>> searched(const SparseVolume& volume) {
  std::set<Voxel> left;
  for (int z = -8; z < 16; ++z)
    for (int y = -8; y < 16; ++y)
      for (int x = -8; x < 16; ++x)
        if (volume.sample({x, y, z}) > 0) left.insert({x, y, z});
  std::vector<std::set<Voxel>> parts;
  while (!left.empty()) {
    std::vector<Voxel> open{*left.begin()};
    left.erase(left.begin());
    std::set<Voxel> part;
    while (!open.empty()) {
      const Voxel at = open.back();
      open.pop_back();
      part.insert(at);
      for (std::size_t k = 0; k < 3; ++k)
        for (const int step : {-1, 1}) {
          Voxel next = at;
          next[k] += step;
          if (left.erase(next) > 0) open.push_back(next);
        }
    }
    parts.push_back(std::move(part));
  }
  std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return parts;
}

TriangleSoup joined(TriangleSoup a, const TriangleSoup& b) {
  const auto first = static_cast<std::uint32_t>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  return a;
}

}  // namespace

class VolumePartsTest : public QObject {
  Q_OBJECT

 private slots:
  // The same parts as a search over all voxels finds, in any noise; and exactly the voxels of those that are kept.
  void asASearchFinds() {
    QVERIFY(rc::check([] {
      std::mt19937 random(*rc::gen::arbitrary<unsigned>());
      const SparseVolume volume = noise(random, *rc::gen::inRange(2, 60));
      const auto expected = searched(volume);
      const VolumeParts parts(volume);
      std::vector<std::uint64_t> sizes;
      for (const auto& part : expected) sizes.push_back(part.size());
      RC_ASSERT(parts.voxels() == sizes);
      const std::uint64_t limit = *rc::gen::inRange<std::uint64_t>(0, 30);
      const std::size_t kept = parts.countFrom(limit);
      RC_ASSERT(kept == static_cast<std::size_t>(
                            std::count_if(sizes.begin(), sizes.end(), [&](std::uint64_t n) { return n >= limit; })));
      const SparseVolume after = parts.only(0, kept), gone = parts.only(kept, sizes.size());
      std::map<Voxel, bool> isKept;
      for (const auto& part : expected)
        for (const Voxel& at : part) isKept[at] = part.size() >= limit;
      for (int z = -9; z < 17; ++z)
        for (int y = -9; y < 17; ++y)
          for (int x = -9; x < 17; ++x) {
            const auto found = isKept.find({x, y, z});
            const bool isIn = found != isKept.end();
            RC_ASSERT((after.sample({x, y, z}) > 0) == (isIn && found->second));
            RC_ASSERT((gone.sample({x, y, z}) > 0) == (isIn && !found->second));
          }
    }));
  }

  // Balls beside each other: what is left of the smaller ones is nothing, also no depths; the large one is as it was.
  void debris() {
    const TriangleSoup large = moved(icosphere(3), Vec3::Zero(), 10.0);
    TriangleSoup all = joined(large, moved(icosphere(2), Vec3(14, 0, 0), 2.0));
    all = joined(all, moved(icosphere(2), Vec3(0, -15, 1), 1.0));
    const SparseVolume volume = volumeOfSurface(all, 0.25)->volume;
    const VolumeParts parts(volume);
    QCOMPARE(parts.voxels().size(), std::size_t{3});
    const std::uint64_t total = std::accumulate(parts.voxels().begin(), parts.voxels().end(), std::uint64_t{0});
    QVERIFY(std::abs(static_cast<double>(total) * 0.25 * 0.25 * 0.25 - volume.material()) < 1e-6 * volume.material());
    QVERIFY(std::abs(static_cast<double>(parts.voxels()[1]) / static_cast<double>(parts.voxels()[2]) - 8.0) < 0.5);
    const SparseVolume kept = parts.only(0, 1);
    const TriangleSoup surface = surfaceOf(kept), whole = surfaceOf(volume);
    QVERIFY(isClosedManifold(surface));
    QVERIFY(surface.triangles.size() < whole.triangles.size());
    // All its points are points of the surface before.
    std::set<std::array<double, 3>> before;
    for (const Vec3& p : whole.points) before.insert({p.x(), p.y(), p.z()});
    for (const Vec3& p : surface.points) QVERIFY(before.contains({p.x(), p.y(), p.z()}));
    for (const VoxelIndex& at : kept.blocks()) QVERIFY(kept.centre(8 * at).norm() < 10.0 + 3 * 8 * 0.25);
  }

  void nothing() {
    const VolumeParts none{SparseVolume(Vec3::Zero(), 1.0)};
    QVERIFY(none.voxels().empty());
    QVERIFY(none.only(0, 1).isEmpty());
    const VolumeParts ball(ballOfVoxels(3.0, 0.5));
    QCOMPARE(ball.voxels().size(), std::size_t{1});
    QVERIFY(ball.only(0, 0).isEmpty());
  }
};

HANDWHEEL_TEST(VolumePartsTest)
#include "VolumePartsTest.moc"
