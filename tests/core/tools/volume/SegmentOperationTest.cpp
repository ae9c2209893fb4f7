// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/SegmentOperation.h"

#include "../../volume/image/MadeImages.h"
#include "TestClass.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeSampler.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr double kOpen = std::numeric_limits<double>::infinity();
constexpr double kLarge = 5.0, kSmall = 2.5, kSpacing = 0.5;  // mm, radii of balls and distance of samples

// Two balls apart, their values falling by 100 to a mm from their surfaces on.
ImageVolume largeAndSmallBall() {
  const ImageGrid grid{{44, 26, 26}, Vec3::Zero(), kSpacing * Eigen::Matrix3d::Identity()};
  return test::imageOf<std::int16_t>(grid, [](const Vec3& p) {
    const double large = kLarge - (p - Vec3(6.1, 6.2, 6.0)).norm(), small = kSmall - (p - Vec3(17.0, 6.2, 6.0)).norm();
    return std::lround(100.0 * std::max(large, small));
  });
}

double volumeOfBall(double radius) {
  return 4.0 / 3.0 * M_PI * std::pow(radius, 3);
}

OperationValues valuesWith(const std::map<std::string, PropertyValue>& set) {
  OperationValues values(segmentOperation());
  for (const auto& [id, value] : set) values.setValid(id, value);
  return values;
}

}  // namespace

class SegmentOperationTest : public QObject {
  Q_OBJECT

 private slots:
  void rangesAsTyped() {
    const auto is = [](const char* text, double least, double largest) {
      const std::optional<ValueRange> range = rangeIn(text);
      return range && range->least == least && range->largest == largest;
    };
    QVERIFY(is("300:2000", 300.0, 2000.0));
    QVERIFY(is("-1000.5:+2e3", -1000.5, 2000.0));
    QVERIFY(is("300:", 300.0, kOpen));
    QVERIFY(is(":50", -kOpen, 50.0));
    QVERIFY(is("7:7", 7.0, 7.0));
    for (const char* const text :
         {"", ":", "300", "300-2000", "a:b", "300:b", "2:1", "1:2:3", "nan:1", "0:inf", " 1:2"})
      QVERIFY2(!rangeIn(text), text);
  }

  // The values from 0 upwards are both balls; asked for one part it is the larger of them.
  void partsOfARange() {
    const ImageVolume image = largeAndSmallBall();
    const Result<Segmented> both = segment(image, valuesWith({{"range", std::string("0:")}}), {});
    QVERIFY(both.hasValue());
    QCOMPARE(both->range.least, 0.0);
    QCOMPARE(both->parts, std::size_t{2});
    QCOMPARE(both->kept, std::size_t{2});
    QVERIFY(std::abs(both->volume.enclosed() / (volumeOfBall(kLarge) + volumeOfBall(kSmall)) - 1.0) < 0.02);
    QCOMPARE(both->volume.voxel(), kSpacing);
    const auto largest = [&](double count) {
      return segment(image, valuesWith({{"range", std::string("0:")}, {"largest", count}}), {});
    };
    const Result<Segmented> one = largest(1.0);
    QVERIFY(one && one->parts == 2 && one->kept == 1);
    QVERIFY(std::abs(one->volume.enclosed() / volumeOfBall(kLarge) - 1.0) < 0.02);
    QVERIFY(VolumeSampler(one->volume).depthAt({17.0, 6.2, 6.0}).depth < 0.0);
    QVERIFY(largest(5.0)->kept == 2);
  }

  // Another range is another surface: a shell where the ball is between two depths.
  void aRangeOfTwoEnds() {
    const Result<Segmented> shell =
        segment(largeAndSmallBall(), valuesWith({{"range", std::string("0:200")}, {"largest", 1.0}}), {});
    QVERIFY(shell.hasValue());
    const double exact = volumeOfBall(kLarge) - volumeOfBall(kLarge - 2.0);
    QVERIFY2(std::abs(shell->volume.enclosed() / exact - 1.0) < 0.03, QByteArray::number(shell->volume.enclosed()));
    QVERIFY(VolumeSampler(shell->volume).depthAt({6.1, 6.2, 6.0}).depth < 0.0);
  }

