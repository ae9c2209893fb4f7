// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/turning/LatheSimulation.h"

#include "LatheFixture.h"
#include "TestClass.h"
#include "haptics/scene/SceneForces.h"
#include "simulation/turning/LatheForce.h"

#include <QtTest>
#include <algorithm>
#include <chrono>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

class LatheSimulationTest : public QObject {
  Q_OBJECT

 private slots:
  // The part after the live run, after its passes, and after the same commands at another lathe is the same, bit for
  // bit.
  void repeatedBitForBit() {
    LatheFixture fixture, other;
    const auto taken = fixture.workWithTwoTools(), again = other.workWithTwoTools();
    const auto& lathe = static_cast<const LatheSimulation&>(*taken);
    const auto& last = static_cast<const LatheMoment&>(*lathe.state());
    QVERIFY(last.isCut && last.collisions->empty());
    QVERIFY(last.profile == lathe.run().profile());
    QCOMPARE(lathe.passes().size(), std::size_t{2});
    TurnedProfile byPasses = fixture.rod;
    for (const TurningPass& pass : lathe.passes()) {
      QVERIFY(pass.path.size() == pass.times.size() && std::is_sorted(pass.times.begin(), pass.times.end()));
      cut(byPasses, pass);
    }
    QVERIFY(byPasses == last.profile);
    const LatheRun& same = static_cast<const LatheSimulation&>(*again).run();
    QVERIFY(same.profile() == last.profile);
    QVERIFY(same.machine().state() == lathe.run().machine().state());
    // The volume that was counted is that of the parts.
    QVERIFY(std::abs((fixture.rod.volume() - last.profile.volume()) / last.removed - 1.0) < 0.005);
  }

  // 2400 N on an arm of 18.5 mm take 2.8 kW at 600 r/min: with 1 kW the spindle slows down, and the pass has the set
  // speed. A motor that holds its speed gives no such record.
  void whatASlowedSpindleWasAskedFor() {
    for (const double power : {1.0, 0.0}) {
      LatheFixture fixture;
      LatheSetup setup = fixture.setup;
      for (LatheSlot& slot : setup.stations) slot.position = slot.offset = {0.0, 0.0};
      setup.spindle.power = power;
      setup.spindle.torque = 0.0;
      const auto channel = std::make_shared<LatheChannel>();
      LatheSimulation lathe(
          LatheRun(setup, fixture.tools, fixture.rod, LatheMachine::initialState(setup, kRod), fixture.material),
          TurnedSurface(fixture.rod, 0.05), kLower, channel, SurfaceFinish(fixture.rod.size()));
      const auto after = [&](double seconds, LatheCommand command) {
        channel->commands.push(command);
        for (int i = 0; i < static_cast<int>(std::lround(1000.0 * seconds)); ++i) lathe.step(0.001, {});
      };
      after(1.0, {LatheDo::Spindle, LatheAxis::Carriage, 1.0});
      after(2.0, {LatheDo::MoveTip, LatheAxis::Carriage, 17.0, 102.0});
      after(6.0, {LatheDo::Feed, LatheAxis::Carriage, -0.4});
      QCOMPARE(lathe.passes().size(), std::size_t{1});
      const TurningPass& pass = lathe.passes().front();
      QCOMPARE(pass.askedSpeeds.empty(), power == 0.0);
      if (power == 0.0) continue;
      QVERIFY(pass.askedSpeeds.size() == pass.path.size() && pass.speeds.size() == pass.path.size());
      QVERIFY(pass.speeds.back() < 300.0 && pass.askedSpeeds.back() == 600.0);
      for (std::size_t i = 0; i < pass.path.size(); ++i) QVERIFY(pass.askedSpeeds[i] >= pass.speeds[i]);
    }
  }

