// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/surface/VolumeToSurface.h"

#include "ClosedSurface.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "proximity/SelfIntersection.h"
#include "proximity/TriangleHierarchy.h"
#include "volume/SurfaceToVolume.h"
#include "volume/surface/MarchingCubesTable.h"

#include <rapidcheck.h>

#include <QtTest>
#include <map>
#include <random>

using namespace handwheel;
using namespace handwheel::test;

class VolumeToSurfaceTest : public QObject {
  Q_OBJECT

 private slots:
  // Each case has a triangle at each edge that is crossed, and at no other.
  void theTableIsWhole() {
    const MarchingCubesTable& table = MarchingCubesTable::table();
    for (unsigned inside = 0; inside < 256; ++inside) {
      std::map<int, int> passed;  // corners of triangles by edge
      std::map<std::pair<int, int>, int> sides;
      for (const MarchingCubesTable::EdgeTriangle& t : table.triangles[inside])
        for (std::size_t k = 0; k < 3; ++k) {
          ++passed[t[k]];
          ++sides[{t[k], t[(k + 1) % 3]}];
        }
      for (int e = 0; e < 12; ++e) {
        const auto corners = cornersOfCellEdge(e);
        const bool isCrossed = (inside >> corners[0] & 1) != (inside >> corners[1] & 1);
        QCOMPARE(passed.contains(e), isCrossed);
      }
      // Within the cell no side occurs twice in the same direction.
      for (const auto& [side, times] : sides) QCOMPARE(times, 1);
    }
  }

  // Every case of the table beside every other: samples at random, also such that points are next to each other.
  void anySamples() {
    std::mt19937 random(1);
    for (int round = 0; round < 40; ++round) {
      SparseVolume volume(Vec3(3.0, -2.0, 5.0), 0.3);
      const bool isExtreme = round % 4 == 3;
      for (int b = 0; b < 8; ++b) {
        auto block = std::make_shared<VolumeBlock>();
        for (std::size_t i = 0; i < VolumeBlock::kCount; ++i) {
          std::int16_t& d = block->depths[i];
          d = static_cast<std::int16_t>(std::uniform_int_distribution(1, 32767)(random));
          if (isExtreme) d = random() % 2 == 0 ? 1 : 32767;
          const int share = round % 3 + 1;  // a quarter to three quarters of them inside
          if (static_cast<int>(random() % 4) >= share) d = static_cast<std::int16_t>(-d);
        }
        volume.setContent(VoxelIndex(b & 1, b >> 1 & 1, b >> 2), {block, false});
      }
      const TriangleSoup surface = surfaceOf(volume);
      QVERIFY(surface.triangles.size() > 1000);
      QVERIFY(isClosedManifold(surface));
      QCOMPARE(selfIntersections(surface.points, surface.triangles)->size(), std::size_t{0});
      QVERIFY(enclosed(surface) > 0.0);
    }
  }

  // A ball comes back within a fraction of a voxel, with its volume.
  void aBallComesBack() {
    const TriangleSoup ball = moved(icosphere(4), Vec3(1.0, 2.0, 3.0), 10.0);
    const double voxel = 0.4;
    const Result<SurfaceVolume> made = volumeOfSurface(ball, voxel);
    const TriangleSoup surface = surfaceOf(made->volume);
    QVERIFY(isClosedManifold(surface));
    QVERIFY(selfIntersections(surface.points, surface.triangles)->empty());
    const TriangleHierarchy hierarchy(ball.points, ball.triangles);
    for (const Vec3& p : surface.points) QVERIFY(std::sqrt(hierarchy.nearest(p)->squaredDistance) < 0.03 * voxel);
    QVERIFY(std::abs(enclosed(surface) / enclosed(ball) - 1.0) < 2e-3);
    // Euler's formula for a sphere: V - E + F = 2, E = 3/2 F.
    QCOMPARE(static_cast<long>(surface.points.size()) - static_cast<long>(surface.triangles.size() / 2), 2L);
  }

  // A cube whose faces are on voxel centres, and one half a voxel beside them.
  void aCubeComesBack() {
    for (const double size : {8.0, 8.25}) {
      const TriangleSoup block = cube(size, Vec3(1.0, 2.0, 3.0));
      const TriangleSoup surface = surfaceOf(volumeOfSurface(block, 0.5)->volume);
      QVERIFY(isClosedManifold(surface));
      QVERIFY(selfIntersections(surface.points, surface.triangles)->empty());
      // Edges and corners are cut by less than half a voxel.
      QVERIFY(std::abs(enclosed(surface) / (size * size * size) - 1.0) < 0.02);
    }
  }

  void nothing() {
    QVERIFY(surfaceOf(SparseVolume(Vec3::Zero(), 1.0)).triangles.empty());
    JobState state;
    state.cancelled = true;
    QVERIFY(surfaceOf(volumeOfSurface(icosphere(2), 0.1)->volume, Progress(state)).triangles.empty());
  }

  void oneVoxel() {
    SparseVolume volume(Vec3::Zero(), 1.0);
    auto block = std::make_shared<VolumeBlock>();
    block->depths.fill(VolumeBlock::kEmpty);
    block->depths[0] = VolumeBlock::kFull;
    volume.setContent(VoxelIndex(0, 0, 0), {block, false});
    const TriangleSoup surface = surfaceOf(volume);
    QCOMPARE(surface.triangles.size(), std::size_t{8});  // an octahedron
    QVERIFY(isClosedManifold(surface));
  }
};

HANDWHEEL_TEST(VolumeToSurfaceTest)
#include "VolumeToSurfaceTest.moc"
