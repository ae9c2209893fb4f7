// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LatheFixture.h"
#include "TestClass.h"
#include "simulation/clay/ClayForce.h"
#include "simulation/turning/LatheForce.h"
#include "simulation/turning/TurningForce.h"
#include "volume/VolumeShapes.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Returns the force on a hand that has moved to a position.
Vec3 feltAt(ForceSource& force, const Vec3& position, bool isRestart = false) {
  TipState tip;
  tip.position = position;
  tip.isRestart = isRestart;
  ForceOut out;
  force.advance(tip, out);
  return force.force(tip, 1.0, 1.0);
}

// Clay of the radius 10 mm around the origin.
std::shared_ptr<ClayChannel> channelWithBall() {
  const auto channel = std::make_shared<ClayChannel>();
  auto state = std::make_shared<ClayState>();
  state->volume = ballOfVoxels(10.0, 0.1);
  channel->patch.write({std::move(state)});
  return channel;
}

constexpr StockCylinder kHandedBar{40.0, 100.0, 0.0};
constexpr double kRoundNose = 2.0;

std::shared_ptr<TurningChannel> channelWithBar() {
  const auto channel = std::make_shared<TurningChannel>();
  channel->patch.write(patchAround(TurnedProfile(kHandedBar, 0.1), 50.0, kRoundNose, TurningSide::Outside));
  return channel;
}

}  // namespace

// A scene that changes while a hand presses on something: the new source of force continues from the state of the old
// one, if it feels the same thing. Otherwise the hand, which is in the material, would lose its resistance.
class ForceHandoverTest : public QObject {
  Q_OBJECT

 private slots:
  // A millimetre below the surface of the clay, with a spring of twice the stiffness: 1 N instead of 0.5 N.
  void aSettingChangesInTheClay() {
    const auto channel = channelWithBall();
    ClayForce before(channel, {});
    for (int i = 0; i <= 200; ++i) feltAt(before, {0.0, 0.0, 11.0 - 0.01 * i}, i == 0);
    const Vec3 within(0.0, 0.0, 9.0);
    QVERIFY((feltAt(before, within) - Vec3(0.0, 0.0, 0.5)).norm() < 0.02);
    ClayFeel stiffer;
    stiffer.stiffness = 1.0;
    ClayForce after(channel, stiffer);
    after.follow(before);
    QVERIFY((feltAt(after, within) - Vec3(0.0, 0.0, 1.0)).norm() < 0.04);
    ClayForce unrelated(channel, stiffer);  // comes from nowhere
    QVERIFY(feltAt(unrelated, within).isZero());
  }

  // Another volume, another point of the tool, or another source: where that is it has not come to by moving.
  void whatFeelsSomethingElseBeginsAnew() {
    const auto channel = channelWithBall();
    ClayForce before(channel, {});
    for (int i = 0; i <= 200; ++i) feltAt(before, {0.0, 0.0, 11.0 - 0.01 * i}, i == 0);
    ClayForce ofOther(channelWithBall(), {});
    ofOther.follow(before);
    QVERIFY(feltAt(ofOther, {0.0, 0.0, 9.0}).isZero());
    ClayFeel longer;
    longer.reach = 2.0;
    ClayForce ofLonger(channel, longer);
    ofLonger.follow(before);
    QVERIFY(feltAt(ofLonger, {0.0, 0.0, 9.0}).isZero());
    TurningForce turning(channelWithBar(), {kRoundNose, 0.5, 0.1}, 0.0);
    ClayForce ofTurning(channel, {});
    ofTurning.follow(turning);
    QVERIFY(feltAt(ofTurning, {0.0, 0.0, 9.0}).isZero());
  }

