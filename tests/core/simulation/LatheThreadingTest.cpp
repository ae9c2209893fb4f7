// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LatheFixture.h"
#include "TestClass.h"
#include "simulation/turning/LatheForce.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kLeadOfNut = 1.5;  // mm: a part of the pitch of the lead screw, which finds the same thread again
constexpr double kThreadSpeed = 200.0;

// A rod of ⌀40 with the threading tool in the post, and the spindle at 200 r/min.
struct ThreadingFixture : LatheFixture {
  explicit ThreadingFixture(double power = 0.0) {
    setup.stations[0].tool = "threading-60";
    setup.spindle.power = power;
    setup.spindle.torque = 0.0;
    loop.replace(make());
    send(LatheDo::Spindle, 1.0);
    send(LatheDo::Speed, kThreadSpeed);
    run(1.0);
  }
  void goTo(double r, double z) {
    send(LatheDo::MoveTip, r, z);
    run(2.0);
    send(LatheDo::Release, 0.0);
  }
  // Along the lead screw from before the end of the rod, and out of the groove.
  void thread(double depth, double seconds = 1.6) {
    goTo(25.0, 104.0);
    goTo(20.0 - depth, 104.0);
    send(LatheDo::HalfNut, -kLeadOfNut);
    run(seconds);
    send(LatheDo::Turn, 5.0, 0.0, LatheAxis::Cross);
    run(0.2);
    send(LatheDo::HalfNut, 0.0);
    run(0.1);
  }
  std::unique_ptr<Simulation> finished() {
    auto taken = loop.take();
    static_cast<LatheSimulation&>(*taken).finish();
    return taken;
  }
};

// Distance from the middle of one groove to that of the other, less the grooves between them; mm.
double betweenGrooves(const ThreadCut& a, const ThreadCut& b) {
  const double apart = a.offset - b.offset;
  return apart - a.pitch * std::round(apart / a.pitch);
}

}  // namespace

// A thread by the half-nut in the simulation: its record, and its display while it is cut.
class LatheThreadingTest : public QObject {
  Q_OBJECT

 private slots:
  // Each time that the tool follows the screw is a pass, on the helix of the one before. The profile stays: the groove
  // is in it.
  void eachRunIsAPass() {
    ThreadingFixture fixture;
    fixture.thread(0.5);
    fixture.thread(0.8);
    const auto taken = fixture.finished();
    const auto& lathe = static_cast<const LatheSimulation&>(*taken);
    const auto& last = static_cast<const LatheMoment&>(*lathe.state());
    QVERIFY(last.collisions->empty() && last.isCut && last.profile == fixture.rod);
    QCOMPARE(lathe.passes().size(), std::size_t{2});
    for (const TurningPass& pass : lathe.passes()) {
      QVERIFY(pass.thread && pass.thread->pitch == kLeadOfNut && !pass.thread->isLeft);
      QVERIFY(std::abs(betweenGrooves(*pass.thread, *lathe.passes().front().thread)) < 1e-6);
      QVERIFY(pass.times.size() == pass.path.size() && pass.speeds.size() == pass.path.size());
    }
  }

  // The part shows its groove while it is cut, as deep as the tool stands; and as the passes leave it in the end.
  void theGrooveIsShown() {
    ThreadingFixture fixture;
    const auto deepestShown = [](const LatheMoment& moment) {
      double least = 20.0;
      for (const auto& block : moment.surface.blocks())
        for (const Vec3& p : block->points)
          if (p.z() > 92.0 && p.z() < 98.0) least = std::min(least, std::hypot(p.x(), p.y()));
      return least;
    };
    QCOMPARE(deepestShown(fixture.moment()), 20.0);
    fixture.thread(0.5, 4.0);
    QVERIFY(std::abs(deepestShown(fixture.moment()) - 19.5) < 0.02);
    fixture.thread(0.8, 4.0);
    const auto taken = fixture.finished();
    const auto& lathe = static_cast<const LatheSimulation&>(*taken);
    const auto& last = static_cast<const LatheMoment&>(*lathe.state());
    QVERIFY(std::abs(deepestShown(last) - 19.2) < 0.02);
    std::shared_ptr<const PartThreads> byPasses;
    for (const TurningPass& pass : lathe.passes()) byPasses = PartThreads::with(byPasses, pass);
    QVERIFY(last.surface.threads());
    for (double z = 90.0; z < 97.0; z += 0.1)
      QVERIFY(std::abs(last.surface.threads()->radius(TurningSide::Outside, 20.0, 0.0, z, 1.0) -
                       byPasses->radius(TurningSide::Outside, 20.0, 0.0, z, 1.0)) < 1e-3);
  }

