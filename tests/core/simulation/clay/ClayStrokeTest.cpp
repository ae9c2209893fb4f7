// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/clay/ClayStroke.h"

#include "TestClass.h"
#include "volume/ClayStamp.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

ClayBrush stampBrush(double turn = 0.0) {
  ClayBrush brush;
  brush.action = ClayAction::Add;
  brush.radius = 2.0;
  brush.strength = 0.75;
  brush.stamp = std::make_shared<const ClayStamp>(1, 1, std::vector<float>{1.0f});
  brush.turn = turn;
  return brush;
}

bool isNear(const Vec3& a, const Vec3& b) {
  return (a - b).norm() < 1e-9;
}

}  // namespace

class ClayStrokeTest : public QObject {
  Q_OBJECT

 private slots:
  // One where it is pressed, however long it rests; then side by side, as wide as the square in the circle.
  void stampsSideBySide() {
    ClayStroke stroke(stampBrush());
    for (int i = 0; i < 50; ++i) stroke.move({0.001 * i, 0.0, 0.0}, 0.1 * i, Vec3::UnitZ());
    QCOMPARE(stroke.dabs().size(), std::size_t{1});
    for (int i = 0; i <= 200; ++i) stroke.move({0.1 * i, 0.0, 0.0}, 5.0 + 0.01 * i, Vec3::UnitZ());
    const double side = 2.0 * std::sqrt(2.0);
    QCOMPARE(stroke.dabs().size(), 1 + static_cast<std::size_t>(20.0 / side));
    for (std::size_t i = 1; i < stroke.dabs().size(); ++i) {
      const double gap = stroke.dabs()[i].centre.x() - stroke.dabs()[i - 1].centre.x();
      QVERIFY(gap > 0.99 * side && gap < 1.01 * side);
      QCOMPARE(stroke.dabs()[i].strength, 0.75);
    }
  }

  // Upright as seen from outside: by z on walls, by y on what lies flat.
  void stampsAreUpright() {
    const auto dabOn = [](const Vec3& normal, double turn) {
      ClayStroke stroke(stampBrush(turn));
      stroke.move(Vec3::Zero(), 0.0, normal);
      return stroke.dabs().front();
    };
    QVERIFY(isNear(dabOn(Vec3::UnitZ(), 0.0).up, Vec3::UnitY()));
    QVERIFY(isNear(dabOn(Vec3::UnitZ(), 0.0).right, Vec3::UnitX()));
    QVERIFY(isNear(dabOn(-Vec3::UnitY(), 0.0).up, Vec3::UnitZ()));  // seen from the front
    QVERIFY(isNear(dabOn(-Vec3::UnitY(), 0.0).right, Vec3::UnitX()));
    // Anticlockwise by a quarter.
    QVERIFY(isNear(dabOn(Vec3::UnitZ(), 0.5 * M_PI).right, Vec3::UnitY()));
    QVERIFY(isNear(dabOn(Vec3::UnitZ(), 0.5 * M_PI).up, -Vec3::UnitX()));
    for (int i = 0; i < 100; ++i) {
      const Vec3 normal = Vec3(std::sin(i), std::cos(3.0 * i), std::sin(2.0 * i + 1.0)).normalized();
      const ClayDab dab = dabOn(normal, 0.1 * i);
      QVERIFY(isNear(dab.right.cross(dab.up), normal));
    }
  }
};

HANDWHEEL_TEST(ClayStrokeTest)
#include "ClayStrokeTest.moc"
