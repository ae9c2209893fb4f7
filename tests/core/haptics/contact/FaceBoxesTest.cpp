// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/contact/FaceBoxes.h"

#include <QtTest>
#include <random>

using namespace handwheel;

class FaceBoxesTest : public QObject {
  Q_OBJECT

 private slots:
  // Compared with boxes of doubles: none is missed, and none is reported that is farther off than the rounding to
  // float.
  void tellsWhichASegmentMeets_data() {
    QTest::addColumn<double>("scale");
    QTest::addColumn<double>("away");
    QTest::newRow("millimetres") << 1.0 << 0.0;
    QTest::newRow("far from the origin") << 1.0 << 1e6;
    QTest::newRow("nanometres") << 1e-6 << 0.0;
    QTest::newRow("too small for floats") << 1e-60 << 0.0;
    QTest::newRow("too large for floats") << 1e60 << 0.0;
  }
  void tellsWhichASegmentMeets() {
    QFETCH(double, scale);
    QFETCH(double, away);
    std::mt19937 random(5);
    const auto within = [&](double size) {
      std::uniform_real_distribution<double> number(-size, size);
      return Vec3(number(random), number(random), number(random));
    };
    int met = 0, apart = 0;
    for (int round = 0; round < 300; ++round) {
      const Vec3 middle = Vec3::Constant(away) + within(away);
      const auto at = [&](const Vec3& p) { return Vec3(scale * (middle + p)); };
      const Box region(at(Vec3(-1, -0.5, -1)), at(Vec3(1, 0.5, 0.3)));
      FaceBoxes boxes;
      boxes.clear(region);
      std::vector<TrianglePoints> triangles(static_cast<std::size_t>(round) % (FaceBoxes::kCapacity + 1));
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Vec3 p = within(1.0);
        const double size = i % 8 == 0 ? 50.0 : 0.3;  // some stand far out of the region
        triangles[i] = {at(p), at(p + within(size)), at(p + within(size))};
        boxes.set(i, triangles[i]);
      }
      for (int ray = 0; ray < 20; ++ray) {
        const Vec3 p = at(within(0.3));
        const Vec3 step = at(within(0.3)) - p;
        const double near = scale * (ray % 3 == 0 ? 0.0 : 0.01);
        const std::uint64_t bits = boxes.meeting(p, step, near, triangles.size());
        if (triangles.size() < FaceBoxes::kCapacity) QVERIFY(bits >> triangles.size() == 0);
        const Vec3 end = p + step;
        for (std::size_t i = 0; i < triangles.size(); ++i) {
          const auto& [a, b, c] = triangles[i];
          const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
          const double gap = std::max((low - p.cwiseMax(end)).maxCoeff(), (p.cwiseMin(end) - high).maxCoeff());
          const bool found = (bits >> i & 1) != 0;
          if (gap <= near) QVERIFY(found);
          if (gap > near + 1e-5 * scale) QVERIFY(!found);
          (found ? met : apart) += 1;
        }
      }
    }
    QVERIFY(met > 10'000 && apart > 10'000);
  }

  // A region without extent, for example if all corners are one point.
  void namesAllWhereItCannotTell() {
    FaceBoxes boxes;
    boxes.clear(Box(Vec3(1, 2, 3)));
    boxes.set(0, {Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(1, 2, 3)});
    QCOMPARE(boxes.meeting(Vec3(1, 2, 3), Vec3::Zero(), 0.0, 1), std::uint64_t{1});
    QCOMPARE(boxes.meeting(Vec3(1, 2, 3), Vec3::Zero(), 0.0, 0), std::uint64_t{0});
  }
};

HANDWHEEL_TEST(FaceBoxesTest)
#include "FaceBoxesTest.moc"
