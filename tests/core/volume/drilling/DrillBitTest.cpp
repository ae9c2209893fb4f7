// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillBit.h"

#include "TestClass.h"
#include "volume/drilling/DrillBits.h"
#include "volume/drilling/DrillHead.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

double drawnBetween(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1'000'001) / 1e6;
}

}  // namespace

class DrillBitTest : public QObject {
  Q_OBJECT

 private slots:
  // The distance from a twist drill is that to the nearest of many points of its outline, rotated to the point.
  void distanceFromTheHead() {
    QVERIFY(rc::check([] {
      const DrillBit tool = *drillBitOf("twist:6");
      const double across = drawnBetween(0.0, 8.0), up = drawnBetween(-8.0, 66.0), turn = drawnBetween(0.0, 6.3);
      const Vec3 axis = Vec3(drawnBetween(-1.0, 1.0), drawnBetween(-1.0, 1.0), 1.5).normalized();
      const Vec3 x = axis.unitOrthogonal(), y = axis.cross(x);
      const Vec3 from = up * axis + across * (std::cos(turn) * x + std::sin(turn) * y);
      const double reach = tool.radius() / std::tan(0.5 * tool.pointAngle);
      double nearest = 1e9;
      constexpr int kPoints = 20'000;
      for (int i = 0; i <= kPoints; ++i) {
        const double t = static_cast<double>(i) / kPoints;
        nearest = std::min(nearest, std::hypot(across - t * tool.radius(), up - (t - 1.0) * reach));  // cone
        nearest = std::min(nearest, std::hypot(across - tool.radius(), up - t * tool.length));        // side
        nearest = std::min(nearest, std::hypot(across - t * tool.radius(), up - tool.length));        // back
      }
      const bool isInside = across < tool.radius() && up < tool.length && across < (up + reach) / reach * tool.radius();
      RC_ASSERT(std::abs(tool.signedDepth(from, axis) - (isInside ? nearest : -nearest)) < 1e-2);
    }));
  }

  // The depth for a moved head is at most the bound for its displacement, and equal to it without a displacement.
  void boundOfMovedHeads() {
    QVERIFY(rc::check([] {
      const DrillHead head(*drillBitOf(*rc::gen::element<std::string>("ball:6", "twist:6", "saw:20:2")));
      const auto drawnVector = [](double most) {
        return Vec3(drawnBetween(-most, most), drawnBetween(-most, most), drawnBetween(-most, most));
      };
      const Vec3 from = drawnVector(15.0), displacement = drawnVector(2.0),
                 axis = (drawnVector(1.0) + Vec3(0, 0, 3)).normalized();
      const double along = std::abs(displacement.dot(axis)),
                   across = (displacement - displacement.dot(axis) * axis).norm();
      const auto bound = head.row<8>(from, axis, across, along), still = head.row<8>(from, axis, 0.0, 0.0);
      for (int i = 0; i < 8; ++i) {
        const Vec3 point = from + i * Vec3::UnitX();
        RC_ASSERT(head.inside(point - displacement, axis) <= bound[i] + 1e-12);
        RC_ASSERT(std::abs(head.inside(point, axis) - still[i]) < 1e-12);
      }
    }));
  }

  // A disc: to its rim across the axis, to its faces along it, to its edge aslant.
  void distanceFromASaw() {
    const DrillBit tool = *drillBitOf("saw:20:2");
    const Vec3 axis = Vec3::UnitX();
    QCOMPARE(tool.signedDepth(Vec3(0.5, 0.0, 12.0), axis), -2.0);
    QCOMPARE(tool.signedDepth(Vec3(4.0, 3.0, 0.0), axis), -3.0);
    QVERIFY(std::abs(tool.signedDepth(Vec3(-4.0, 14.0, 0.0), axis) + 5.0) < 1e-12);
    QCOMPARE(tool.signedDepth(Vec3(0.25, 0.0, 5.0), axis), 0.75);
    QCOMPARE(tool.edge(), 10.0);
    QCOMPARE(tool.reach(), 1.0);
  }

  void distanceFromABall() {
    const DrillBit tool = *drillBitOf("ball:6");
    QCOMPARE(tool.signedDepth(Vec3(0.0, 4.0, 3.0), Vec3::UnitZ()), -2.0);
    QCOMPARE(tool.signedDepth(Vec3(0.0, 0.0, 1.0), Vec3::UnitZ()), 2.0);
  }
};

HANDWHEEL_TEST(DrillBitTest)
#include "DrillBitTest.moc"