  // It is shown at 25 Hz at most, and whole where the work ends in the middle of a cut.
  void theGrooveIsShownInTheMiddleOfACut() {
    ThreadingFixture fixture;
    fixture.goTo(25.0, 104.0);
    fixture.goTo(19.5, 104.0);
    fixture.send(LatheDo::HalfNut, -kLeadOfNut);
    fixture.run(1.5);
    int shown = 0;
    std::shared_ptr<const PartThreads> before = fixture.moment().surface.threads();
    for (int i = 0; i < 1000; ++i) {
      fixture.run(0.001);
      const auto now = fixture.moment().surface.threads();
      shown += now != before;
      before = now;
    }
    QVERIFY2(shown >= 20 && shown <= 25, QByteArray::number(shown));
    fixture.run(0.013);  // since it was shown last
    const auto taken = fixture.finished();
    const auto& lathe = static_cast<const LatheSimulation&>(*taken);
    const auto& threads = static_cast<const LatheMoment&>(*lathe.state()).surface.threads();
    const auto byPasses = PartThreads::with(nullptr, lathe.passes().back());
    const double end = lathe.passes().back().path.back().y();
    QVERIFY(end < 96.0);
    for (double z = end - 1.0; z < end + 3.0; z += 0.05)
      QVERIFY(std::abs(threads->radius(TurningSide::Outside, 20.0, 0.0, z, 1.0) -
                       byPasses->radius(TurningSide::Outside, 20.0, 0.0, z, 1.0)) < 1e-3);
  }

  // With 0.3 kW the groove slows the spindle down: the straight run tells both speeds, as long as its points.
  void aSlowedThreadSaysWhatWasAskedFor() {
    ThreadingFixture fixture(0.3);
    fixture.thread(0.8, 3.0);
    const auto taken = fixture.finished();
    const auto& passes = static_cast<const LatheSimulation&>(*taken).passes();
    QCOMPARE(passes.size(), std::size_t{1});
    const TurningPass& pass = passes.front();
    QCOMPARE(pass.askedSpeeds.size(), pass.path.size());
    QCOMPARE(pass.speeds.size(), pass.path.size());
    const auto slowest = std::min_element(pass.speeds.begin(), pass.speeds.end());
    QVERIFY(*slowest > 30.0 && *slowest < 0.9 * kThreadSpeed);
    QCOMPARE(pass.askedSpeeds[static_cast<std::size_t>(slowest - pass.speeds.begin())], kThreadSpeed);
  }

  // A hand that lets the button go stops the slides, which it has commanded to go further.
  void aHandLetsGo() {
    LatheFixture fixture;
    fixture.loop.setGesture(1);
    fixture.channel->inputs->setDeviceGesture(1);
    LatheForce force(fixture.channel, fixture.material, {}, kLower);
    const ProfilePoint from = fixture.moment().tip;
    const auto tick = [&](double along, bool isHeld) {
      TipState tip;
      tip.position = Vec3(from.x(), 0.0, from.y() + along + kLower);
      tip.buttons = isHeld ? 1u : 0u;
      tip.isRestart = false;
      ForceOut out;
      force.advance(tip, out);
      fixture.loop.runSteps(1);
    };
    tick(0.0, false);
    tick(0.0, true);
    for (int i = 0; i < 100; ++i) tick(100.0, true);
    tick(100.0, false);
    fixture.run(2.0);
    const double travel = fixture.moment().tip.y() - from.y(), most = 0.101 * fixture.setup.handSpeed;
    QVERIFY2(travel > 1.0 && travel <= most + 1e-9, qPrintable(QString::number(travel)));
    QVERIFY(fixture.moment().machine.demands == (std::array<double, kLatheAxes>{}));
  }
};

HANDWHEEL_TEST(LatheThreadingTest)
#include "LatheThreadingTest.moc"
