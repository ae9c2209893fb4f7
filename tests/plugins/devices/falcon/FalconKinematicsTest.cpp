// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "falcon/Kinematics.h"

#include <rapidcheck.h>
#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;
using namespace handwheel::falcon;

namespace {

Vec3 pointOf(const Counts& counts) {
  const std::optional<Vec3> point = forward(anglesOf(counts), kHome);
  return point ? *point : Vec3::Constant(std::nan(""));
}

// Returns a point within the reach of the grip: in a cylinder.
Vec3 anyPoint() {
  const double radius = 1e-6 * *rc::gen::inRange(0, 45'000);
  const double turn = 1e-3 * *rc::gen::inRange(0, 6283);
  const double z = 1e-6 * *rc::gen::inRange(90'000, 165'000);
  return {radius * std::cos(turn), radius * std::sin(turn), z};
}

// Returns the difference between the ends of a leg's parallelogram and its length: the loop closure, written with
// vectors in space.
double loopGap(const Vec3& point, double angle, double azimuth) {
  const Vec3 out(std::cos(azimuth), std::sin(azimuth), 0.0), along(-std::sin(azimuth), std::cos(azimuth), 0.0);
  const Vec3 shaft = 0.0400 * out - 0.02309 * along;
  const Vec3 armEnd = shaft + 0.060 * (std::cos(angle) * out + std::sin(angle) * Vec3::UnitZ());
  const Vec3 joint = point + 0.01443 * out - 0.025 * along;
  // The parallelogram's bars of length b lean by the sideways distance; the links d and e stay in the arm's plane.
  const Vec3 between = joint - armEnd;
  const double sideways = between.dot(along);
  const double inPlane = (between - sideways * along).norm();
  return std::hypot(inPlane - 0.0225, sideways) - 0.1025;
}

}  // namespace

class FalconKinematicsTest : public QObject {
  Q_OBJECT

 private slots:
  void knownPoints_data() {
    QTest::addColumn<Counts>("counts");
    QTest::addColumn<Vec3>("point");
    const auto row = [](int a, int b, int c, double x, double y, double z) {
      QTest::addRow("%d, %d, %d", a, b, c) << Counts{a, b, c} << Vec3(x, y, z);
    };
    row(0, 0, 0, 0, 0, 0.134602);
    row(500, 500, 500, 0, 0, 0.156860);
    row(-500, -500, -500, 0, 0, 0.110754);
    row(900, 900, 900, 0, 0, 0.170842);
    row(-900, -900, -900, 0, 0, 0.093449);
    row(300, 0, 0, 0.003878, -0.012882, 0.138494);
    row(0, 300, 0, -0.013095, 0.003083, 0.138494);
    row(0, 0, 300, 0.009217, 0.009799, 0.138494);
    row(400, -200, 100, 0.015775, -0.016182, 0.136953);
  }

  void knownPoints() {
    QFETCH(Counts, counts);
    QFETCH(Vec3, point);
    const double miss = (pointOf(counts) - point).cwiseAbs().maxCoeff();
    QVERIFY2(miss < 1e-6, qPrintable(QString::number(miss)));
  }

  void homeHasTheKnownGradient() {
    Eigen::Matrix3d expected;
    expected << 2.8802, -9.5483, 13.3663, -9.7092, 2.2798, 13.3663, 6.8290, 7.2685, 13.3663;
    QVERIFY((jacobian(pointOf({})) - expected).cwiseAbs().maxCoeff() < 1e-4);
  }

  // By an independent method: each leg, built up in space from shaft to grip, has its length.
  void everyLegCloses() {
    const bool ok = rc::check([] {
      const Vec3 point = anyPoint();
      const std::optional<Angles> angles = inverse(point);
      RC_ASSERT(angles.has_value());
      constexpr double kDegree = 0.017453292519943295;
      RC_ASSERT(std::abs(loopGap(point, (*angles)[0], 105 * kDegree)) < 1e-12);
      RC_ASSERT(std::abs(loopGap(point, (*angles)[1], -15 * kDegree)) < 1e-12);
      RC_ASSERT(std::abs(loopGap(point, (*angles)[2], -135 * kDegree)) < 1e-12);
    });
    QVERIFY(ok);
  }

