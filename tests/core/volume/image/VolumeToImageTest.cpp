// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/VolumeToImage.h"

#include "TestClass.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeShapes.h"
#include "volume/image/ImageToVolume.h"

#include <QtTest>
#include <limits>

using namespace handwheel;

class VolumeToImageTest : public QObject {
  Q_OBJECT

 private slots:
  // The distance of a ball, up to where volumes know it.
  void aBall() {
    const double voxel = 0.25;
    const Result<ImageVolume> image = distancesOf(ballOfVoxels(4.0, voxel));
    QVERIFY(image.hasValue());
    const auto& size = image->grid().size;
    std::size_t i = 0;
    for (int z = 0; z < size[2]; ++z)
      for (int y = 0; y < size[1]; ++y)
        for (int x = 0; x < size[0]; ++x, ++i) {
          const double distance = image->grid().position(Vec3(x, y, z)).norm() - 4.0;
          if (std::abs(distance) < 3.0 * voxel) QVERIFY(std::abs(image->value(i) - distance) < 0.01);
          if (std::abs(distance) >= 4.0 * voxel) QVERIFY(image->value(i) * distance > 0.0);
        }
  }

  // And back: the same voxels inside.
  void andBack() {
    const SparseVolume ball = ballOfVoxels(4.0, 0.25);
    const Result<ImageVolume> image = distancesOf(ball);
    QVERIFY(image.hasValue());
    const Result<SparseVolume> back =
        volumeOfImage(*image, {-std::numeric_limits<double>::infinity(), 0.0}, std::nullopt);
    QVERIFY(back.hasValue());
    QCOMPARE(back->material(), ball.material());
  }

  void tooLarge() {
    SparseVolume far(Vec3::Zero(), 1.0);
    far.setContent({-30'000, -30'000, -30'000}, {nullptr, true});
    far.setContent({30'000, 30'000, 30'000}, {nullptr, true});
    QVERIFY(distancesOf(far).error().code == VolumeErrors::TooLarge);
    QVERIFY(distancesOf(SparseVolume(Vec3::Zero(), 1.0)).hasValue());  // nothing is an image of what is outside
  }
};

HANDWHEEL_TEST(VolumeToImageTest)
#include "VolumeToImageTest.moc"
