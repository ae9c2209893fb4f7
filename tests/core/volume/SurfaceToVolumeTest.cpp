// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/SurfaceToVolume.h"

#include "MeshShapes.h"
#include "SolidAngles.h"
#include "TestClass.h"
#include "proximity/TriangleHierarchy.h"
#include "volume/SurfaceDensity.h"
#include "volume/VolumeErrors.h"

#include <rapidcheck.h>

#include <QtTest>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Each sample of a volume against the distance by the hierarchy and the side by the solid angles, for some voxels.
void compare(const SparseVolume& volume, const TriangleSoup& soup, int step) {
  const TriangleHierarchy hierarchy(soup.points, soup.triangles);
  const VoxelIndex size = (hierarchy.bounds().sizes() / volume.voxel()).array().ceil().cast<int>() + 8;
  for (int z = 0; z < size.z(); z += step)
    for (int y = 0; y < size.y(); y += step)
      for (int x = 0; x < size.x(); x += step) {
        const VoxelIndex at(x, y, z);
        const Vec3 p = volume.centre(at);
        const double distance = std::sqrt(hierarchy.nearest(p)->squaredDistance) / volume.voxel();
        const double depth = volume.sample(at) / VolumeBlock::kUnit;
        if (distance > 1e-4) QCOMPARE(depth > 0.0, windingNumber(soup, p) > 0.5);
        if (distance < 2.99) {
          QVERIFY(std::abs(std::abs(depth) - distance) < 2e-4);
        } else {
          QVERIFY(std::abs(depth) > 2.98);
        }
      }
}

// A box with a corner at (x, 0, 0).
TriangleSoup slab(double x, double thickness, double across) {
  TriangleSoup made = cube(1.0);
  for (Vec3& p : made.points) p = Vec3(x + thickness * p.x(), across * p.y(), across * p.z());
  return made;
}

}  // namespace

class SurfaceToVolumeTest : public QObject {
  Q_OBJECT

 private slots:
  void aBall() {
    const TriangleSoup ball = moved(icosphere(3), Vec3(7.1, -3.3, 100.7), 10.0);
    const Result<SurfaceVolume> made = volumeOfSurface(ball, 0.37);
    QVERIFY(made.hasValue());
    QCOMPARE(made->closedBoundaries, std::size_t{0});
    compare(made->volume, ball, 3);
    const double expected = 4.0 / 3.0 * M_PI * 1000.0;
    QVERIFY(std::abs(made->volume.material() / expected - 1.0) <
            0.015);  // 1,280 flat faces take more than 1 % off a ball
    QVERIFY(std::abs(made->volume.material() / made->expected - 1.0) < 3e-3);
    QVERIFY(made->nearShare > 0.999);
  }

  // Faces along voxel planes, and exactly on voxel centres.
  void aCube() {
    const TriangleSoup block = cube(8.0, Vec3(1.0, 2.0, 3.0));
    const Result<SurfaceVolume> made = volumeOfSurface(unshared(block), 0.5);
    QVERIFY(made.hasValue());
    compare(made->volume, block, 1);
  }

