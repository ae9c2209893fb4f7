// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/turning/TurningSimulation.h"

#include "SimulationLog.h"
#include "TestClass.h"
#include "haptics/scene/SceneForces.h"
#include "simulation/SimulationLoop.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr StockCylinder kBar{40.0, 100.0, 0.0};
constexpr double kNose = 2.0, kBase = 7.0, kTick = 0.001;

TurningPass blank(TurningSide side = TurningSide::Outside) {
  TurningPass pass;
  pass.noseRadius = kNose;
  pass.side = side;
  return pass;
}

// Servo loop and simulation of a bar whose lower end is at z = 7, in turns on one thread.
struct Lathe {
  TurningTool tool{kNose, 0.5, 0.1};
  std::shared_ptr<TurningChannel> channel = std::make_shared<TurningChannel>();
  VirtualClock clock;
  Service service{"simulation"};
  TurnedProfile bar{kBar, 0.1};
  SimulationLoop loop{std::make_unique<LoggedSimulation>(
                          std::make_unique<TurningSimulation>(bar, TurnedSurface(bar, 0.05), blank(), kBase, channel)),
                      250.0, channel->inputs, clock, service};
  SceneForces forces{sources()};
  TipState tip;
  int perStep = 4;  // ticks

  Lathe() { begin(1); }
  void begin(std::uint32_t gesture) {
    loop.setGesture(gesture);
    channel->inputs->setDeviceGesture(gesture);
  }
  ForceSources sources() {
    channel->patch.write(patchAround(bar, 50.0, kNose, TurningSide::Outside));
    ForceSources all;
    all.push_back(std::make_unique<TurningForce>(channel, tool, kBase));
    return all;
  }
  ForceOut at(const Vec3& position, bool isCutting) {
    tip.velocity = tip.isRestart ? Vec3(Vec3::Zero()) : Vec3((position - tip.position) / kTick);
    tip.position = position;
    tip.buttons = isCutting ? 1u : 0u;
    tip.period = kTick;
    ForceOut out;
    out.proxy = position;
    forces.tick(tip, out);
    tip.isRestart = false;
    tip.time += kTick;
    if (std::lround(tip.time / kTick) % perStep == 0) loop.runSteps(1);
    return out;
  }
  const TurningState& state() { return static_cast<const TurningState&>(*(m_held = loop.state())); }

 private:
  std::shared_ptr<const SimulationState> m_held;
};

}  // namespace

class TurningSimulationTest : public QObject {
  Q_OBJECT

 private slots:
  // The finish is updated while the pass is made, and the repeated pass gives the same, bit for bit.
  void theFinishOfThePass() {
    const TurnedProfile bar(kBar, 0.1);
    auto channel = std::make_shared<TurningChannel>();
    TurningSimulation simulation(bar, TurnedSurface(bar, 0.05), blank(), kBase, channel, TurningPass::kMostPoints,
                                 {SurfaceFinish(bar.size()), 5, 600.0});
    for (int i = 0; i < 2000; ++i) {
      SimulationInput input;
      input.gesture = 1;
      input.tip.time = 0.004 * i;  // s
      input.proxy = Vec3(19.0 + kNose, 0.0, kBase + 105.0 - 0.008 * i);
      simulation.step(0.004, std::span(&input, 1));
    }
    const auto& state = static_cast<const TurningState&>(*simulation.state());
    const FinishMark mark = state.finish.at(TurningSide::Outside, 950);
    QCOMPARE(mark.pass, 5u);
    QVERIFY(std::abs(mark.roughness / (1e3 * 0.04 / (32.0 * kNose)) - 1.0) < 0.01);  // 2 mm/s: 0.2 mm in a turn
    TurnedProfile again = bar;
    FinishMeter meter(bar, SurfaceFinish(bar.size()));
    cut(again, std::make_shared<const TurningPass>(simulation.pass()), 5, meter);
    QVERIFY(again == state.profile);
    QVERIFY(meter.finish() == state.finish);
  }

