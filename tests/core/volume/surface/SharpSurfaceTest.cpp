// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/surface/SharpSurface.h"

#include "../SolidShapes.h"
#include "ClosedSurface.h"
#include "TestClass.h"
#include "proximity/SelfIntersection.h"
#include "proximity/TriangleHierarchy.h"
#include "volume/VolumeBoolean.h"
#include "volume/surface/VolumeToSurface.h"

#include <rapidcheck.h>

#include <QtTest>
#include <random>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Also as a file of single precision holds it.
bool isSound(const TriangleSoup& surface) {
  std::vector<Vec3> rounded = surface.points;
  for (Vec3& p : rounded) p = handwheel::rounded(p, NumberType::Float32);
  return isClosedManifold(surface) && selfIntersections(surface.points, surface.triangles)->empty() &&
         selfIntersections(rounded, surface.triangles)->empty();
}

// Returns the distances of points along the edges of a box from a surface, ascending.
std::vector<double> distancesOfEdges(const TriangleSoup& box, const TriangleSoup& surface) {
  const TriangleHierarchy found(surface.points, surface.triangles);
  std::vector<double> distances;
  for (std::size_t c = 0; c < 8; ++c)
    for (std::size_t k = 0; k < 3; ++k) {
      if (c >> k & 1) continue;
      for (int i = 0; i <= 200; ++i) {
        const Vec3 at = box.points[c] + i / 200.0 * (box.points[c | std::size_t{1} << k] - box.points[c]);
        distances.push_back(std::sqrt(found.nearest(at)->squaredDistance));
      }
    }
  std::sort(distances.begin(), distances.end());
  return distances;
}

double farthestFrom(const TriangleSoup& box, const TriangleSoup& surface) {
  const TriangleHierarchy known(box.points, box.triangles);
  double most = 0.0;
  for (const Vec3& p : surface.points) most = std::max(most, known.nearest(p)->squaredDistance);
  return std::sqrt(most);
}

}  // namespace

class SharpSurfaceTest : public QObject {
  Q_OBJECT