  void forwardUndoesInverse() {
    const bool ok = rc::check([] {
      const Vec3 point = anyPoint();
      const std::optional<Vec3> back = forward(*inverse(point), kHome);
      RC_ASSERT(back.has_value());
      RC_ASSERT((*back - point).norm() < 1e-9);
    });
    QVERIFY(ok);
  }

  void theGradientIsThatOfTheAngles() {
    const bool ok = rc::check([] {
      const Vec3 point = anyPoint();
      const Eigen::Matrix3d rows = jacobian(point);
      constexpr double kStep = 1e-6;
      for (int axis = 0; axis < 3; ++axis) {
        const Angles more = *inverse(point + kStep * Vec3::Unit(axis));
        const Angles less = *inverse(point - kStep * Vec3::Unit(axis));
        for (int leg = 0; leg < 3; ++leg) {
          const double slope = (more[leg] - less[leg]) / (2.0 * kStep);
          RC_ASSERT(std::abs(slope - rows(leg, axis)) < 1e-5 * (1.0 + std::abs(slope)));
        }
      }
    });
    QVERIFY(ok);
  }

  // Virtual work: the work of the motors along any small move is that of the force.
  void torquesDoTheWorkOfTheForce() {
    QVERIFY((torques(Vec3::UnitZ(), pointOf({})) - Vec3::Constant(0.024938)).cwiseAbs().maxCoeff() < 1e-6);
    QCOMPARE(torqueCounts(torques(Vec3::UnitZ(), pointOf({}))), (Counts{-249, -249, -249}));
    const bool ok = rc::check([](const std::array<std::int8_t, 3>& f, const std::array<std::int8_t, 3>& m) {
      const Vec3 point = anyPoint();
      const Vec3 force(f[0], f[1], f[2]), move(m[0], m[1], m[2]);
      const double work = torques(force, point).dot(jacobian(point) * move);
      RC_ASSERT(std::abs(work - force.dot(move)) < 1e-8 * (1.0 + force.norm() * move.norm()));
    });
    QVERIFY(ok);
  }

  void saturationKeepsTheDirection() {
    const bool ok = rc::check([](const std::array<std::int32_t, 3>& t) {
      const Vec3 torque = 1e-4 * Vec3(t[0], t[1], t[2]);
      const Counts counts = torqueCounts(torque);
      const Vec3 sent(counts[0], counts[1], counts[2]);
      RC_ASSERT(sent.cwiseAbs().maxCoeff() <= kMostTorque);
      const double wanted = (kCountsPerTorque * torque).cwiseAbs().maxCoeff();
      const double scale = wanted > kMostTorque ? kMostTorque / wanted : 1.0;
      RC_ASSERT((sent - scale * kCountsPerTorque * torque).cwiseAbs().maxCoeff() <= 0.5 + 1e-9);
    });
    QVERIFY(ok);
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
      QCOMPARE(torqueCounts(Vec3(1.0, bad, 1.0)), Counts{});
    }
  }

  void outOfReachIsNothing() {
    QVERIFY(!inverse(Vec3(0, 0, 1)));
    QVERIFY(!inverse(Vec3(0.5, 0, 0.1)));
    QVERIFY(!inverse(Vec3(0, 0, std::nan(""))));
    QVERIFY(!forward({std::nan(""), 0.0, 0.0}, kHome));
    for (const Counts& counts : {Counts{32767, -32768, 32767}, Counts{32767, 32767, 32767}, Counts{-32768, 0, 0}}) {
      const std::optional<Vec3> point = forward(anglesOf(counts), kHome);
      QVERIFY(!point || point->allFinite());
    }
  }
};

HANDWHEEL_TEST(FalconKinematicsTest)
#include "FalconKinematicsTest.moc"
