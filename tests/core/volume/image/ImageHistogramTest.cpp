// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/ImageHistogram.h"

#include "MadeImages.h"
#include "TestClass.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <numeric>

using namespace handwheel;
using namespace handwheel::test;

class ImageHistogramTest : public QObject {
  Q_OBJECT

 private slots:
  // Against plain counting: each sample lies in its bin, and there are no others. Also over several tasks.
  void counts() {
    const ImageGrid grid{{150, 120, 110}, Vec3::Zero(), Eigen::Matrix3d::Identity()};
    const ImageVolume image =
        imageOf<std::int16_t>(grid, [](const Vec3& p) { return 900.0 * std::sin(p.x() * 0.7 + p.y() * p.z()); });
    for (const std::size_t bins : {std::size_t{1}, std::size_t{7}, std::size_t{256}}) {
      const ImageHistogram histogram = histogramOf(image, bins);
      QCOMPARE(histogram.counts.size(), bins);
      std::vector<std::int16_t> sorted;
      image.visitSamples([&](auto samples) {
        for (const auto each : samples) sorted.push_back(static_cast<std::int16_t>(each));
      });
      std::sort(sorted.begin(), sorted.end());
      QCOMPARE(histogram.values.least, static_cast<double>(sorted.front()));
      QCOMPARE(histogram.values.largest, static_cast<double>(sorted.back()));
      std::size_t before = 0;
      for (std::size_t i = 0; i < bins; ++i) {
        // Not at ends of bins, which rounding may give to either.
        const double end = histogram.values.least + histogram.width() * static_cast<double>(i + 1);
        const auto below = static_cast<std::size_t>(
            i + 1 == bins ? static_cast<std::ptrdiff_t>(sorted.size())
                          : std::lower_bound(sorted.begin(), sorted.end(), end - 1e-6) - sorted.begin());
        QCOMPARE(histogram.counts[i], below - before);
        before = below;
      }
    }
  }

  void quantiles() {
    const ImageGrid grid{{1000, 1, 1}, Vec3::Zero(), Eigen::Matrix3d::Identity()};
    const ImageHistogram ramp = histogramOf(imageOf(grid, [](const Vec3& p) { return p.x(); }), 999);
    QVERIFY(std::abs(ramp.quantile(0.25) - 250.0) <= 1.0);
    QVERIFY(std::abs(ramp.quantile(0.99) - 990.0) <= 1.0);
    QCOMPARE(ramp.quantile(1.0), 999.0);
  }

  // The threshold is between two peaks of any sizes; a single value cannot be divided.
  void otsu() {
    const ImageGrid grid{{50, 10, 10}, Vec3::Zero(), Eigen::Matrix3d::Identity()};
    const auto threshold = [](const ImageVolume& image) { return otsuThreshold(histogramOf(image)); };
    const ImageVolume two = imageOf(grid, [](const Vec3& p) { return p.x() < 40.0 ? std::sin(p.y()) : 100.0 + p.z(); });
    QVERIFY(threshold(two) > 1.0 && threshold(two) < 100.0);
    const ImageVolume steps = imageOf<std::int16_t>(grid, [](const Vec3& p) { return p.x() < 25.0 ? -1000 : 500; });
    QVERIFY(std::abs(threshold(steps) - -250.0) < 2.0);
    const ImageVolume flat = imageOf<std::int16_t>(grid, [](const Vec3&) { return 7; });
    QCOMPARE(threshold(flat), 7.0);
  }

  void hounsfield() {
    QVERIFY(looksLikeHounsfield({-1024.0, 3071.0}));
    QVERIFY(!looksLikeHounsfield({0.0, 4095.0}));
    QVERIFY(!looksLikeHounsfield({-1024.0, 100.0}));
    QVERIFY(!looksLikeHounsfield({-32768.0, 32767.0}));
  }
};

HANDWHEEL_TEST(ImageHistogramTest)
#include "ImageHistogramTest.moc"
