// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/segment/SegmentToVolume.h"

#include "ClosedSurface.h"
#include "MadeSegments.h"
#include "TestClass.h"
#include "volume/VolumeErrors.h"
#include "volume/image/ImageToVolume.h"
#include "volume/segment/SegmentBrush.h"
#include "volume/segment/SegmentParts.h"
#include "volume/surface/VolumeSurface.h"
#include "volume/surface/VolumeToSurface.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

// Balls of 8 and 3 mm in air; the value falls by 100 to a mm.
ImageVolume twoBalls() {
  const ImageGrid grid{{60, 40, 40}, Vec3::Zero(), 0.5 * Eigen::Matrix3d::Identity()};
  return imageOf<std::int16_t>(grid, [](const Vec3& p) {
    return std::lround(100.0 * std::max(8.0 - (p - Vec3(9.1, 10, 10)).norm(), 3.0 - (p - Vec3(24.2, 10, 10)).norm()));
  });
}

}  // namespace

class SegmentToVolumeTest : public QObject {
  Q_OBJECT

 private slots:
  // The voxels of a segment on its own grid are its samples, painted or not, with ranges of one end, two and none.
  void voxelsAreSamples_data() {
    QTest::addColumn<double>("least");
    QTest::addColumn<double>("largest");
    QTest::addRow("upwards") << 0.0 << kNoEnd;
    QTest::addRow("downwards") << -kNoEnd << 200.0;
    QTest::addRow("between") << 100.0 << 500.0;
    QTest::addRow("everything") << -kNoEnd << kNoEnd;
  }
  void voxelsAreSamples() {
    QFETCH(double, least);
    QFETCH(double, largest);
    const ImageVolume image = twoBalls();
    Segment segment({least, largest});
    applyBrush(segment, image, {4.0, true, {}}, Vec3(10, 20, 20), Vec3(30, 20, 25));
    applyBrush(segment, image, {3.0, false, {}}, Vec3(40, 5, 5), Vec3(50, 30, 20));
    const Result<SparseVolume> volume = volumeOfSegment(image, segment, std::nullopt);
    QVERIFY(volume.hasValue());
    for (int z = 0; z < 40; ++z)
      for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x) QCOMPARE(volume->sample({x, y, z}) > 0, segment.contains(image, {x, y, z}));
    QVERIFY(isClosedManifold(surfaceOf(*volume)));
  }

  // The largest part alone has the surface that it had beside the other: that of a ball, between the samples.
  void aPartStaysWhereItIs() {
    const ImageVolume image = twoBalls();
    const Segment both({0.0, kNoEnd});
    const SegmentParts parts(image, both);
    QCOMPARE(parts.samples().size(), std::size_t{2});
    const Result<SparseVolume> all = volumeOfSegment(image, both, std::nullopt),
                               one = volumeOfSegment(image, parts.only(0, 1), std::nullopt);
    QVERIFY(all && one);
    std::size_t seen = 0;
    const TriangleSoup ball = surfaceOf(*one);
    for (const Vec3& p : ball.points) QVERIFY(std::abs((p - Vec3(9.1, 10, 10)).norm() - 8.0) < 0.02);
    const TriangleSoup surface = surfaceOf(*all);
    for (const Vec3& p : surface.points) seen += (p - Vec3(9.1, 10, 10)).norm() < 9.0 ? 1 : 0;
    QCOMPARE(ball.points.size(), seen);
  }

  // A brushed ball in air is one, to half a sample.
  void painted() {
    const ImageGrid grid{{50, 50, 50}, Vec3::Zero(), 0.4 * Eigen::Matrix3d::Identity()};
    const ImageVolume air = imageOf<std::int16_t>(grid, [](const Vec3&) { return -1000; });
    Segment segment({300.0, kNoEnd});
    const Vec3 middle(24.3, 25.1, 24.8);
    applyBrush(segment, air, {7.0, false, {}}, middle, middle);
    const Result<SparseVolume> volume = volumeOfSmoothed(air, segment, std::nullopt, true);
    QVERIFY(volume.hasValue());
    const TriangleSoup surface = surfaceOf(*volume);
    QVERIFY(isClosedManifold(surface));
    for (const Vec3& p : surface.points) QVERIFY(std::abs((p - 0.4 * middle).norm() - 7.0) < 0.2);
    applyBrush(segment, air, {9.0, true, {}}, middle, middle);
    QVERIFY(volumeOfSegment(air, segment, std::nullopt).error().code == VolumeErrors::NothingInRange);
  }

  // The faces of a box are its area; those at the border of the image, too.
  void faces() {
    ImageGrid grid{{20, 30, 25}, Vec3::Zero(), Vec3(0.5, 0.7, 1.1).asDiagonal().toDenseMatrix()};
    const ImageVolume box =
        imageOf<std::int16_t>(grid, [](const Vec3& p) { return p.x() < 4.9 && p.y() > 6.9 ? 1 : 0; });
    const double a = 10 * 0.5, b = 20 * 0.7, c = 25 * 1.1;
    QVERIFY(std::abs(facesOf(box, Segment({1.0, 1.0})) - 2.0 * (a * b + b * c + c * a)) < 1e-9);
    QCOMPARE(facesOf(box, Segment({5.0, 6.0})), 0.0);
  }

  // The prediction is correct to a half for a ball, at all voxel sizes.
  void prediction() {
    const ImageVolume image = twoBalls();
    const Segment segment({0.0, kNoEnd});
    const double faces = facesOf(image, segment);
    for (const double voxel : {0.5, 0.25, 0.1}) {
      const Result<SparseVolume> volume = volumeOfSegment(image, segment, voxel);
      QVERIFY(volume.hasValue());
      const double bytes = static_cast<double>(volume->blockCount()) * sizeof(VolumeBlock) +
                           static_cast<double>(VolumeSurface(*volume).triangleCount()) * (12.0 + 0.5 * 24.0);
      const double predicted = predictedBytes(image, segment, faces, voxel);
      QVERIFY2(predicted > bytes / 1.5 && predicted < bytes * 1.5, qPrintable(QString::number(predicted / bytes)));
    }
  }
};

HANDWHEEL_TEST(SegmentToVolumeTest)
#include "SegmentToVolumeTest.moc"