  // A hole with a flat edge is closed by a flat lid: a box without one of its sides is the box.
  void aHoleIsClosed() {
    const TriangleSoup box = cube(10.0, Vec3(0.3, 0.2, 0.1));
    TriangleSoup open = box;
    std::erase_if(open.triangles, [&](const Triangle& t) {
      return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return box.points[v].z() > 10.0; });
    });
    QCOMPARE(open.triangles.size(), std::size_t{10});
    const Result<SurfaceVolume> made = volumeOfSurface(open, 0.25);
    QVERIFY(made.hasValue());
    QCOMPARE(made->closedBoundaries, std::size_t{1});
    compare(made->volume, box, 2);
  }

  // Holes that are no plane: inside is where the solid angles of what is left are more than a half turn, so nothing
  // sticks out in the middle. The edge of the hole goes up and down; or the gap between two halves does.
  void bentHoles_data() {
    QTest::addColumn<double>("below");
    QTest::addColumn<double>("above");
    QTest::newRow("hole") << -100.0 << 4.0;
    QTest::newRow("most of it") << -100.0 << -5.0;
    QTest::newRow("a band") << -5.0 << 5.0;
    QTest::newRow("gap") << 1.0 << -1.0;
  }
  void bentHoles() {
    QFETCH(double, below);
    QFETCH(double, above);
    TriangleSoup open = moved(icosphere(3), Vec3(0.1, 0.2, 0.3), 10.0);
    const auto height = [&](const Triangle& t) {
      const Vec3 p = (open.points[t[0]] + open.points[t[1]] + open.points[t[2]]) / 3.0;
      return p.z() + 3.0 * std::cos(2.0 * std::atan2(p.y(), p.x()));
    };
    std::erase_if(open.triangles, [&](const Triangle& t) {
      return below > above ? height(t) > above && height(t) < below : height(t) < below || height(t) > above;
    });
    const double voxel = 0.46;
    const Result<SurfaceVolume> made = volumeOfSurface(open, voxel);
    QVERIFY(made.hasValue());
    QVERIFY(made->nearShare > 0.99);
    const TriangleHierarchy hierarchy(open.points, open.triangles);
    int inside = 0;
    for (int i = 0; i < 17 * 17 * 17; ++i) {
      const VoxelIndex at = 3 * VoxelIndex(i % 17, i / 17 % 17, i / 289);
      const Vec3 p = made->volume.centre(at);
      const double turns = windingNumber(open, p);
      const double depth = made->volume.sample(at) / VolumeBlock::kUnit;
      if (std::abs(turns - 0.5) > 2e-3) QCOMPARE(depth > 0.0, turns > 0.5);
      // The lid is at most as far as the surface.
      const double distance = std::sqrt(hierarchy.nearest(p)->squaredDistance) / voxel;
      if (distance < 2.99) QVERIFY(std::abs(depth) < distance + 2e-4);
      inside += depth > 0.0;
    }
    QVERIFY(inside > 50);
  }

  // A triangle that is turned round counts as one that is missing, and one that is there twice is there once.
  void faultyTriangles() {
    const TriangleSoup ball = moved(icosphere(2), Vec3::Zero(), 10.0);
    for (const bool isTwice : {false, true}) {
      TriangleSoup faulty = ball;
      Triangle& t = faulty.triangles[17];
      if (isTwice) {
        faulty.triangles.push_back(t);
      } else {
        std::swap(t[0], t[1]);
      }
      const Result<SurfaceVolume> made = volumeOfSurface(faulty, 0.4);
      QVERIFY(made.hasValue());
      compare(made->volume, ball, 3);
    }
  }

  // Overlapping bodies become one: no wall is left inside.
  void overlapsBecomeOne() {
    TriangleSoup balls = moved(icosphere(3), Vec3::Zero(), 10.0);
    append(balls, moved(icosphere(3), Vec3(12.0, 0.0, 0.0), 10.0));
    const Result<SurfaceVolume> made = volumeOfSurface(balls, 0.5);
    QVERIFY(made.hasValue());
    const VoxelIndex middle = ((Vec3(6.0, 0.0, 0.0) - made->volume.origin()) / 0.5).array().round().cast<int>();
    for (int x = -14; x <= 14; ++x) QVERIFY(made->volume.sample(middle + VoxelIndex(x, 0, 0)) > 2 * 8192);
    // Two caps of the lens of two spheres of radius r whose centres are d apart: π (4r + d)(2r - d)² / 12.
    const double r = 10.0, d = 12.0;
    const double lens = M_PI * (4.0 * r + d) * (2.0 * r - d) * (2.0 * r - d) / 12.0;
    const double expected = 2.0 * 4.0 / 3.0 * M_PI * r * r * r - lens;
    QVERIFY(std::abs(made->volume.material() / expected - 1.0) < 0.02);
  }

  void whatHasNoInside() {
    QVERIFY(volumeOfSurface(turnedOver(moved(icosphere(2), Vec3::Zero(), 5.0)), 0.5).error().code ==
            VolumeErrors::NothingInside);
    TriangleSoup flat{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()}, {{0, 1, 2}}};
    QVERIFY(volumeOfSurface(flat, 0.1).error().code == VolumeErrors::NothingInside);
    QVERIFY(!volumeOfSurface({}, 0.1).hasValue());
    QVERIFY(!volumeOfSurface(cube(), 0.0).hasValue());
    QVERIFY(!volumeOfSurface(cube(), std::nan("")).hasValue());
    QVERIFY(volumeOfSurface(cube(), 1e-9).error().code == VolumeErrors::TooFine);
    QVERIFY(volumeOfSurface(cube(), 2e-6).error().code == VolumeErrors::TooLarge);
    QVERIFY(volumeOfSurface(cube(1.0, Vec3::Constant(0.1)), 30.0).error().code == VolumeErrors::NoVoxelInside);
    // Two small cubes far apart would need an index of all rows between them.
    TriangleSoup apart = cube();
    append(apart, cube(1.0, Vec3::Constant(1e5)));
    QVERIFY(volumeOfSurface(apart, 0.25).error().code == VolumeErrors::TooLarge);
    TriangleSoup broken = cube();
    broken.points[3].x() = std::numeric_limits<double>::infinity();
    QVERIFY(!volumeOfSurface(broken, 0.1).hasValue());
  }

  // Samples lie at halves of a mm, and so none is in a plate from 20 to 20.3 mm. Beside a cube with 600 mm² it has
  // 2 a² + 1.2 a mm²: of 15 mm it is 44 % of the surface, of 20 mm 58 %. The share that is left is said in any case.
  void surfaceThatIsLost() {
    TriangleSoup some = cube(10.0), most = cube(10.0);
    append(some, slab(20.0, 0.3, 15.0));
    append(most, slab(20.0, 0.3, 20.0));
    for (const VoxelMethod method : {VoxelMethod::Sign, VoxelMethod::Density}) {
      const Result<SurfaceVolume> made = volumeOfSurface(some, 1.0, method, {});
      QVERIFY(made.hasValue());
      // Rays meet a triangle the more often the less it lies along them.
      QVERIFY2(std::abs(made->nearShare - 0.56) < (method == VoxelMethod::Sign ? 0.01 : 0.05),
               qPrintable(QString::number(made->nearShare)));
      const Error error = volumeOfSurface(most, 1.0, method, {}).error();
      QVERIFY(error.code == VolumeErrors::SurfaceIsLost);
      QCOMPARE(error.arguments.size(), std::size_t{3});
      QCOMPARE(error.arguments[2], std::string("50"));
    }
    // Smaller voxels keep the plate.
    const Result<SurfaceVolume> fine = volumeOfSurface(most, 0.25);
    QVERIFY(fine.hasValue());
    QVERIFY(fine->nearShare > 1.0 - kThinShare);
  }

  // Plates that have samples in them, and others of 0.8 mm between samples that lie near those: their surface is near
  // that of the volume, but what they enclose is not in it. Of 0.9 + 3 · 0.8 mm the volume has 1 mm, or of 0.9 + 0.8.
  void materialThatIsLost() {
    for (const int lost : {1, 3}) {
      TriangleSoup plates;
      for (int i = 0; i < 4; ++i) {
        const double x = i * (lost + 2.0);
        append(plates, slab(x, 0.9, 12.0));
        for (int k = 0; k < lost; ++k) append(plates, slab(x + 1.6 + k, 0.8, 12.0));
      }
      const Result<SurfaceVolume> made = volumeOfSurface(plates, 1.0);
      QCOMPARE(made.hasValue(), lost == 1);
      if (!made) QVERIFY(made.error().code == VolumeErrors::MaterialIsLost);
    }
    // A body that is there three times encloses what it does once.
    TriangleSoup thrice = cube(10.0);
    for (const double shift : {0.1, 0.2}) append(thrice, cube(10.0, Vec3::Constant(shift)));
    QVERIFY(volumeOfSurface(thrice, 0.5).hasValue());
  }

  // A cube of two voxels or more keeps its surface, wherever its faces lie between samples, or on them: of four voxels
  // with faces on samples 27 of 64 voxels are inside by their samples.
  void smallCubesStay() {
    static constexpr double kVoxel = 0.5;
    const auto isKept = [](double voxels, const Vec3& offset) {
      const Result<SurfaceVolume> made =
          volumeOfSurface(cube(kVoxel * voxels, kVoxel * offset), kVoxel, {}, Vec3(Vec3::Zero()));
      return made.hasValue();
    };
    for (const double voxels : {2.0, 3.0, 4.0, 4.8, 5.0, 6.0}) QVERIFY(isKept(voxels, Vec3::Zero()));
    QVERIFY(rc::check([&] {
      const auto tenths = [](int low, int high) { return 0.1 * *rc::gen::inRange(low, high); };
      const double voxels = tenths(20, 80);
      RC_ASSERT(isKept(voxels, Vec3(tenths(0, 11), tenths(0, 11), tenths(0, 11))));
    }));
  }

  // If the surface dominates the time, half of the voxel size takes four times as long.
  void secondsArePredicted() {
    const double area = 75.0 * 90.0 * 6.0;  // mm²
    const double coarse = predictedMakingSeconds(area, 0.1), fine = predictedMakingSeconds(area, 0.05);
    QVERIFY(fine > 2.0 * coarse && fine < 4.1 * coarse);  // a job takes a little in any case
    QVERIFY(predictedMakingSeconds(0.0, 0.1) > 0.0);
  }

  // Voxels as large as the part, and a part that is far from the origin.
  void extremes() {
    QVERIFY(volumeOfSurface(cube(1.0, Vec3::Constant(-0.5)), 0.9).hasValue());
    const TriangleSoup far = moved(icosphere(3), Vec3::Constant(1e9), 10.0);
    const Result<SurfaceVolume> made = volumeOfSurface(far, 0.5);
    QVERIFY(made.hasValue());
    QVERIFY(std::abs(made->volume.material() / made->expected - 1.0) < 1e-2);
  }

  void memoryIsPredicted() {
    for (const double voxel : {0.5, 0.2, 0.1}) {
      const TriangleSoup ball = moved(icosphere(4), Vec3::Zero(), 10.0);
      const Result<SurfaceVolume> made = volumeOfSurface(ball, voxel);
      const double ratio = static_cast<double>(made->volume.bytes()) / predictedVolumeBytes(surfaceArea(ball), voxel);
      QVERIFY2(ratio > 0.75 && ratio < 1.5, qPrintable(QString::number(ratio)));
    }
  }

  void cancelled() {
    JobState state;
    state.cancelled = true;
    QVERIFY(volumeOfSurface(icosphere(3), 0.05, Progress(state)).error().code == ErrorCode::Cancelled);
  }
};

HANDWHEEL_TEST(SurfaceToVolumeTest)
#include "SurfaceToVolumeTest.moc"