  // The nose touches the bar of ⌀40 with its middle at 22 mm; a hand at 21 mm is pushed out by Hooke's law.
  void aSettingChangesAtTheBar() {
    const auto channel = channelWithBar();
    TurningForce before(channel, {kRoundNose, 0.5, 0.1}, 0.0);
    const Vec3 outward(std::cos(0.7), std::sin(0.7), 0.0), along(0.0, 0.0, 50.0);
    for (int i = 0; i <= 200; ++i) feltAt(before, (23.0 - 0.01 * i) * outward + along, i == 0);
    const Vec3 within = 21.0 * outward + along;
    QVERIFY((feltAt(before, within) - 0.5 * outward).norm() < 1e-3);
    TurningForce after(channel, {kRoundNose, 1.0, 0.1}, 0.0);
    after.follow(before);
    QVERIFY((feltAt(after, within) - outward).norm() < 2e-3);
    // A bar of its own, or a source of another kind: as if there had been none before.
    const auto elsewhere = channelWithBar();
    TurningForce anew(elsewhere, {kRoundNose, 0.5, 0.1}, 0.0), ofOther(elsewhere, {kRoundNose, 0.5, 0.1}, 0.0);
    ofOther.follow(before);
    const Vec3 felt = feltAt(anew, within);
    QCOMPARE(feltAt(ofOther, within), felt);
    ClayForce clay(channelWithBall(), {});
    TurningForce ofClay(elsewhere, {kRoundNose, 0.5, 0.1}, 0.0);
    ofClay.follow(clay);
    QCOMPARE(feltAt(ofClay, within), felt);
  }

  // A tool for bores counts distances in the opposite direction: the state of one for the outside is useless to it.
  void theOtherSideBeginsAnew() {
    const auto channel = channelWithBar();
    TurningForce before(channel, {kRoundNose, 0.5, 0.1}, 0.0);
    for (int i = 0; i <= 200; ++i) feltAt(before, {23.0 - 0.01 * i, 0.0, 50.0}, i == 0);
    const auto after = [&](bool isFollowing) {
      TurningForce bore(channel, {kRoundNose, 0.5, 0.1, TurningSide::Bore}, 0.0);
      if (isFollowing) bore.follow(before);
      return feltAt(bore, {21.0, 0.0, 50.0});
    };
    QCOMPARE(after(true), after(false));
  }

  // A finger, 0.1 mm in the surface of a part in the lathe.
  void aSettingChangesAtTheLathe() {
    LatheFixture fixture;
    LatheTouch touch;
    touch.plane = 0.0;
    LatheForce before(fixture.channel, fixture.material, touch, kLower);
    const double at = 20.0 + LatheSimulation::kFinger;
    const Vec3 within(at - 0.1, 0.0, 60.0 + kLower);
    for (const double away : {5.0, 5.0, 0.5, 0.5, -0.1, -0.1}) {
      feltAt(before, {at + away, 0.0, 60.0 + kLower}, away == 5.0);
      fixture.loop.runSteps(1);  // the force is that of the simulation in the previous tick
    }
    QVERIFY((feltAt(before, within) - Vec3(0.1 * touch.stiffness, 0.0, 0.0)).norm() < 1e-6);
    LatheTouch stiffer = touch;
    stiffer.stiffness = 2.0;
    LatheForce after(fixture.channel, fixture.material, stiffer, kLower);
    after.follow(before);
    QVERIFY((feltAt(after, within) - Vec3(0.2, 0.0, 0.0)).norm() < 1e-6);
    LatheForce unrelated(fixture.channel, fixture.material, stiffer, kLower);
    QVERIFY(feltAt(unrelated, within).isZero());
    const auto elsewhere = std::make_shared<LatheChannel>();
    elsewhere->patch.write(fixture.channel->patch.read());
    LatheForce ofOther(elsewhere, fixture.material, stiffer, kLower);
    ofOther.follow(before);
    QVERIFY(feltAt(ofOther, within).isZero());
  }
};

HANDWHEEL_TEST(ForceHandoverTest)
#include "ForceHandoverTest.moc"