  // A hand that faces the bar and passes the axis leaves nothing there, wherever it was seen on both sides of it; also
  // with a nose that is nearly a point.
  void facedThroughTheAxis() {
    const TurnedProfile bar(kBar, 0.1);
    for (const double beyond : {0.3, 1.0, 3.0}) {
      TurningPass pointed = blank();
      pointed.noseRadius = TurningPass::kLeastNose;
      TurningSimulation simulation(bar, TurnedSurface(bar, 0.05), pointed, kBase, std::make_shared<TurningChannel>());
      double time = 0.0;
      for (const double x : {22.0, 10.0, 2.0, 1.0, -beyond}) {
        SimulationInput input;
        input.gesture = 1;
        input.tip.time = time += 0.5;
        input.proxy = Vec3(x * std::cos(0.4), x * std::sin(0.4), kBase + 95.0);
        simulation.step(0.004, std::span(&input, 1));
      }
      const auto& state = static_cast<const TurningState&>(*simulation.state());
      const auto faced = static_cast<std::size_t>(std::lround(95.0 / 0.1));  // the sample there
      QVERIFY(std::abs(bar.z(faced) - 95.0) < 1e-9);
      QVERIFY2(state.profile.radius(faced) < 1e-9, QByteArray::number(state.profile.radius(faced)));
      // The repeated pass gives the same.
      TurnedProfile again = bar;
      const TurningPass& pass = simulation.pass();
      QCOMPARE(pass.times.size(), pass.path.size());
      for (std::size_t i = 0; i < pass.path.size(); ++i) cut(again, pass, pass.path[i == 0 ? 0 : i - 1], pass.path[i]);
      QVERIFY(again == state.profile);
    }
  }

  // From any side: nothing beside the bar, k times the depth of the hand against it.
  void anUncutBarIsFelt_data() {
    QTest::addColumn<double>("angle");
    for (double angle : {0.0, 1.0, -2.5}) QTest::addRow("%g", angle) << angle;
  }
  void anUncutBarIsFelt() {
    QFETCH(double, angle);
    const Vec3 outward(std::cos(angle), std::sin(angle), 0.0);
    Lathe lathe;
    const auto at = [&](double r) { return Vec3(r * outward + Vec3(0, 0, 50.0 + kBase)); };
    QVERIFY(lathe.at(at(23.0), false).force.isZero(0.0));
    for (double r = 23.0; r > 20.5; r -= 0.01) lathe.at(at(r), false);
    const ForceOut out = lathe.at(at(20.5), false);  // the nose touches at 22
    QVERIFY(out.isContact);
    QVERIFY((out.force - 0.5 * 1.5 * outward).norm() < 1e-9);
    QVERIFY((out.proxy - at(22.0)).norm() < 1e-9);
    QVERIFY(!lathe.state().isCut);
  }

  // Pressed with a steady force the tool goes in at the speed F / (resistance · width of the chip), which is the whole
  // nose nose once it is in deeper than its radius; also where the loop carries a part
  // of the stiffness only, and the force is less.
  void materialResistsByTheSpeed_data() {
    QTest::addColumn<double>("share");
    for (double share : {1.0, 0.25}) QTest::addRow("%g", share) << share;
  }
  void materialResistsByTheSpeed() {
    QFETCH(double, share);
    Lathe lathe;
    lathe.tip.stiffnessLimit = share * lathe.tool.stiffness;
    lathe.at({22.1, 0, 57.0}, true);
    double tool = 22.0;
    ForceOut out;
    for (int i = 0; i < 12000; ++i) {
      out = lathe.at({tool - 1.0, 0, 57.0}, true);  // a spring of 1 mm: 0.5 N at most
      tool = out.proxy.x();
    }
    const double before = tool;
    for (int i = 0; i < 200; ++i) {
      out = lathe.at({tool - 1.0, 0, 57.0}, true);
      tool = out.proxy.x();
    }
    const double chip =
        2.0 * kNose - 0.5 * lathe.bar.spacing();  // to the last samples below the nose, half a sample on either side
    QVERIFY(std::abs((before - tool) / 0.2 / (share * 0.5 / (0.1 * chip)) - 1.0) < 0.02);
    QVERIFY(std::abs(out.force.x() - share * 0.5) < 0.01);
    QVERIFY(lathe.state().isCut);
    // The remaining material is as deep as the tool went.
    const std::size_t middle = static_cast<std::size_t>(std::lround(50.0 / lathe.bar.spacing()));
    lathe.loop.runSteps(1);
    QVERIFY(std::abs(lathe.state().profile.radius(middle) - (tool - kNose)) < 0.02);
  }