  void saysWhatIsCut() {
    LatheFixture fixture;
    fixture.turnDown();
    const LatheMoment& now = fixture.moment();
    const LatheLoad& load = now.load;
    QVERIFY(load.isCutting);
    QVERIFY(std::abs(load.cut.depth - 2.0) < 0.2);
    QVERIFY(std::abs(load.cut.feed - 0.2) < 1e-3);
    QVERIFY(std::abs(load.cut.speed - M_PI * 38.0 * 0.6) < 0.5);  // at the mean diameter
    // 2000 N/mm² of 0.4 mm², on an arm of 19 mm, at 600 r/min; the drive passes on four fifths.
    QVERIFY(std::abs(load.forces.cutting / 800.0 - 1.0) < 0.1);
    QVERIFY(std::abs(load.torque / (load.forces.cutting * 0.019) - 1.0) < 0.005);
    QVERIFY(std::abs(load.power * 0.8 / (load.torque * 600.0 / 9549.3) - 1.0) < 1e-4);
    QVERIFY(!load.isOverloaded);
    const LathePatch patch = fixture.channel->patch.read();
    QVERIFY(std::abs(patch.velocity.y() + 0.2 * 10.0) < 1e-6);
    fixture.send(LatheDo::Feed, 0.0);
    fixture.run(1.0);
    QVERIFY(!fixture.moment().load.isCutting && fixture.moment().load.forces == CutForces() &&
            fixture.moment().sinceCut > 0.9);
  }

  void crashesAreHandedOver() {
    LatheFixture fixture;
    fixture.send(LatheDo::MoveTip, 19.0, 102.0);
    fixture.run(2.0);
    fixture.send(LatheDo::Turn, -10.0);
    fixture.run(1.0);
    QCOMPARE(fixture.moment().collisions->size(), std::size_t{1});
    QVERIFY(fixture.moment().collisions->front().cause == CrashCause::SpindleAtRest);
    QVERIFY(fixture.moment().profile == fixture.rod);
  }

  // A device takes the tool where it is, 25 mm from the hand here, and moves it by as much as the hand moves; the plane
  // attracts the hand within its reach, without a step at the border.
  void aDeviceHoldsTheTool() {
    LatheFixture fixture;
    LatheTouch touch;
    ForceSources sources;
    sources.push_back(std::make_unique<LatheForce>(fixture.channel, materialWith(PlainLaw()), touch, kLower));
    SceneForces forces(std::move(sources));
    TipState tip;
    const auto tick = [&](const Vec3& position, bool isHeld) {
      tip.position = position;
      tip.buttons = isHeld ? 1u : 0u;
      ForceOut out;
      out.proxy = position;
      forces.tick(tip, out);
      tip.isRestart = false;
      tip.time += kServoTick;
      fixture.loop.runSteps(1);
      return out;
    };
    QVERIFY(std::abs(tick({30, 2.0, 100}, false).force.y() + 0.3 * 2.0) < 1e-9);
    QVERIFY(std::abs(tick({30, -6.0, 100}, false).force.y() - 0.3 * 2.0) < 1e-9);
    QVERIFY(tick({30, 8.1, 100}, false).force.norm() < 1e-12);
    double before = tick({30, -9.0, 100}, false).force.y();
    for (double y = -9.0; y < 9.0; y += 0.01) {
      const double now = tick({30, y, 100}, false).force.y();
      QVERIFY(std::abs(now - before) <= 0.3 * 0.01 + 1e-9);
      before = now;
    }
    fixture.loop.setGesture(1);
    fixture.channel->inputs->setDeviceGesture(1);
    const ProfilePoint start = fixture.channel->patch.read().tip;
    const ProfilePoint grip(15.0, -20.0);
    const auto hand = [&](double r, double z) { return Vec3(r - grip.x(), 0.0, z - grip.y() + kLower); };
    for (int i = 0; i < 10; ++i) QCOMPARE(tick(hand(start.x(), start.y()), true).force.norm(), 0.0);
    QVERIFY(fixture.channel->patch.read().tip == start);
    for (int i = 0; i < 3000; ++i) tick(hand(start.x() - 5.0, start.y() - 10.0), true);
    QVERIFY((fixture.channel->patch.read().tip - (start - ProfilePoint(5.0, 10.0))).norm() < 1e-6);
    // Held back by material, the spring pulls the hand.
    fixture.send(LatheDo::Spindle, 1.0);
    for (int i = 0; i < 500; ++i) tick(hand(30.0, 95.0), true);
    ForceOut out;
    for (int i = 0; i < 150; ++i) out = tick(hand(19.0, 95.0), true);
    QVERIFY(out.isContact);
    QVERIFY(out.force.x() > 0.05);
    QVERIFY(out.force.y() > 0.0);  // the work turns about +z and takes the edge along
    QVERIFY(out.force.allFinite());
    const double nan = std::nan("");
    QVERIFY(tick({nan, 0.0, 90.0}, true).force.allFinite());
    QVERIFY(fixture.moment().tip.allFinite());
  }

