// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeSurface.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Result.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeToSurface.h"

#include <QtTest>
#include <algorithm>
#include <random>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using Corners = std::array<std::array<double, 3>, 3>;

// The triangles by their corners, from the lowest corner on, sorted.
std::vector<Corners> sorted(const TriangleSoup& soup) {
  std::vector<Corners> all;
  for (const Triangle& t : soup.triangles) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = {soup.points[t[k]].x(), soup.points[t[k]].y(), soup.points[t[k]].z()};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<Corners> sorted(const VolumeSurface& surface) {
  TriangleSoup all;
  for (const auto& [key, piece] : surface.pieces()) append(all, *piece);
  return sorted(all);
}

}  // namespace

class VolumeSurfaceTest : public QObject {
  Q_OBJECT

 private slots:
  // The pieces together are the whole surface, also after blocks changed, and pieces that have nothing to do with the
  // change are the same objects.
  void piecesAreTheWhole() {
    SparseVolume volume = volumeOfSurface(moved(icosphere(3), Vec3::Zero(), 10.0), 0.13)->volume;
    VolumeSurface surface(volume);
    QVERIFY(surface.pieces().size() > 8);
    QCOMPARE(sorted(surface), sorted(surfaceOf(volume)));
    QCOMPARE(surface.triangleCount(), surfaceOf(volume).triangles.size());
    for (const auto& [key, piece] : surface.pieces()) QVERIFY(piece->triangles.size() < 64'000);

    std::mt19937 random(7);
    const std::vector<VoxelIndex> blocks = volume.blocks();
    for (int round = 0; round < 4; ++round) {
      const VoxelIndex at = blocks[random() % blocks.size()];
      auto block = std::make_shared<VolumeBlock>();
      for (std::int16_t& d : block->depths) d = random() % 2 == 0 ? std::int16_t{100} : std::int16_t{-100};
      const VolumeSurface before = surface;
      volume.setContent(at, {block, false});
      surface.update(volume, std::array{at});
      QCOMPARE(sorted(surface), sorted(surfaceOf(volume)));
      std::size_t same = 0;
      for (const auto& [key, piece] : surface.pieces())
        same += before.pieces().contains(key) && before.pieces().at(key) == piece;
      QVERIFY(same + 8 >= surface.pieces().size());
    }
  }

  void takenAwayWhole() {
    SparseVolume volume = volumeOfSurface(cube(10.0), 0.5)->volume;
    VolumeSurface surface(volume);
    const std::vector<VoxelIndex> blocks = volume.blocks();
    std::vector<VoxelIndex> all;
    for (int i = 0; i < 512; ++i) all.push_back(VoxelIndex(i & 7, i >> 3 & 7, i >> 6));
    for (const VoxelIndex& at : all) volume.setContent(at, {});
    surface.update(volume, all);
    QVERIFY(surface.pieces().empty());
    QVERIFY(volume.isEmpty());
  }
};

HANDWHEEL_TEST(VolumeSurfaceTest)
#include "VolumeSurfaceTest.moc"
