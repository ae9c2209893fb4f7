// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/segment/SegmentBrush.h"

#include "MadeSegments.h"
#include "TestClass.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

class SegmentBrushTest : public QObject {
  Q_OBJECT

 private slots:
  // A stroke paints exactly the samples whose distance from its line, tested at many points, is within the radius; for
  // any grid, and over the border.
  void distances_data() {
    QTest::addColumn<Vec3>("from");
    QTest::addColumn<Vec3>("to");
    QTest::addColumn<int>("plane");
    QTest::addColumn<bool>("isErasing");
    QTest::addRow("a ball") << Vec3(20, 15, 9) << Vec3(20, 15, 9) << -1 << false;
    QTest::addRow("a swept ball") << Vec3(5.3, 8, 4) << Vec3(30, 22.7, 11.2) << -1 << false;
    QTest::addRow("erased") << Vec3(5.3, 8, 4) << Vec3(30, 22.7, 11.2) << -1 << true;
    QTest::addRow("a disc") << Vec3(8, 12, 7.2) << Vec3(25, 20, 7.4) << 2 << false;
    QTest::addRow("a disc across x") << Vec3(12, 4, 3) << Vec3(12, 20, 12) << 0 << true;
    QTest::addRow("over the border") << Vec3(-6, -3, 2) << Vec3(3, 40, 30) << -1 << false;
    QTest::addRow("beside the image") << Vec3(-60, -30, 2) << Vec3(-50, 40, 30) << -1 << false;
  }
  void distances() {
    QFETCH(Vec3, from);
    QFETCH(Vec3, to);
    QFETCH(int, plane);
    QFETCH(bool, isErasing);
    std::mt19937 random(5);
    ImageGrid grid{{40, 31, 18}, Vec3(1, 2, 3), Eigen::Matrix3d::Identity()};
    grid.steps =
        Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix() * Vec3(0.5, 0.7, 1.2).asDiagonal();
    grid.steps.col(2) += 0.3 * grid.steps.col(0);  // tilted
    const ImageVolume image = imageOf<std::int16_t>(grid, [&](const Vec3&) { return random() % 100; });
    const Segment before({50.0, 99.0});
    Segment after = before;
    SegmentBrush brush{3.1, isErasing, {}};
    if (plane >= 0) brush.plane = plane;
    applyBrush(after, image, brush, from, to);
    if (plane >= 0) from[plane] = to[plane] = std::round(to[plane]);
    for (int z = 0; z < 18; ++z)
      for (int y = 0; y < 31; ++y)
        for (int x = 0; x < 40; ++x) {
          const VoxelIndex at(x, y, z);
          double distance = 1e9;
          constexpr int kSteps = 400;
          for (int i = 0; i <= kSteps; ++i) {
            const Vec3 p = grid.position(from + (to - from) * i / kSteps);
            distance = std::min(distance, (grid.position(at.cast<double>()) - p).norm());
          }
          if (std::abs(distance - brush.radius) < 1e-3) continue;  // the tries are apart
          const bool isPainted = distance < brush.radius && (plane < 0 || at[plane] == std::lround(to[plane]));
          QCOMPARE(after.contains(image, at), isPainted ? !isErasing : before.contains(image, at));
        }
  }

  // The brush is as large as the image and larger, so that it also contains whole bricks.
  void large() {
    const ImageVolume image = noise({70, 60, 50}, 9);
    const Vec3 middle(33.3, 30.1, 24.7);
    for (const double radius : {22.0, 90.0}) {
      Segment painted({200.0, 300.0});
      applyBrush(painted, image, {radius, false, {}}, middle, middle);
      for (int z = 0; z < 50; ++z)
        for (int y = 0; y < 60; ++y)
          for (int x = 0; x < 70; ++x) {
            const double distance = (image.grid().steps * (Vec3(x, y, z) - middle)).norm();
            QCOMPARE(painted.contains(image, {x, y, z}), distance <= radius);
          }
    }
  }

  // Strokes that change nothing take no memory.
  void nothingNew() {
    const ImageVolume image = noise({40, 40, 40}, 4);
    Segment all({0.0, 99.0});
    applyBrush(all, image, {4.0, false, {}}, Vec3(20, 20, 20), Vec3(22, 20, 20));
    QVERIFY(all.isByRangeAlone());
  }
};

HANDWHEEL_TEST(SegmentBrushTest)
#include "SegmentBrushTest.moc"
