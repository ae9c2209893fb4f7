// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/VolumeRepair.h"

#include "ClosedSurface.h"
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"
#include "proximity/SelfIntersection.h"
#include "proximity/TriangleHierarchy.h"
#include "volume/SurfaceToVolume.h"

#include <rapidcheck.h>

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A ball with what scans have: holes, triangles that are turned or there twice, another ball half in it, one wholly in
// it, and vertices that are not joined.
TriangleSoup anyScan() {
  const auto number = [](int low, int high) { return *rc::gen::inRange(low, high); };
  TriangleSoup scan = moved(icosphere(2), Vec3::Zero(), 10.0);
  const int holes = number(0, 8);
  for (int i = 0; i < holes; ++i)
    scan.triangles.erase(scan.triangles.begin() + number(0, static_cast<int>(scan.triangles.size())));
  const int turned = number(0, 10);
  for (int i = 0; i < turned; ++i) {
    Triangle& t = scan.triangles[static_cast<std::size_t>(number(0, static_cast<int>(scan.triangles.size())))];
    std::swap(t[0], t[1]);
  }
  const int twice = number(0, 10);
  for (int i = 0; i < twice; ++i)
    scan.triangles.push_back(
        scan.triangles[static_cast<std::size_t>(number(0, static_cast<int>(scan.triangles.size())))]);
  if (number(0, 2) == 1) append(scan, moved(icosphere(2), Vec3(9.0, 0.0, 0.0), 4.0));
  if (number(0, 2) == 1) append(scan, moved(icosphere(2), Vec3(1.0, 0.0, 0.0), 4.0));
  if (number(0, 2) == 1) scan = unshared(scan);
  return scan;
}

}  // namespace

class VolumeRepairTest : public QObject {
  Q_OBJECT

 private slots:
  void anyScanBecomesSound() {
    int reduced = 0;
    QVERIFY(rc::check([&] {
      const TriangleSoup scan = anyScan();
      const Result<VolumeRepair> repair = repairByVolume(scan, {.voxel = 1.6});
      RC_ASSERT(repair.hasValue());
      const TriangleSoup after = repair->mesh.compact().soup;
      RC_ASSERT(isClosedManifold(after));
      RC_ASSERT(selfIntersections(after.points, after.triangles)->empty());
      // Between a triangle that is turned and what closes its hole, walls are thinner than a voxel and may go.
      RC_ASSERT(repair->keptDistance < 4.0);
      reduced += after.triangles.size() < repair->sampledTriangles;
      // A surface that is outside of the ball by more than what was taken away allows would be geometry nobody has.
      const TriangleHierarchy hierarchy(scan.points, scan.triangles);
      for (const Vec3& p : after.points) RC_ASSERT(std::sqrt(hierarchy.nearest(p)->squaredDistance) < 4.0);
    }));
    QVERIFY(reduced > 0);
  }

  // Bars that cross have fewer triangles than what they become needs: no shape is lost to reach their number.
  void crossingBars() {
    TriangleSoup bars;
    for (int axis = 0; axis < 3; ++axis) {
      TriangleSoup bar = cube(1.0, Vec3::Constant(-0.5));
      for (Vec3& p : bar.points) {
        for (int k = 0; k < 3; ++k) p[k] *= k == axis ? 20.0 : 4.0;
        p += 0.1 * Vec3(axis, axis + 1, axis + 2);
      }
      append(bars, bar);
    }
    const double voxel = 0.25;
    const Result<VolumeRepair> repair = repairByVolume(bars, {.voxel = voxel});
    QVERIFY(repair.hasValue());
    QVERIFY(repair->mesh.liveFaceCount() < repair->sampledTriangles);
    const TriangleSoup after = repair->mesh.compact().soup;
    QVERIFY(isClosedManifold(after));
    const TriangleHierarchy hierarchy(bars.points, bars.triangles);
    // Half a voxel across an edge that is cut off, and a voxel by the reduction.
    for (const Vec3& p : after.points) QVERIFY(std::sqrt(hierarchy.nearest(p)->squaredDistance) < 2.0 * voxel);
    // Corners of the bars are kept as well.
    const TriangleHierarchy found(after.points, after.triangles);
    for (const Vec3& p : bars.points) QVERIFY(std::sqrt(found.nearest(p)->squaredDistance) < 2.5 * voxel);
  }

  // A wall of a third of a voxel between the centres of voxels is gone, and that is said.
  void thinWalls() {
    TriangleSoup scan = cube(10.0);
    TriangleSoup wall = cube(1.0);
    for (Vec3& p : wall.points) p = Vec3(20.0 + 0.3 * p.x(), 10.0 * p.y(), 10.0 * p.z());
    append(scan, wall);
    const Result<VolumeRepair> repair = repairByVolume(scan, {.voxel = 1.0});
    QVERIFY(repair.hasValue());
    QVERIFY(repair->keptDistance > 5.0);
  }

  // A bowl is closed whichever side its faces look to; so is a ball that is inside out.
  void insideOut() {
    const TriangleSoup ball = moved(icosphere(3), Vec3::Zero(), 10.0);
    for (const double top : {100.0, 4.0}) {
      TriangleSoup bowl = ball;
      std::erase_if(bowl.triangles, [&](const Triangle& t) {
        return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return ball.points[v].z() > top; });
      });
      const Result<VolumeRepair> front = repairByVolume(bowl, {.voxel = 0.5});
      const Result<VolumeRepair> back = repairByVolume(turnedOver(bowl), {.voxel = 0.5});
      QVERIFY(front.hasValue() && back.hasValue());
      QVERIFY(front->keptDistance <= 0.5 && back->keptDistance <= 0.5);
      QVERIFY(isClosedManifold(back->mesh.compact().soup));
      QVERIFY(std::abs(volume(back->mesh.compact().soup) / volume(front->mesh.compact().soup) - 1.0) < 0.01);
    }
  }

  void withoutReduction() {
    const TriangleSoup ball = moved(icosphere(3), Vec3::Zero(), 10.0);
    const Result<VolumeRepair> repair = repairByVolume(ball, {.voxel = 0.5, .isReduced = false});
    QCOMPARE(repair->mesh.liveFaceCount(), repair->sampledTriangles);
    QVERIFY(repair->nearShare > 0.999);
  }

  void whatCannotBe() {
    QVERIFY(!repairByVolume({}, {.voxel = 0.5}).hasValue());
    QVERIFY(!repairByVolume(cube(), {.voxel = 0.0}).hasValue());
    JobState state;
    state.cancelled = true;
    QVERIFY(repairByVolume(cube(), {.voxel = 0.01}, Progress(state)).error().code == ErrorCode::Cancelled);
  }

  void usualVoxels() {
    QCOMPARE(usualVoxel(cube(256.0)), 1.0);
    QVERIFY(usualVoxel(TriangleSoup{}) > 0.0);
  }
};

HANDWHEEL_TEST(VolumeRepairTest)
#include "VolumeRepairTest.moc"