  // The chord of the nose where it goes straight in, the depth where it goes along the bar.
  void theChipHasAWidth() {
    const TurnedProfile bar(kBar, 0.01);
    const ProfilePatch patch = patchAround(bar, 50.0, kNose, TurningSide::Outside);
    for (double depth : {0.1, 0.5, 1.5}) {
      const ProfilePoint in(20.0 + kNose - depth, 50.0);
      const double chord = 2.0 * std::sqrt(2.0 * kNose * depth - depth * depth);
      QVERIFY(std::abs(patch.chipWidth(in, kNose, {-1.0, 0.0}) - chord) < 0.03);
      TurnedProfile turned = bar;
      cut(turned, blank(TurningSide::Outside), in + ProfilePoint(0.0, 60.0), in);
      const ProfilePatch wall = patchAround(turned, 50.0, kNose, TurningSide::Outside);
      QVERIFY(std::abs(wall.chipWidth(in - ProfilePoint(0.0, 0.2), kNose, {0.0, -1.0}) - depth) < 0.05 * depth);
    }
    QCOMPARE(patch.chipWidth({20.0 + kNose, 50.0}, kNose, {-1.0, 0.0}), 0.0);
  }

  // A heavy cut along the bar is felt: with the same force it goes as much more slowly as it is deeper.
  void aHeavyCutGoesSlowly() {
    for (double depth : {0.2, 1.0}) {
      Lathe lathe;
      const double r = 20.0 + kNose - depth;
      double tool = 101.0 + kNose + kBase;
      lathe.at({r, 0, tool}, true);
      const auto push = [&] { tool = lathe.at({r, 0, tool - 1.0}, true).proxy.z(); };  // a spring of 1 mm: 0.5 N
      while (tool > 95.0 + kBase) push();
      const double before = tool;
      for (int i = 0; i < 200; ++i) push();
      const double speed = (before - tool) / 0.2, expected = 0.5 / (0.1 * depth);
      QVERIFY2(std::abs(speed - expected) < 0.1 * expected, QByteArray::number(speed));
    }
  }

  // In a bore of radius 12 that ends at z = 60 above the lower end: free in it, k times the depth towards the axis on
  // its wall, and nothing around the bar.
  void aBoreIsFeltFromTheInside() {
    TurnedProfile part(kBar, 0.1);
    for (std::size_t i = 0; i < part.size(); ++i) part.limitInner(i, part.z(i) > 60.0 ? 12.0 : 0.0);
    const ProfilePatch patch = patchAround(part, 80.0, kNose, TurningSide::Bore);
    const TurningTool boring{kNose, 0.5, 0.1, TurningSide::Bore};
    TurningContact contact;
    contact.reset({-5.0, 80.0});
    QVERIFY(!contact.follow(patch, boring, {-5.0, 80.0}, false, kTick));
    QVERIFY(!contact.follow(patch, boring, {-9.9, 80.0}, false, kTick));
    QVERIFY(contact.follow(patch, boring, {-11.0, 80.0}, false, kTick));
    QVERIFY((contact.tool() - ProfilePoint(-10.0, 80.0)).norm() < 1e-9);
    for (double r = -11.0; r > -30.0; r -= 0.5) contact.follow(patch, boring, {r, 80.0}, false, kTick);
    QVERIFY(!contact.follow(patch, boring, {-30.0, 80.0}, false, kTick));  // around the bar
    // Back in from there: nothing pulls the hand through the wall.
    for (double r = -30.0; r < -21.0; r += 0.1) {
      contact.follow(patch, boring, {r, 80.0}, false, kTick);
      QVERIFY((contact.tool() - ProfilePoint(r, 80.0)).norm() < 0.11);
    }
    // A tool for the outside is free within the bore.
    const ProfilePatch outer = patchAround(part, 80.0, kNose, TurningSide::Outside);
    QVERIFY(!(outer.penetration({5.0, 80.0}, kNose) > 0.0));
    QVERIFY(std::abs(outer.penetration({21.0, 80.0}, kNose) - 1.0) < 1e-9);
  }

  // Boring by the simulation: the wall moves out, the outside stays, and the pass repeats it.
  void boresBitForBit() {
    TurnedProfile part(kBar, 0.1);
    for (std::size_t i = 0; i < part.size(); ++i) part.limitInner(i, 6.0);
    const auto channel = std::make_shared<TurningChannel>();
    TurningSimulation simulation(part, TurnedSurface(part, 0.05), blank(TurningSide::Bore), kBase, channel);
    for (int i = 0; i < 200; ++i) {
      SimulationInput input;
      input.gesture = 1;
      input.proxy = input.tip.position = Vec3(0.0, 8.0, kBase + 110.0 - 0.3 * i);
      simulation.step(kTick, {&input, 1});
    }
    const TurnedProfile& bored = static_cast<const TurningState&>(*simulation.state()).profile;
    QVERIFY(std::abs(bored.inner(900) - 10.0) < 1e-9);
    QCOMPARE(bored.inner(300), 6.0);
    QCOMPARE(bored.radius(900), 20.0);
    TurnedProfile again = part;
    cut(again, simulation.pass());
    QVERIFY(again == bored);
  }

