// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/clay/ClayStroke.h"

#include "TestClass.h"
#include "volume/clay/ClayStamp.h"

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

  // Strength and radius go with the pressure where they are to; of the radius a tenth is left.
  void pressureChanges() {
    const double nan = std::nan("");
    for (const ClayPressure what :
         {ClayPressure::Nothing, ClayPressure::Strength, ClayPressure::Radius, ClayPressure::Both}) {
      const bool isStrength = what == ClayPressure::Strength || what == ClayPressure::Both;
      const bool isRadius = what == ClayPressure::Radius || what == ClayPressure::Both;
      for (const double share : {0.0, 0.02, 0.25, 0.5, 1.0}) {
        for (const ClayAction action : {ClayAction::Inflate, ClayAction::Move, ClayAction::Mask, ClayAction::Carve}) {
          ClayBrush brush;
          brush.action = action;
          brush.radius = 3.0;
          brush.strength = -0.6;
          brush.pressure = what;
          const double whole = action == ClayAction::Move ? 1.0 : action == ClayAction::Mask ? -1.0 : -0.6;
          QVERIFY(std::abs(brush.at(share).strength - (isStrength ? share : 1.0) * whole) < 1e-12);
          QVERIFY(std::abs(brush.at(share).radius - (isRadius ? std::max(0.1, share) : 1.0) * 3.0) < 1e-12);
        }
      }
      ClayBrush brush;
      brush.pressure = what;
      for (const double none : {nan, 7.0}) QCOMPARE(brush.at(none), brush.at(1.0));
      QCOMPARE(brush.at(-1.0), brush.at(0.0));
    }
    ClayBrush brush;
    brush.action = ClayAction::Smooth;
    brush.radius = 3.0;
    brush.strength = 0.8;
    brush.pressure = ClayPressure::Both;
    ClayStroke stroke(brush);
    stroke.move(Vec3::Zero(), 0.0, Vec3::UnitZ(), 0.5);
    stroke.move({0.35, 0.0, 0.0}, 0.01, Vec3::UnitZ(), 0.5);  // a fifth of 1.5 mm
    QCOMPARE(stroke.dabs().size(), std::size_t{2});
    QCOMPARE(stroke.dabs()[1].radius, 1.5);
    QCOMPARE(stroke.dabs()[1].strength, 0.4);
  }

  // A brush that also acts at rest does so twenty times a second at most: of 64 positions in each of two seconds every
  // fourth. A brush that moves material needs a displacement.
  void aBrushThatRests() {
    const auto dabsOf = [](ClayAction action) {
      ClayBrush brush;
      brush.action = action;
      ClayStroke stroke(brush);
      for (int i = 0; i <= 128; ++i) stroke.move({1.0, 2.0, 3.0}, i / 64.0, Vec3::UnitX());
      for (const ClayDab& dab : stroke.dabs())
        if (!isNear(dab.centre, {1.0, 2.0, 3.0}) || !isNear(dab.direction, Vec3::UnitX())) return std::size_t{0};
      return stroke.dabs().size();
    };
    QCOMPARE(dabsOf(ClayAction::Smooth), std::size_t{1 + 32});
    QCOMPARE(dabsOf(ClayAction::Inflate), std::size_t{1 + 32});
    QCOMPARE(dabsOf(ClayAction::Carve), std::size_t{1});  // it is swept
    QCOMPARE(dabsOf(ClayAction::Move), std::size_t{0});
  }

  // Upright as seen from outside: by z on walls, by y on flat surfaces.
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
