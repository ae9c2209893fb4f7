// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/ImageToVolume.h"

#include "ClosedSurface.h"
#include "MadeImages.h"
#include "TestClass.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeSampler.h"
#include "volume/surface/VolumeToSurface.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();

// Turned about a slanted axis; mm between the samples.
Eigen::Matrix3d turned(const Vec3& spacing) {
  return Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix() * spacing.asDiagonal();
}

Eigen::Matrix3d stepsNamed(const QString& name) {
  Eigen::Matrix3d steps = Eigen::Matrix3d::Identity();
  if (name == "turned") return turned({0.5, 0.7, 1.3});
  if (name == "uneven") return Vec3(0.4, 0.4, 1.9).asDiagonal();
  if (name == "left-handed") steps(2, 2) = -1.0;
  if (name == "tilted") steps(1, 2) = 0.4;
  return steps;
}

ImageGrid centred(const Eigen::Matrix3d& steps, double extent) {
  ImageGrid grid{{}, Vec3::Zero(), steps};
  for (std::size_t k = 0; k < 3; ++k)
    grid.size[k] = static_cast<int>(std::ceil(extent / steps.col(static_cast<Eigen::Index>(k)).norm())) + 1;
  grid.origin = -0.5 * steps * Vec3(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
  return grid;
}

}  // namespace

class ImageToVolumeTest : public QObject {
  Q_OBJECT

 private slots:
  void grids() {
    QTest::addColumn<QString>("steps");
    for (const char* name : {"plain", "uneven", "turned", "left-handed", "tilted"}) QTest::newRow(name) << name;
  }

  // A ramp is linear between samples whatever the grid, so its surface is the plane, and exactly that.
  void aRamp_data() { grids(); }
  void aRamp() {
    QFETCH(QString, steps);
    const ImageGrid grid = centred(stepsNamed(steps), 24.0);
    const Vec3 along = Vec3(3, -1, 2).normalized();
    const ImageVolume ramp = imageOf(grid, [&](const Vec3& p) { return 40.0 * p.dot(along); });
    const Result<SparseVolume> volume = volumeOfImage(ramp, {30.0, kAny}, std::nullopt);
    QVERIFY(volume.hasValue());
    QCOMPARE(volume->voxel(), grid.spacing().minCoeff());
    const TriangleSoup surface = surfaceOf(*volume);
    QVERIFY(isClosedManifold(surface));
    int onPlane = 0;
    for (const Vec3& p : surface.points) {
      if (p.norm() > 6.0) continue;  // well within the image
      QVERIFY(std::abs(p.dot(along) - 0.75) < 1e-3 * volume->voxel());
      ++onPlane;
    }
    QVERIFY(onPlane > 50);
  }

  // Distances, too, are those of the ball, in every grid; at the ends of an image it is cut off.
  void aBall_data() { grids(); }
  void aBall() {
    QFETCH(QString, steps);
    const ImageGrid grid = centred(stepsNamed(steps), 30.0);
    const ImageVolume ball = imageOf(grid, [](const Vec3& p) { return 500.0 - 100.0 * p.norm(); });
    const Result<SparseVolume> volume = volumeOfImage(ball, {-300.0, kAny}, 0.5);
    QVERIFY(volume.hasValue());
    const double expected = 4.0 / 3.0 * M_PI * 512.0;
    QVERIFY(std::abs(volume->material() / expected - 1.0) < 0.015);
    const TriangleSoup surface = surfaceOf(*volume);
    QVERIFY(std::abs(enclosed(surface) / expected - 1.0) < 0.015);
    // Linear between samples up to 1.9 mm apart a ball is 0.06 mm flatter.
    for (const Vec3& p : surface.points) QVERIFY(std::abs(p.norm() - 8.0) < 0.08);
    const VolumeSampler sampler(*volume);
    for (int i = 0; i < 200; ++i) {
      const Vec3 out = Vec3(std::sin(i), std::cos(3.0 * i), std::sin(2.0 * i + 1.0)).normalized();
      const double radius = 8.0 + std::sin(5.0 * i);
      // Two voxels from the surface depths are known to first order.
      QVERIFY(std::abs(sampler.depthAt(radius * out).depth - (8.0 - radius)) < 0.25);
    }
  }