  // However the ticks are spread over the steps, the part is the same; and so it is by the log, and by the pass.
  void repeatedBitForBit() {
    std::optional<TurnedProfile> first;
    for (const int perStep : {1, 4, 17}) {
      Lathe lathe;
      lathe.perStep = perStep;
      // The hand is where the tool is: beside the material or pressed in, without the lag of the channel.
      for (int i = 0; i < 3000; ++i) {
        SimulationInput input;
        input.tip.isRestart = i == 0;
        input.gesture = i > 100 && i < 2900 ? 1u : 0u;
        input.tip.time = kTick * i;
        input.tip.position = Vec3(21.0 - 4.0 * std::sin(0.002 * i), 3.0, kBase + 20.0 + 0.02 * i);
        input.proxy = input.tip.position;
        lathe.channel->inputs->push(input);
        if (i % perStep == 0) lathe.loop.runSteps(1);
      }
      const auto taken = lathe.loop.take();
      const auto& logged = static_cast<const LoggedSimulation&>(*taken);
      const TurningState& state = lathe.state();
      QVERIFY(state.isCut && state.profile.volume() < kBar.volume());
      TurningSimulation again(lathe.bar, TurnedSurface(lathe.bar, 0.05), blank(), kBase, lathe.channel);
      replay(again, logged.log());
      QVERIFY(static_cast<const TurningState&>(*again.state()).profile == state.profile);
      TurnedProfile byPass = lathe.bar;
      cut(byPass, static_cast<const TurningSimulation&>(logged.logged()).pass());
      QVERIFY(byPass == state.profile);
      if (first) QVERIFY(*first == state.profile);
      first = state.profile;
    }
  }

  // Without a gesture the button alone does nothing, nor does it after a drop: the hand rests on the material.
  void theButtonAloneCutsNothing() {
    Lathe lathe;
    lathe.begin(0);
    for (double r = 23.0; r > 20.5; r -= 0.01) lathe.at({r, 0, 57.0}, true);
    QVERIFY((lathe.at({20.5, 0, 57.0}, true).proxy - Vec3(22.0, 0, 57.0)).norm() < 1e-9);
    lathe.begin(1);
    for (int i = 0; i < 100; ++i) lathe.at({20.5, 0, 57.0}, true);
    QVERIFY(lathe.state().isCut);
    lathe.begin(0);
    const TurnedProfile before = lathe.state().profile;
    for (double z = 57.0; z < 77.0; z += 0.01) lathe.at({20.5, 0, z}, true);
    lathe.at({20.5, 0, 77.0}, false);
    lathe.loop.runSteps(1);
    QVERIFY(lathe.state().profile == before);
  }

  // Material comes back, as after undo: no force while the hand rests or goes outward, the spring for any motion
  // deeper, and the whole bar after the hand was outside.
  void aBarThatComesBackDoesNotPush() {
    Lathe lathe;
    const auto simulation = [&lathe] {
      return std::make_unique<TurningSimulation>(lathe.bar, TurnedSurface(lathe.bar, 0.05), blank(), kBase,
                                                 lathe.channel);
    };
    for (double r = 23.0; r > 16.0; r -= 0.005) lathe.at({r, 0, 57.0}, true);
    ForceOut out;
    for (int i = 0; i < 12000; ++i) out = lathe.at({16.0, 0, 57.0}, true);
    QVERIFY(out.force.norm() < 1e-3);  // it has cut up to the hand
    lathe.begin(0);
    lathe.loop.replace(simulation());
    const auto forceAt = [&](double r) { return lathe.at({r, 0, 57.0}, false).force.x(); };
    for (int i = 0; i < 20; ++i) QVERIFY(std::abs(forceAt(16.0)) < 1e-3);
    QVERIFY(std::abs(forceAt(15.5) - 0.5 * 0.5) < 1e-3);
    for (double r = 16.0; r < 19.0; r += 0.01) QVERIFY(std::abs(forceAt(r)) < 1e-3);
    QVERIFY(std::abs(forceAt(18.5) - 0.5 * 0.5) < 0.01);
    for (double r = 18.5; r < 23.0; r += 0.01) forceAt(r);
    QVERIFY(std::abs(forceAt(20.5) - 0.5 * 1.5) < 1e-9);
    // The next gesture, whose simulation begins with the same profile, changes nothing.
    lathe.loop.replace(simulation());
    for (int i = 0; i < 20; ++i) QVERIFY(std::abs(forceAt(20.5) - 0.5 * 1.5) < 1e-9);
  }