  // An abrasive pushes back along the normal, harder the deeper it is pressed, and along the motion of the surface
  // while that turns (He 2008, 5-3, 5-4).
  void whatGrindsPushesBack() {
    LatheFixture fixture;
    LatheSetup setup = fixture.setup;
    setup.stations[0].tool = "disk-100";
    for (LatheSlot& slot : setup.stations) slot.position = slot.offset = {0.0, 0.0};
    fixture.loop.replace(std::make_unique<LatheSimulation>(
        LatheRun(setup, fixture.tools, fixture.rod, LatheMachine::initialState(setup, kRod), nullptr),
        TurnedSurface(fixture.rod, 0.05), kLower, fixture.channel));
    fixture.send(LatheDo::Spindle, 1.0);
    fixture.send(LatheDo::MoveTip, 20.5, 60.0);
    fixture.run(2.0);
    fixture.send(LatheDo::MoveTip, 19.9, 60.0);
    fixture.run(0.1);
    fixture.channel->inputs->setDeviceGesture(1);
    LatheMaterial lawless;
    lawless.laws.assign(fixture.tools.size(), nullptr);
    LatheForce force(fixture.channel, std::make_shared<const LatheMaterial>(lawless), {}, kLower);
    TipState tip;
    tip.isRestart = false;
    tip.buttons = 1u;
    const auto felt = [&] {
      const LathePatch patch = fixture.channel->patch.read();
      tip.position = Vec3(patch.tip.x(), 0.0, patch.tip.y() + kLower);
      ForceOut out;
      force.advance(tip, out);
      return out.isContact ? force.force(tip, 1.0, 1.0) : Vec3(Vec3::Zero());
    };
    const Vec3 deep = felt();
    QVERIFY(deep.x() > 0.0 && deep.y() > 0.0 && std::abs(deep.z()) < 1e-9);
    const LatheLoad& load = fixture.moment().load;
    QVERIFY(std::abs(load.forces.cutting - 0.4 * load.forces.radial) < 1e-9 && load.forces.radial > 1.0);
    QVERIFY(load.torque > 0.0 && load.power > 0.0);
    fixture.run(5.0);  // ground away: less and less is left under it
    QVERIFY(felt().x() < 0.5 * deep.x());
  }