 private slots:
  // A box along the grid and in other directions: its edges and corners are there within a tenth of a voxel, where
  // marching cubes cut off a third of one.
  void boxes_data() {
    QTest::addColumn<double>("angle");
    for (const double angle : {0.0, 0.2, 0.5, 0.8}) QTest::addRow("%g", angle) << angle;
  }
  void boxes() {
    QFETCH(double, angle);
    const double voxel = 0.5;
    TriangleSoup box = cube(1.0);
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(angle, Vec3::UnitZ()) * Eigen::AngleAxisd(0.7 * angle, Vec3::UnitX())).toRotationMatrix();
    for (Vec3& p : box.points) p = turn * p.cwiseProduct(Vec3(10.0, 7.3, 5.1)) + Vec3(1.03, 2.01, 3.07);
    const SparseVolume volume = volumeOfSurface(box, voxel)->volume;
    const TriangleSoup marching = surfaceOf(volume), sharp = sharpSurfaceOf(volume);
    QVERIFY(isSound(sharp));
    const std::vector<double> before = distancesOfEdges(box, marching), after = distancesOfEdges(box, sharp);
    const auto near = std::upper_bound(after.begin(), after.end(), 0.1 * voxel) - after.begin();
    const double share = static_cast<double>(near) / static_cast<double>(after.size());
    qInfo("edges: %g voxels at most, %.3g %% within a tenth; marching cubes %g; points off by %g", after.back() / voxel,
          100.0 * share, before.back() / voxel, farthestFrom(box, sharp) / voxel);
    QVERIFY(before[before.size() / 2] > 0.25 * voxel);
    // Along the grid, all; else cells are left where an edge passes between their samples.
    QVERIFY(angle == 0.0 ? after.back() < 0.1 * voxel : share > 0.9);
    QVERIFY(farthestFrom(box, sharp) < 0.1 * voxel);
    QVERIFY(std::abs(enclosed(sharp) / enclosed(box) - 1.0) < 2e-3);
  }

  // A block with a step and a notch has concave edges, too; by booleans, whose depths keep them.
  void concaveEdges() {
    const double voxel = 0.4;
    SparseVolume part = boxOfVoxels(Vec3(10.0, 8.0, 6.0), Vec3(0.1, 0.2, 0.3), voxel);
    part = *combined(part, boxOfVoxels(Vec3(6.0, 9.0, 4.0), Vec3(5.13, -0.3, 3.05), voxel), VolumeBoolean::Subtract);
    const TriangleSoup sharp = sharpSurfaceOf(part);
    QVERIFY(isSound(sharp));
    const double exact = 480.0 - 4.97 * 8.0 * 3.25;
    QVERIFY2(std::abs(enclosed(sharp) / exact - 1.0) < 2e-3, qPrintable(QString::number(enclosed(sharp))));
    const TriangleHierarchy found(sharp.points, sharp.triangles);
    for (double y = 1.0; y < 7.5; y += 0.05)
      QVERIFY(std::sqrt(found.nearest(Vec3(5.13, y, 3.05))->squaredDistance) < 0.15 * voxel);
  }

  // A ball has no edges: nothing is changed.
  void aBallStays() {
    const SparseVolume ball = withBall(SparseVolume(Vec3::Zero(), 0.5), Vec3(0.1, 0.2, 0.3), 6.0);
    const TriangleSoup marching = surfaceOf(ball), sharp = sharpSurfaceOf(ball);
    QCOMPARE(sharp.points.size(), marching.points.size());
    QVERIFY(sharp.points == marching.points);
  }

  // The surface of any volume, also of random samples, is closed, manifold and free of self-intersections.
  void anyVolume() {
    std::mt19937 random(2);
    for (int round = 0; round < 8; ++round) {
      SparseVolume volume(Vec3(3.0, -2.0, 5.0), 0.3);
      for (int b = 0; b < 8; ++b) {
        auto block = std::make_shared<VolumeBlock>();
        for (std::int16_t& d : block->depths) {
          d = static_cast<std::int16_t>(std::uniform_int_distribution(1, 32767)(random));
          if (static_cast<int>(random() % 4) >= round % 3 + 1) d = static_cast<std::int16_t>(-d);
        }
        volume.setContent(VoxelIndex(b & 1, b >> 1 & 1, b >> 2), {block, false});
      }
      QVERIFY(isSound(sharpSurfaceOf(volume)));
    }
    QVERIFY(rc::check([&] {
      const auto number = [](int low, int high) { return 0.1 * *rc::gen::inRange(low, high); };
      SparseVolume part(Vec3::Zero(), 0.5);
      const int boxes = *rc::gen::inRange(1, 6);
      for (int i = 0; i < boxes; ++i) {
        const Vec3 size(number(15, 60), number(15, 60), number(15, 60)),
            at(number(0, 50), number(0, 50), number(0, 50));
        const Result<SurfaceVolume> box = volumeOfSurface(test::box(at, size), 0.5, {}, Vec3(Vec3::Zero()));
        RC_ASSERT(box.hasValue());
        part = *combined(part, box->volume, i % 3 == 2 ? VolumeBoolean::Subtract : VolumeBoolean::Unite);
      }
      if (!part.isEmpty()) RC_ASSERT(isSound(sharpSurfaceOf(part)));
    }));
  }

  void nothing() {
    QVERIFY(sharpSurfaceOf(SparseVolume(Vec3::Zero(), 1.0)).triangles.empty());
    JobState job;
    job.cancelled = true;
    QVERIFY(sharpSurfaceOf(boxOfVoxels(Vec3::Ones(), Vec3::Zero(), 0.1), Progress(job)).triangles.empty());
  }
};

HANDWHEEL_TEST(SharpSurfaceTest)
#include "SharpSurfaceTest.moc"