  // Released and pressed again elsewhere before the window has seen it: no furrow between, and nothing cut there.
  void aPassEndsWithTheButton() {
    Lathe lathe;
    const auto plunge = [&lathe](double z) {
      for (double r = 24.0; r > 19.0; r -= 0.005) lathe.at({r, 0, kBase + z}, true);
    };
    plunge(20.0);
    for (double z = 20.0; z < 80.0; z += 0.05) lathe.at({24.0, 0, kBase + z}, z < 20.5);
    plunge(80.0);
    lathe.loop.runSteps(1);
    const auto radiusAt = [&lathe](double z) {
      return lathe.state().profile.radius(static_cast<std::size_t>(std::lround(z / lathe.bar.spacing())));
    };
    QVERIFY(radiusAt(20.0) < 19.0);
    QCOMPARE(radiusAt(50.0), 20.0);
    QCOMPARE(radiusAt(80.0), 20.0);
  }

  // At the standard distance of samples a shoulder is felt by any nose as the whole profile has it, or a little more.
  void thePatchHasTheWholeNose_data() {
    QTest::addColumn<double>("nose");
    for (double nose : {0.05, 1.0, 1.7, 2.0, 10.0, 50.0}) QTest::addRow("%g", nose) << nose;
  }
  void thePatchHasTheWholeNose() {
    QFETCH(double, nose);
    TurnedProfile part({300.0, 200.0, 0.0}, 0.013);
    part.cut({148.0 + nose, -10.0}, {148.0 + nose, 100.0 - nose}, nose);  // a step of 2 mm at z = 100
    const auto penetration = [&](const ProfilePoint& centre) {
      double deepest = -nose;
      for (std::size_t i = 0; i < part.size(); ++i) {
        const double offset = part.z(i) - centre.y();
        if (std::abs(offset) > nose) continue;
        const double low = centre.x() - std::sqrt(nose * nose - offset * offset);
        deepest = std::max(deepest, part.radius(i) - low);
      }
      return deepest;
    };
    const ProfilePatch patch = patchAround(part, 100.0 - nose, nose, TurningSide::Outside);
    const double stride = 4.0 * nose / (ProfilePatch::kMost - 2) + part.spacing();
    for (const double shift : {-0.9 * nose, -0.3 * nose, 0.0, 0.1 * nose, 0.7 * nose}) {
      const ProfilePoint on(148.0 + nose, 100.0 - nose + shift);
      const double whole = penetration(on), felt = patch.penetration(on, nose);
      QVERIFY(felt >= whole - 1e-9);
      // No more than with the nose moved by two strides to either side; 1e-4 mm is the difference between samples.
      const double beside =
          std::max(penetration(on + ProfilePoint(0, 2.0 * stride)), penetration(on - ProfilePoint(0, 2.0 * stride)));
      QVERIFY(felt <= std::max(whole, beside) + 1e-4);
    }
  }

  void aFullPassSaysSo() {
    const auto channel = std::make_shared<TurningChannel>();
    const TurnedProfile bar(kBar, 0.1);
    TurningSimulation simulation(bar, TurnedSurface(bar, 0.05), blank(), kBase, channel, 3);
    SimulationInput input;
    input.gesture = 1;
    for (const double z : {10.0, 30.0, 50.0, 90.0}) {
      input.proxy = Vec3(21.0, 0, kBase + z);
      QVERIFY(!static_cast<const TurningState&>(*simulation.state()).isFull || z > 50.0);
      simulation.step(kTick, {&input, 1});
    }
    const auto& state = static_cast<const TurningState&>(*simulation.state());
    QVERIFY(state.isFull && state.isCut);
    QCOMPARE(state.profile.radius(400), 19.0);
    QCOMPARE(state.profile.radius(800), 20.0);
    QCOMPARE(simulation.pass().path.size(), 3u);
  }

  void noNumberNoForce() {
    Lathe lathe;
    QVERIFY(lathe.at({std::nan(""), 0, 57.0}, true).force.isZero(0.0));
    QVERIFY(lathe.at({0, 0, std::numeric_limits<double>::infinity()}, true).force.isZero(0.0));
    lathe.loop.runSteps(1);
    QVERIFY(!lathe.state().isCut);
  }
};

HANDWHEEL_TEST(TurningSimulationTest)
#include "TurningSimulationTest.moc"
