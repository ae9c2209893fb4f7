// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/turning/TurningSimulation.h"

#include "TestClass.h"
#include "haptics/scene/SceneForces.h"
#include "simulation/SimulationLoop.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

constexpr StockCylinder kBar{40.0, 100.0, 0.0};
constexpr double kNose = 2.0, kBase = 7.0, kTick = 0.001;

// Servo loop and simulation of a bar whose lower end is at z = 7, in turns on one thread.
struct Lathe {
  TurningTool tool{kNose, 0.5, 0.1};
  std::shared_ptr<TurningChannel> channel = std::make_shared<TurningChannel>();
  VirtualClock clock;
  Service service{"simulation"};
  TurnedProfile bar{kBar, 0.1};
  SimulationLoop loop{std::make_unique<TurningSimulation>(bar, TurnedSurface(bar, 0.05), kNose, kBase, channel), 250.0,
                      channel->inputs, clock, service};
  SceneForces forces{sources()};
  TipState tip;
  int perStep = 4;  // ticks

  ForceSources sources() {
    channel->patch.write(patchAround(bar, 50.0, kNose));
    ForceSources all;
    all.push_back(std::make_unique<TurningForce>(channel, tool, kBase));
    return all;
  }
  ForceOut at(const Vec3& place, bool isCutting) {
    tip.velocity = tip.isRestart ? Vec3(Vec3::Zero()) : Vec3((place - tip.position) / kTick);
    tip.position = place;
    tip.buttons = isCutting ? 1u : 0u;
    tip.period = kTick;
    ForceOut out;
    out.proxy = place;
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

  // Pressed with a steady force the tool goes in at the speed F / resistance.
  void materialResistsByTheSpeed() {
    Lathe lathe;
    lathe.at({22.1, 0, 57.0}, true);
    double tool = 22.0;
    ForceOut out;
    for (int i = 0; i < 800; ++i) {
      out = lathe.at({tool - 1.0, 0, 57.0}, true);  // a spring of 1 mm: 0.5 N
      tool = out.proxy.x();
    }
    const double before = tool;
    for (int i = 0; i < 200; ++i) {
      out = lathe.at({tool - 1.0, 0, 57.0}, true);
      tool = out.proxy.x();
    }
    QVERIFY(std::abs((before - tool) / 0.2 / (0.5 / 0.1) - 1.0) < 0.02);
    QVERIFY(std::abs(out.force.x() - 0.5) < 0.01);
    QVERIFY(lathe.state().isCut);
    // What is left is as deep as the tool went.
    const std::size_t middle = static_cast<std::size_t>(std::lround(50.0 / lathe.bar.spacing()));
    lathe.loop.runSteps(1);
    QVERIFY(std::abs(lathe.state().profile.radius(middle) - (tool - kNose)) < 0.02);
  }

  // However the ticks are spread over the steps, the part is the same; and so it is by the log, and by the pass.
  void repeatedBitForBit() {
    std::optional<TurnedProfile> first;
    for (const int perStep : {1, 4, 17}) {
      Lathe lathe;
      lathe.perStep = perStep;
      lathe.loop.keepLog();
      // The hand is where the tool is: beside the material or pressed in, without the lag of the channel.
      for (int i = 0; i < 3000; ++i) {
        SimulationInput input;
        input.tip.isRestart = i == 0;
        input.tip.buttons = i > 100 && i < 2900 ? 1u : 0u;
        input.tip.time = kTick * i;
        input.tip.position = Vec3(21.0 - 4.0 * std::sin(0.002 * i), 3.0, kBase + 20.0 + 0.02 * i);
        input.proxy = input.tip.position;
        lathe.channel->inputs->push(input);
        if (i % perStep == 0) lathe.loop.runSteps(1);
      }
      lathe.loop.runSteps(1);
      const TurningState& state = lathe.state();
      QVERIFY(state.isCut && state.profile.volume() < kBar.volume());
      TurningSimulation again(lathe.bar, TurnedSurface(lathe.bar, 0.05), kNose, kBase, lathe.channel);
      replay(again, lathe.loop.log());
      QVERIFY(static_cast<const TurningState&>(*again.state()).profile == state.profile);
      TurnedProfile byPass = lathe.bar;
      cut(byPass, static_cast<const TurningSimulation&>(lathe.loop.simulation()).pass());
      QVERIFY(byPass == state.profile);
      if (first) QVERIFY(*first == state.profile);
      first = state.profile;
    }
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
