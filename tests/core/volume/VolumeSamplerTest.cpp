// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeSampler.h"

#include "TestClass.h"
#include "volume/VolumeShapes.h"

#include <rapidcheck.h>

#include <QtTest>
#include <limits>

using namespace handwheel;

class VolumeSamplerTest : public QObject {
  Q_OBJECT

 private slots:
  // Cached samples equal those of the volume, in any order.
  void samplesOfTheVolume() {
    const SparseVolume ball = ballOfVoxels(5.0, 0.3);
    QVERIFY(rc::check([&] {
      const VolumeSampler sampler(ball);
      for (int i = 0; i < 50; ++i) {
        const auto any = [] { return *rc::gen::inRange(-25, 25); };
        const int x = any(), y = any(), z = any();
        RC_ASSERT(sampler.sample({x, y, z}) == ball.sample({x, y, z}));
      }
    }));
  }

  void depthAndNormalOfABall() {
    const SparseVolume ball = ballOfVoxels(5.0, 0.1);
    const VolumeSampler sampler(ball);
    for (int i = 0; i < 200; ++i) {
      const Vec3 outwards = Vec3(std::sin(i), std::cos(3.0 * i), std::sin(2.0 * i + 1.0)).normalized();
      const double radius = 5.0 + 0.2 * std::sin(5.0 * i);
      const VolumeSampler::Depth found = sampler.depthAt(radius * outwards);
      QVERIFY(std::abs(found.depth - (5.0 - radius)) < 1e-3);
      QVERIFY((found.gradient + outwards).norm() < 0.05);
      QVERIFY((sampler.normalAt(radius * outwards) - outwards).norm() < 0.01);
    }
    QVERIFY(sampler.normalAt(Vec3::Zero()).isZero());
  }

  // Hits of rays on a ball are compared with exact ones.
  void raysMeetABall() {
    const SparseVolume ball = ballOfVoxels(5.0, 0.1);
    QVERIFY(rc::check([&] {
      const auto number = [](double most) { return *rc::gen::inRange(-1000, 1001) / 1000.0 * most; };
      const Vec3 through(number(6.0), number(6.0), number(6.0)),
          direction(number(1.0), number(1.0), number(1.0) + 0.001);
      const Vec3 origin = through - 40.0 / direction.norm() * direction;
      const auto hit = firstHit(ball, origin, direction);
      const double along = -origin.dot(direction) / direction.squaredNorm(), miss = (origin + along * direction).norm();
      if (miss > 5.01) RC_ASSERT(!hit);
      if (miss > 4.95) return;
      RC_ASSERT(hit.has_value());
      const double exact = along - std::sqrt(25.0 - miss * miss) / direction.norm();
      RC_ASSERT(std::abs(hit->distance - exact) * direction.norm() < 0.02);
      RC_ASSERT((hit->normal - hit->point.normalized()).norm() < 0.02);
    }));
  }

  void raysThatMeetNothing() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const SparseVolume ball = ballOfVoxels(5.0, 0.1);
    QVERIFY(!firstHit(SparseVolume(), Vec3::Zero(), Vec3::UnitX()));
    QVERIFY(!firstHit(ball, {10.0, 0.0, 0.0}, Vec3::UnitX()));
    QVERIFY(!firstHit(ball, Vec3::Zero(), Vec3::UnitX()));  // from within
    QVERIFY(!firstHit(ball, {nan, 0.0, 0.0}, Vec3::UnitX()));
    QVERIFY(!firstHit(ball, {10.0, 0.0, 0.0}, Vec3::Zero()));
    QVERIFY(VolumeSampler(ball).depthAt({nan, 0.0, 0.0}).depth < 0.0);
    QVERIFY(VolumeSampler(ball).depthAt({1e300, 0.0, 0.0}).depth < 0.0);
  }
};

HANDWHEEL_TEST(VolumeSamplerTest)
#include "VolumeSamplerTest.moc"
