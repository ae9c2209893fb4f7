// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/segment/SegmentSmoothing.h"

#include "MadeSegments.h"
#include "TestClass.h"

#include <QtTest>
#include <algorithm>

using namespace handwheel;
using namespace handwheel::test;

class SegmentSmoothingTest : public QObject {
  Q_OBJECT

 private slots:
  // The median of 27, by sorting them.
  void medians_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::addColumn<int>("depth");
    QTest::addRow("bricks") << 35 << 18 << 17;
    QTest::addRow("one slice") << 20 << 20 << 1;
    QTest::addRow("one sample") << 1 << 1 << 1;
  }
  void medians() {
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(int, depth);
    const std::array<int, 3> size{width, height, depth};
    const ImageVolume image = noise(size, 11);
    const Segment segment({45.0, 99.0});
    const Segment after = smoothed(image, segment);
    for (int z = 0; z < depth; ++z)
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          std::vector<bool> around;
          for (int k = 0; k < 27; ++k) {
            const VoxelIndex at(x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1);
            around.push_back(segment.contains(
                image, at.cwiseMax(VoxelIndex::Zero()).cwiseMin(VoxelIndex(width - 1, height - 1, depth - 1))));
          }
          std::sort(around.begin(), around.end());
          QCOMPARE(after.contains(image, {x, y, z}), static_cast<bool>(around[13]));
        }
  }
};

HANDWHEEL_TEST(SegmentSmoothingTest)
#include "SegmentSmoothingTest.moc"
