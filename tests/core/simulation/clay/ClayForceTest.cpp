// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/clay/ClayForce.h"

#include "TestClass.h"
#include "volume/VolumeSampler.h"
#include "volume/VolumeShapes.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr double kFineVoxel = 0.1, kRadius = 10.0;  // mm

struct ClayFixture {
  std::shared_ptr<ClayChannel> channel = std::make_shared<ClayChannel>();
  ClayFeel feel;
  std::unique_ptr<ClayForce> force;
  ForceOut out;
  double time = 0.0;

  explicit ClayFixture(const ClayFeel& of = {}) : feel(of), force(std::make_unique<ClayForce>(channel, of)) {
    auto state = std::make_shared<ClayState>();
    state->volume = ballOfVoxels(kRadius, kFineVoxel);
    show(state);
  }
  void show(std::shared_ptr<const ClayState> state) { channel->patch.write({std::move(state)}); }
  Vec3 tick(const Vec3& hand, bool isHeld = false) {
    TipState tip;
    tip.position = hand;
    tip.isRestart = time == 0.0;
    tip.time = time += 0.001;
    tip.buttons = isHeld ? 1u : 0u;
    out = {};
    const ForceBounds bounds = force->advance(tip, out);
    const Vec3 felt = force->force(tip, 1.0, 1.0);
    if (!felt.isZero() && !(felt.norm() <= bounds.stiffness * (out.proxy - hand).norm() + 1e-9))
      qFatal("more than its bounds");
    return felt;
  }
};

}  // namespace

class ClayForceTest : public QObject {
  Q_OBJECT

 private slots:
  // The tool stays on the ball where the hand is nearest to it, and pulls by Hooke's law.
  void aBallIsFelt() {
    ClayFixture fixture;
    for (int i = 0; i <= 2000; ++i) {
      // In through the top, then around inside of the surface.
      const double angle = i < 500 ? 0.0 : (i - 500) * 0.001, radius = i < 500 ? 11.0 - i * 0.003 : 9.5;
      const Vec3 hand = radius * Vec3(std::sin(angle), 0.0, std::cos(angle));
      const Vec3 felt = fixture.tick(hand);
      if (radius > kRadius + 0.2 * kFineVoxel) QVERIFY(felt.isZero());
      if (radius > kRadius - kFineVoxel) continue;
      const Vec3 exact = fixture.feel.stiffness * (kRadius - radius) * hand.normalized();
      QVERIFY2((felt - exact).norm() < 0.03 * exact.norm() + 0.002, qPrintable(QString::number((felt - exact).norm())));
    }
  }

  // The pressure is the force divided by the full force, up to 1; beside the ball there is none to derive it from.
  void pressureIsTheForce() {
    ClayFixture fixture;
    for (int i = 0; i <= 600; ++i) {
      const double z = 11.0 - 0.01 * i;  // to 5 mm below the surface: 2.5 N
      const double force = fixture.tick({0.0, 0.0, z}).norm();
      SimulationInput input;
      QVERIFY(fixture.channel->inputs->pop(input));
      if (z > kRadius + 0.2 * kFineVoxel) QCOMPARE(input.pressure, 1.0);
      if (z > kRadius - kFineVoxel) continue;
      QVERIFY(std::abs(input.pressure - std::min(1.0, force / ClayForce::kFullForce)) < 1e-9);
      QVERIFY(std::abs(input.pressure - std::min(1.0, 0.5 * (kRadius - z) / 2.0)) < 0.01);
    }
  }

  // However fast, it does not get in: a hand that goes through the ball at 2 m/s is held on the side it came from.
  void aFastHand() {
    ClayFixture fixture;
    for (int i = 0; i <= 9; ++i) {
      const Vec3 hand(0.3, 0.2, 12.0 - 2.0 * i);
      fixture.tick(hand);
      if (fixture.out.isContact) QVERIFY(fixture.out.proxy.norm() > kRadius - 0.2 * kFineVoxel);
    }
    QVERIFY(fixture.out.isContact);
    QVERIFY(fixture.out.proxy.z() > 0.0);
  }