  // The radial force is across the motion of the edge, out of the material: in a bore towards the axis, in facing along
  // it.
  void thePassiveForce_data() {
    QTest::addColumn<QString>("tool");
    QTest::addColumn<ProfilePoint>("beside");
    QTest::addColumn<int>("axis");
    QTest::addColumn<ProfilePoint>("direction");
    QTest::addColumn<ProfilePoint>("passive");
    const ProfilePoint toChuck(0.0, -1.0), in(-1.0, 0.0), none(0.0, 0.0);
    QTest::newRow("outside") << "right-roughing" << ProfilePoint(19.0, 102.0) << 0 << toChuck << ProfilePoint(1, 0);
    QTest::newRow("bore") << "boring-12" << ProfilePoint(11.0, 102.0) << 0 << toChuck << ProfilePoint(-1, 0);
    QTest::newRow("face") << "facing" << ProfilePoint(21.0, 99.0) << 1 << in << ProfilePoint(0, 1);
    QTest::newRow("plunge") << "parting-3" << ProfilePoint(21.0, 60.0) << 1 << in << none;
  }
  void thePassiveForce() {
    QFETCH(QString, tool);
    QFETCH(ProfilePoint, beside);
    QFETCH(int, axis);
    QFETCH(ProfilePoint, direction);
    QFETCH(ProfilePoint, passive);
    LatheFixture fixture;
    LatheSetup setup = fixture.setup;
    setup.stations[0].tool = tool.toStdString();
    for (LatheSlot& slot : setup.stations) slot.position = slot.offset = {0.0, 0.0};
    const std::vector<double> outer(fixture.rod.size(), 20.0), inner(fixture.rod.size(), 10.0);
    const TurnedProfile tube = TurnedProfile::fromRadii(outer, inner, kRod.length);
    fixture.loop.replace(std::make_unique<LatheSimulation>(
        LatheRun(setup, fixture.tools, tube, LatheMachine::initialState(setup, kRod), fixture.material),
        TurnedSurface(tube, 0.05), kLower, fixture.channel));
    fixture.send(LatheDo::Spindle, 1.0);
    if (beside.x() < 20.0) fixture.send(LatheDo::MoveTip, beside.x(), 110.0);
    fixture.run(2.0);
    fixture.send(LatheDo::MoveTip, beside.x(), beside.y());
    fixture.run(2.0);
    fixture.send(LatheDo::Feed, -0.1, 0.0, axis == 1 ? LatheAxis::Cross : LatheAxis::Carriage);
    fixture.run(4.0);  // 40 turns, 4 mm
    QVERIFY(fixture.moment().collisions->empty());
    const LatheLoad load = fixture.moment().load;
    QVERIFY(load.isCutting && load.forces.radial > 10.0);
    QVERIFY((load.passive - passive).norm() < 1e-9);
    fixture.channel->inputs->setDeviceGesture(1);
    LatheTouch touch;
    touch.mostForce = 100.0;
    LatheForce force(fixture.channel, fixture.material, touch, kLower);
    const LathePatch patch = fixture.channel->patch.read();
    TipState tip;
    tip.isRestart = false;
    tip.buttons = 1u;
    tip.position = Vec3(patch.tip.x(), 0.0, patch.tip.y() + kLower);
    ForceOut out;
    force.advance(tip, out);
    const Vec3 felt = force.force(tip, 1.0, 1.0);
    const ProfilePoint expected = load.forces.radial * passive - load.forces.feed * direction;
    QVERIFY2((ProfilePoint(felt.x(), felt.z()) - touch.forceShare * expected).norm() < 1e-3 * touch.forceShare * 100.0,
             qPrintable(QString("%1 %2").arg(felt.x()).arg(felt.z())));
    QVERIFY(felt.y() > 0.0);
  }

  // A free slide resists by friction and drag, against the hand; the work plane has none.
  void slidesResist() {
    LatheFixture fixture;
    fixture.loop.setGesture(1);
    fixture.channel->inputs->setDeviceGesture(1);
    LatheTouch touch;
    LatheForce force(fixture.channel, fixture.material, touch, kLower);
    const ProfilePoint at = fixture.channel->patch.read().tip;
    TipState tip;
    tip.position = Vec3(at.x(), 0.0, at.y() + kLower);
    tip.isRestart = false;
    tip.buttons = 1u;
    for (const double speed : {1.0, 50.0, 400.0, -400.0}) {
      tip.velocity = Vec3(0.0, speed, speed);
      ForceOut out;
      const ForceBounds bounds = force.advance(tip, out);
      const Vec3 felt = force.force(tip, 1.0, 1.0);
      const double slip = std::clamp(speed / touch.feel.creep, -1.0, 1.0);
      const double expected = touch.feel.friction * slip + touch.feel.drag * speed;
      QVERIFY(std::abs(felt.z() + expected) < 1e-12);
      QCOMPARE(felt.y(), 0.0);
      QVERIFY(std::abs(expected) <= bounds.damping * std::abs(speed) + 1e-12);
      QCOMPARE(force.force(tip, 1.0, 0.0).z(), 0.0);
    }
  }

