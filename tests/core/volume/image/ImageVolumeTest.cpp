// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/ImageVolume.h"

#include "MadeImages.h"
#include "TestClass.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

class ImageVolumeTest : public QObject {
  Q_OBJECT

 private slots:
  void valuesAndPositions() {
    const ImageGrid grid{{4, 3, 2}, Vec3(1, 2, 3), Vec3(0.5, 1.0, 2.0).asDiagonal().toDenseMatrix()};
    const ImageVolume image = imageOf<std::int16_t>(grid, [](const Vec3& p) { return 10 * p.x() + p.z(); });
    QVERIFY(image.isWhole());
    QCOMPARE(image.value(0), 13.0);
    QCOMPARE(image.value(23), 10 * 2.5 + 5.0);
    QCOMPARE(valuesOf(image).least, 13.0);
    QCOMPARE(valuesOf(image).largest, 30.0);
    QCOMPARE(grid.spacing(), Vec3(0.5, 1.0, 2.0));
  }

  void gridsThatAreRefused() {
    ImageGrid good{{2, 2, 2}, Vec3::Zero(), Eigen::Matrix3d::Identity()};
    QVERIFY(checkGrid(good).hasValue());
    good.steps.col(0) *= -1.0;  // left-handed is an image, too
    QVERIFY(checkGrid(good).hasValue());
    ImageGrid bad = good;
    bad.size[1] = 0;
    QVERIFY(!checkGrid(bad));
    bad.size = {60'000, 60'000, 60'000};
    QVERIFY(checkGrid(bad).error().code == ErrorCode::FileTooLarge);
    bad = good;
    bad.steps.col(2) = bad.steps.col(1);
    QVERIFY(!checkGrid(bad));
    bad = good;
    bad.steps(0, 0) = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!checkGrid(bad));
    bad = good;
    bad.origin.x() = std::numeric_limits<double>::infinity();
    QVERIFY(!checkGrid(bad));
    bad = good;
    bad.steps *= 1e-9;
    QVERIFY(!checkGrid(bad));
  }
};

HANDWHEEL_TEST(ImageVolumeTest)
#include "ImageVolumeTest.moc"
