// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/device/VelocityEstimator.h"
#include "haptics/scene/TouchFidelity.h"

#include <rapidcheck.h>
#include <QtTest>
#include <random>

using namespace handwheel;

class VelocityEstimatorTest : public QObject {
  Q_OBJECT

 private slots:
  void constantVelocityIsExactAtAnyTimes() {
    QVERIFY(rc::check("exact", [] {
      const Vec3 velocity(*rc::gen::inRange(-1000, 1000), *rc::gen::inRange(-1000, 1000), 3.0);
      const Vec3 start(*rc::gen::inRange(-500, 500), 0, 0);
      VelocityEstimator estimator(*rc::gen::element(1e-4, 2e-3, 0.01, 10.0));
      double time = 0.0;
      for (int i = 0; i < 300; ++i) {
        const double period = *rc::gen::inRange(1, 4000) * 1e-6;
        time += period;
        const Vec3 estimate = estimator.add(start + time * velocity, period);
        if (i == 0) RC_ASSERT(estimate.isZero(0.0));
        if (i > 0) RC_ASSERT((estimate - velocity).norm() <= 1e-6 * (1.0 + velocity.norm()));
      }
    }));
  }

  // Under constant acceleration the slope is the velocity at the middle of the window.
  void lagsByHalfTheWindow() {
    VelocityEstimator estimator(0.0100001);
    Vec3 estimate;
    double time = 0.0;
    for (int i = 0; i < 100; ++i) {
      time = 0.001 * i;
      estimate = estimator.add({0.5 * 3000.0 * time * time, 0, 0}, 0.001);
    }
    QVERIFY(qAbs(estimate.x() - 3000.0 * (time - 0.005)) < 1e-6);
  }

  // s/T·√(12/(n(n²-1))), the variance of a least-squares slope; n = 11.
  void noiseIsAsLeastSquaresHaveIt() {
    VelocityEstimator estimator(0.0100001);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 0.02);
    double squares = 0.0;
    const int count = 20000;
    for (int i = 0; i < count + 20; ++i) {
      const Vec3 estimate = estimator.add({noise(random), 0, 0}, 0.001);
      if (i >= 20) squares += estimate.x() * estimate.x();
    }
    const double expected = 0.02 / 0.001 * std::sqrt(12.0 / (11.0 * 120.0));
    QVERIFY(qAbs(std::sqrt(squares / count) / expected - 1.0) < 0.1);
  }

  void startsAnew() {
    VelocityEstimator estimator;
    estimator.add({0, 0, 0}, 0.001);
    estimator.reset();
    QVERIFY(estimator.add({100, 0, 0}, 0.001).isZero(0.0));
    QVERIFY(estimator.add({100, 0, 0}, 0.001).isZero(0.0));
  }

  // The longest window that can be set, at the highest rate: the lag is half of it, not less.
  void theLongestWindowIsWhole() {
    FidelityValues longest;
    QVERIFY(longest.set(velocityWindowSetting(), velocityWindowSetting().largest));
    VelocityEstimator estimator(servoSettings(longest).velocityWindow);
    const double period = 1.0 / kLargestServoRate;
    Vec3 estimate;
    double time = 0.0;
    for (int i = 0; i < 2000; ++i) {
      time = period * i;
      estimate = estimator.add({0.5 * 3000.0 * time * time, 0, 0}, period);
    }
    QVERIFY(qAbs(estimate.x() - 3000.0 * (time - 0.5 * velocityWindowSetting().largest)) <= 3000.0 * period);
  }

  // More readings in the window than the buffer has: the newest count, and nothing breaks.
  void aWindowLongerThanTheBuffer() {
    VelocityEstimator estimator(1e9);
    Vec3 estimate;
    for (int i = 0; i < 2000; ++i) estimate = estimator.add({i < 1000 ? 1e3 : 0.002 * i, 0, 0}, 0.001);
    QVERIFY(qAbs(estimate.x() - 2.0) < 1e-9);
  }
};

HANDWHEEL_TEST(VelocityEstimatorTest)
#include "VelocityEstimatorTest.moc"