  // A finger that slides over a part at rest feels the crests of its thread, and nothing over its grooves, along the
  // helix; and never more than the envelope pushes it. Of a part that turns it feels the envelope.
  void threadsAreFelt() {
    constexpr double kPitch = 2.5, kIn = 0.1;  // mm: so deep is the finger in the envelope
    LatheFixture fixture;
    TurningPass pass;
    pass.noseRadius = isoMetricNose(kPitch);
    pass.thread = ThreadCut{.pitch = kPitch};
    const double r = 20.0 - isoMetricDepth(kPitch) + pass.noseRadius;
    pass.path = {{r, 90.0}, {r, 30.0}};
    pass.times = {0.0, 10.0};
    fixture.threads = PartThreads::with(nullptr, pass);
    fixture.loop.replace(fixture.make());
    LatheTouch touch;
    touch.plane = 0.0;
    LatheForce force(fixture.channel, fixture.material, touch, kLower);
    TipState tip;
    const auto feel = [&](double distance, double angle, double z) {
      tip.position = Vec3(distance * std::cos(angle), distance * std::sin(angle), z + kLower);
      Vec3 felt = Vec3::Zero();
      for (int i = 0; i < 2; ++i) {  // the force is that of the simulation in the previous tick
        ForceOut out;
        force.advance(tip, out);
        felt = force.force(tip, 1.0, 1.0);
        tip.isRestart = false;
        tip.time += kServoTick;
        fixture.loop.runSteps(1);
      }
      return felt;
    };
    const double at = 20.0 + LatheSimulation::kFinger - kIn, full = touch.stiffness * kIn;
    QCOMPARE(feel(at + 5.0, 0.0, 60.0).norm(), 0.0);
    constexpr double kGroove = 24 * kPitch, kCrest = kGroove + 0.5 * kPitch, kFifth = 0.4 * M_PI;
    QCOMPARE(feel(at, 0.0, kGroove).norm(), 0.0);
    QVERIFY((feel(at, 0.0, kCrest) - Vec3(full, 0.0, 0.0)).norm() < 1e-9);
    QCOMPARE(feel(at, kFifth, kGroove + 0.2 * kPitch).norm(), 0.0);
    const Vec3 outward(std::cos(kFifth), std::sin(kFifth), 0.0);
    QVERIFY((feel(at, kFifth, kCrest + 0.2 * kPitch) - full * outward).norm() < 1e-9);
    double before = feel(at, 0.0, 55.0).x();
    for (double z = 55.0; z < 65.0; z += 0.01) {
      const double now = feel(at, 0.0, z).x();
      QVERIFY(now >= 0.0 && now <= full + 1e-9);
      QVERIFY(std::abs(now - before) <= touch.stiffness * std::sqrt(3.0) * fixture.rod.spacing());  // flanks of 60°
      before = now;
    }
    fixture.send(LatheDo::Spindle, 1.0);
    fixture.run(1.0);
    QVERIFY((feel(at, 0.0, kGroove) - Vec3(full, 0.0, 0.0)).norm() < 1e-9);
  }

  // The bar of the tick with the network that ships: 20 µs, here with room for a slow machine.
  void theTickIsShort() {
    LatheFixture fixture;
    fixture.turnDown();
    fixture.loop.setGesture(1);
    fixture.channel->inputs->setDeviceGesture(1);
    LatheForce force(fixture.channel, materialWith(shippedForceModel()), {}, kLower);
    LathePatch patch = fixture.channel->patch.read();
    patch.cut = {1.0, 0.2, 90.0}, patch.tool = 0, patch.spindleSpeed = 600.0;
    std::vector<double> times;
    double sum = 0.0;
    for (int i = 0; i < 20000; ++i) {
      TipState tip;
      tip.isRestart = i == 0;
      tip.position = Vec3(20.0 + 1e-4 * i, 0.1, 60.0);
      tip.buttons = 1u;
      patch.cut.depth = 0.5 + 1e-5 * i;
      fixture.channel->patch.write(patch);
      SimulationInput taken;
      fixture.channel->inputs->pop(taken);
      const auto begin = std::chrono::steady_clock::now();
      ForceOut out;
      force.advance(tip, out);
      sum += force.force(tip, 1.0, 1.0).norm();
      times.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
    }
    QVERIFY(sum > 0.0 && force.cut().cutting > 0.0);
    std::sort(times.begin(), times.end());
    qInfo("tick while cutting: median %.2f us, p99 %.2f us", times[times.size() / 2], times[times.size() * 99 / 100]);
  }
};

HANDWHEEL_TEST(LatheSimulationTest)
#include "LatheSimulationTest.moc"