  // F = resistance · speed while it cuts: at rest within, the tool comes to the hand with the time constant R / K.
  void cuttingIsViscous() {
    ClayFeel feel;
    feel.isCutting = true;
    feel.resistance = 0.1;
    ClayFixture fixture(feel);
    fixture.channel->inputs->setDeviceGesture(1);
    fixture.tick({0.0, 0.0, 11.0}, true);
    double force = 0.0;
    for (int i = 0; i < 2000; ++i) force = fixture.tick({0.0, 0.0, 11.0 - 0.005 * i}, true).norm();  // 5 mm/s
    QVERIFY2(std::abs(force - 5.0 * feel.resistance) < 0.02 * force, qPrintable(QString::number(force)));
  }

  // A drill's force swings once a turn by a twentieth of the spring, never above it, and its mean is that of the
  // resistance; at rest beside the hole it does not swing.
  void vibrationOfADrill() {
    ClayFeel feel;
    feel.isCutting = true;
    feel.resistance = 0.5;
    struct Felt {
      std::vector<double> forces, shares;  // N; of the spring
      bool operator==(const Felt&) const = default;
    };
    const auto feltAt = [&](double spindle, bool isHeld) {
      feel.spindle = spindle;
      ClayFixture fixture(feel);
      if (isHeld) fixture.channel->inputs->setDeviceGesture(1);
      fixture.tick({0.0, 0.0, 11.0}, isHeld);
      Felt felt;
      for (int i = 0; i < 3000; ++i) {
        const Vec3 hand(0.0, 0.0, 11.0 - 0.002 * i);
        felt.forces.push_back(fixture.tick(hand, isHeld).norm());
        const double spring = feel.stiffness * (fixture.out.proxy - hand).norm();
        felt.shares.push_back(fixture.out.isContact && spring > 0.0 ? felt.forces.back() / spring : 1.0);
      }
      return felt;
    };
    const Felt turning = feltAt(3000.0, true);
    int swings = 0;  // down through the middle, in the last second
    double least = 1.0, most = 0.0, before = 0.0, mean = 0.0;
    for (std::size_t i = 2000; i < 3000; ++i) {
      const double share = turning.shares[i];
      mean += 1e-3 * turning.forces[i];
      least = std::min(least, share);
      most = std::max(most, share);
      swings += before > 0.975 && share <= 0.975;
      before = share;
    }
    QVERIFY2(most <= 1.0 + 1e-9 && most > 0.999, qPrintable(QString::number(most)));
    QVERIFY2(std::abs(least - 0.95) < 1e-3, qPrintable(QString::number(least)));
    QVERIFY2(swings >= 49 && swings <= 51, qPrintable(QString::number(swings)));  // 50 turns in a second
    // At 2 mm/s from the surface on, F = R v (1 - exp(-k t / R)), with the mean k of the spring; from 1.5 s to 2.5 s.
    const double rate = 0.975 * feel.stiffness / feel.resistance;
    const double exact = 2.0 * feel.resistance * (1.0 - (std::exp(-1.5 * rate) - std::exp(-2.5 * rate)) / rate);
    QVERIFY2(std::abs(mean / exact - 1.0) < 0.005, qPrintable(QString::number(mean / exact)));
    QVERIFY(feltAt(0.0, false) == feltAt(3000.0, false));
  }

  // Material that comes around a hand does not push it; it is felt when the hand has been outside.
  void clayThatComesBack() {
    ClayFixture fixture;
    auto nothing = std::make_shared<ClayState>();
    const auto ball = fixture.channel->patch.read();
    fixture.show(nothing);
    const Vec3 within(0.0, 0.0, 9.0);
    QVERIFY(fixture.tick(within).isZero());
    fixture.show(ball.state);
    for (int i = 0; i < 100; ++i) QVERIFY(fixture.tick(within).isZero());
    QVERIFY(fixture.tick({0.0, 0.0, 10.5}).isZero());
    QVERIFY(fixture.tick({0.0, 0.0, 9.8}).norm() > 0.05);
  }

  void invalidPositions() {
    ClayFixture fixture;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(fixture.tick({nan, 0.0, 0.0}).isZero());
    QVERIFY(fixture.tick({1e300, 0.0, 0.0}).isZero());
    QVERIFY(fixture.tick({0.0, 0.0, 11.0}).isZero());
    QVERIFY(fixture.tick({0.0, 0.0, 9.5}).allFinite());
  }
};

HANDWHEEL_TEST(ClayForceTest)
#include "ClayForceTest.moc"