  // Both ends of a range are surfaces, and as integers too.
  void aShell() {
    const ImageGrid grid = centred(Eigen::Matrix3d::Identity() * 0.5, 30.0);
    const ImageVolume ball = imageOf<std::int16_t>(grid, [](const Vec3& p) { return std::lround(1000.0 * p.norm()); });
    const Result<SparseVolume> volume = volumeOfImage(ball, {6000.0, 9000.0}, std::nullopt);
    QVERIFY(volume.hasValue());
    const double expected = 4.0 / 3.0 * M_PI * (729.0 - 216.0);
    const TriangleSoup surface = surfaceOf(*volume);
    QVERIFY(isClosedManifold(surface));
    QVERIFY(std::abs(enclosed(surface) / expected - 1.0) < 0.005);
    for (const Vec3& p : surface.points) QVERIFY(std::min(std::abs(p.norm() - 6.0), std::abs(p.norm() - 9.0)) < 0.02);
  }

  // An image that is all material is the box of its samples, half a step around each: also of one sample.
  void theBorder() {
    for (const int n : {1, 9, 20}) {
      const ImageGrid grid{{n, n + 1, 2 * n}, Vec3(-3, 4, 5), Eigen::Matrix3d::Identity()};
      const ImageVolume full = imageOf<std::int16_t>(grid, [](const Vec3&) { return 100; });
      const Result<SparseVolume> volume = volumeOfImage(full, {50.0, 200.0}, std::nullopt);
      QVERIFY(volume.hasValue());
      QCOMPARE(volume->material(), static_cast<double>(grid.count()));
      const TriangleSoup surface = surfaceOf(*volume);
      QVERIFY(isClosedManifold(surface));
      for (const Vec3& p : surface.points) {
        const Vec3 index = p - grid.origin;
        double beyond = 1e9;
        for (int k = 0; k < 3; ++k)
          beyond = std::min({beyond, std::abs(index[k] + 0.5), std::abs(index[k] - grid.size[k] + 0.5)});
        QVERIFY(beyond < 1e-3);
      }
    }
  }

  // If axes and spacing are those of the image, each voxel is a sample.
  void voxelsAreSamples() {
    const ImageGrid grid{{30, 20, 10}, Vec3(0.1, -7.7, 1e3), 0.7 * Eigen::Matrix3d::Identity()};
    const auto wave = [](const Vec3& p) { return std::sin(p.x()) + std::cos(p.y()) + std::sin(p.z()); };
    const ImageVolume image = imageOf(grid, wave);
    const Result<SparseVolume> volume = volumeOfImage(image, {0.3, kAny}, std::nullopt);
    QVERIFY(volume.hasValue());
    std::size_t i = 0;
    for (int z = 0; z < 10; ++z)
      for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 30; ++x, ++i) QCOMPARE(volume->sample({x, y, z}) > 0, image.value(i) >= 0.3);
  }

  void refusals() {
    const ImageGrid grid{{8, 8, 8}, Vec3::Zero(), Eigen::Matrix3d::Identity()};
    const ImageVolume image = imageOf<std::int16_t>(grid, [](const Vec3& p) { return p.x(); });
    QVERIFY(volumeOfImage(image, {100.0, 200.0}, 1.0).error().code == VolumeErrors::NothingInRange);
    QVERIFY(volumeOfImage(image, {0.0, 5.0}, 1e-4).error().code == VolumeErrors::TooFine);
    QVERIFY(volumeOfImage(image, {0.0, 5.0}, 0.0).error().code == ErrorCode::ValueOutOfRange);
    QVERIFY(volumeOfImage(image, {0.0, 5.0}, std::nan("")).error().code == ErrorCode::ValueOutOfRange);
    JobState job;
    job.cancelled = true;
    QVERIFY(volumeOfImage(image, {0.0, 5.0}, 1.0, Progress(job)).error().code == ErrorCode::Cancelled);
  }
};

HANDWHEEL_TEST(ImageToVolumeTest)
#include "ImageToVolumeTest.moc"