  // Without a range, an image of two values is divided between them; an image without values in the range is reported.
  void withoutARange() {
    const ImageGrid grid{{16, 16, 16}, Vec3::Zero(), Eigen::Matrix3d::Identity()};
    const ImageVolume image = test::imageOf<std::int16_t>(
        grid, [](const Vec3& p) { return p.x() > 7.0 && p.y() > 3.0 && p.z() > 5.0 ? 900 : -300; });
    const Result<Segmented> done = segment(image, valuesWith({}), {});
    QVERIFY(done && done->range.least > -300.0 && done->range.least <= 900.0 && done->range.largest == kOpen);
    QCOMPARE(done->volume.material(), 8.0 * 12.0 * 10.0);  // volume of the samples
    const Result<Segmented> none = segment(image, valuesWith({{"range", std::string("1000:")}}), {});
    QVERIFY(!none && none.error().code == VolumeErrors::NothingInRange);
  }

  // Before anything is made it is reported what the volume needs, and can be refused.
  void askedBefore() {
    const ImageVolume image = largeAndSmallBall();
    double reported = 0.0, needed = 0.0;
    const auto ask = [&](const std::map<std::string, PropertyValue>& set, bool isAllowed) {
      return segment(image, valuesWith(set), {}, [&](double voxel, double bytes) -> Status {
        reported = voxel;
        needed = bytes;
        if (isAllowed) return Done{};
        return Error{VolumeErrors::NeedsConsent, {}, {}, {}};
      });
    };
    const std::string range = "0:";
    QVERIFY(ask({{"range", range}}, true).hasValue());
    QCOMPARE(reported, kSpacing);
    const double coarse = needed;
    const Result<Segmented> fine = ask({{"range", range}, {"voxel", 0.25}}, true);
    QVERIFY(fine && fine->volume.voxel() == 0.25);
    QCOMPARE(reported, 0.25);
    QVERIFY2(needed > 2.0 * coarse, QByteArray::number(needed / coarse));  // four times as many voxels at the surface
    const Result<Segmented> refused = ask({{"range", range}}, false);
    QVERIFY(!refused && refused.error().code == VolumeErrors::NeedsConsent);
  }

  // The steps of voxels of a ball of two values are taken off: its radius varies less, at most by four fifths. On
  // average it stays within a voxel, which is of 1 mm.
  void smoothed() {
    const Vec3 middle = Vec3::Constant(9.5);
    const ImageGrid grid{{20, 20, 20}, Vec3::Zero(), Eigen::Matrix3d::Identity()};
    const ImageVolume ball =
        test::imageOf<std::int16_t>(grid, [&](const Vec3& p) { return (p - middle).norm() < 6.5 ? 100 : 0; });
    const auto variation = [&](bool isSmooth) {
      const Result<Segmented> done =
          segment(ball, valuesWith({{"range", std::string("50:")}, {"smooth", isSmooth}}), {});
      if (!done) return std::pair(kOpen, kOpen);
      const VolumeSampler sampler(done->volume);
      double sum = 0.0, squares = 0.0;
      for (int i = 0; i < 300; ++i) {
        const Vec3 out = Vec3(std::sin(i), std::cos(3.0 * i), std::sin(2.0 * i + 1.0)).normalized();
        const double depth = sampler.depthAt(middle + 6.5 * out).depth;
        sum += depth;
        squares += depth * depth;
      }
      return std::pair(sum / 300.0, std::sqrt(squares / 300.0 - std::pow(sum / 300.0, 2)));
    };
    const auto [smoothMean, smooth] = variation(true);
    const auto [steppedMean, stepped] = variation(false);
    QVERIFY(std::abs(smoothMean) < 1.0 && std::abs(steppedMean) < 1.0);
    QVERIFY2(smooth < 0.8 * stepped, QByteArray::number(smooth / stepped));
  }

  void cancelledAndFollowed() {
    const ImageVolume image = largeAndSmallBall();
    for (const bool isSmooth : {false, true}) {
      JobState job;
      const auto values = valuesWith({{"range", std::string("0:")}, {"smooth", isSmooth}});
      QVERIFY(segment(image, values, Progress(job)).hasValue());
      QCOMPARE(job.fraction.load(), 1.0);
    }
    JobState job;
    job.cancelled = true;
    const Result<Segmented> cancelled = segment(image, valuesWith({{"range", std::string("0:")}}), Progress(job));
    QVERIFY(!cancelled && cancelled.error().code == ErrorCode::Cancelled);
  }
};

HANDWHEEL_TEST(SegmentOperationTest)
#include "SegmentOperationTest.moc"
