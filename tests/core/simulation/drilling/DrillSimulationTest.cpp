// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/drilling/DrillSimulation.h"

#include "DrillInput.h"
#include "TestClass.h"
#include "volume/VolumeSampler.h"
#include "volume/VolumeShapes.h"
#include "volume/drilling/DrillProgram.h"
#include "volume/drilling/DrillReview.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

std::shared_ptr<const ClayState> drilledBall() {
  auto state = std::make_shared<ClayState>();
  state->volume = ballOfVoxels(4.0, 0.2);
  state->surface = VolumeSurface(state->volume);
  return state;
}

DrillSetup fineDrill() {
  DrillSetup setup;
  setup.tool.diameter = 3.0;
  return setup;
}

}  // namespace

class DrillSimulationTest : public QObject {
  Q_OBJECT

 private slots:
  // Fed by the program it goes at its feed, step by step, through the ball, and says when it is through.
  void fed() {
    DrillSimulation simulation(drilledBall(), fineDrill(), DrillFeed{Vec3::UnitZ(), 6.0},
                               std::make_shared<ClayChannel>());
    simulation.step(1.0 / 60.0, {});
    QCOMPARE(test::stateOf(simulation)->removed, 0.0);  // not pressed yet
    const SimulationInput pressed = test::handAt({0.0, 0.0, 5.5}, 0.0, 1);
    simulation.step(1.0 / 60.0, {&pressed, 1});
    for (int i = 1; i < 60; ++i) simulation.step(1.0 / 60.0, {});
    const auto half = test::stateOf(simulation);
    QVERIFY(half->removed > 0.0 && half->figures.thrust > 0.0 && !half->breakthrough);
    // After a second the front is 6 mm below 4: at the depth of the feed.
    const VolumeSampler sampler(half->volume);
    QVERIFY(sampler.depthAt({0.0, 0.0, -1.9}).depth < 0.0);
    QVERIFY(sampler.depthAt({0.0, 0.0, -2.3}).depth > 0.0);
    for (int i = 60; i < 130; ++i) simulation.step(1.0 / 60.0, {});
    const auto through = test::stateOf(simulation);
    QVERIFY(through->breakthrough);
    QVERIFY(std::abs(*through->breakthrough - 8.0 / 6.0) < 0.05);
    QCOMPARE(through->surface.triangleCount(), VolumeSurface(through->volume).triangleCount());
    QVERIFY(std::abs(through->removed - (countedMaterial(drilledBall()->volume) - countedMaterial(through->volume))) <
            1e-6);
    QVERIFY(std::abs(through->energy / (0.25 * through->removed) - 1.0) < 0.01);
  }

  // In pecks of 3 mm through the ball of 8 mm: out to the start and back as G83 does, each to its full depth; it
  // removes the same as a plain feed, and is through later by the duration of the retractions and returns.
  void inPecks() {
    const auto drilled = [](double peck, int steps) {
      DrillSimulation simulation(drilledBall(), fineDrill(), DrillFeed{Vec3::UnitZ(), 6.0, peck},
                                 std::make_shared<ClayChannel>());
      const SimulationInput pressed = test::handAt({0.0, 0.0, 5.5}, 0.0, 1);
      simulation.step(1.0 / 60.0, {&pressed, 1});
      for (int i = 1; i < steps; ++i) simulation.step(1.0 / 60.0, {});
      return test::stateOf(simulation);
    };
    const auto plain = drilled(0.0, 120), pecked = drilled(3.0, 160);
    QVERIFY(plain->breakthrough && pecked->breakthrough);
    double later = 0.0;
    for (const double depth : {3.0, 6.0})
      later += (2.0 * depth - DrillProgram::kPeckClearance) / DrillProgram::kRapid + DrillProgram::kPeckClearance / 6.0;
    QVERIFY2(std::abs(*pecked->breakthrough - *plain->breakthrough - later) < 1.5 / 60.0,
             qPrintable(QString::number(*pecked->breakthrough - *plain->breakthrough)));
    std::vector<double> turns;  // mm, depths where it turns
    double before = 0.0, direction = 1.0;
    for (std::size_t i = 1; i < pecked->poses.size(); ++i) {
      const double depth = 5.5 - pecked->poses[i].position().z();
      if ((depth - before) * direction < -1e-9) {
        turns.push_back(before);
        direction = -direction;
      }
      before = depth;
    }
    QVERIFY(turns.size() >= 4);
    const double exact[] = {3.0, 0.0, 6.0, 0.0};
    for (std::size_t i = 0; i < 4; ++i) QVERIFY(std::abs(turns[i] - exact[i]) < 2e-6);
    QVERIFY(std::abs(pecked->removed / plain->removed - 1.0) < 0.01);
    // Less than the least peck is none.
    QCOMPARE(drilled(1e-12, 30)->removed, drilled(0.0, 30)->removed);
  }

  // While the feed is held nothing is removed and time continues; then the hole is the same, later.
  void feedHold() {
    const auto drilled = [](int held) {
      DrillSimulation simulation(drilledBall(), fineDrill(), DrillFeed{Vec3::UnitZ(), 6.0},
                                 std::make_shared<ClayChannel>());
      const SimulationInput pressed = test::handAt({0.0, 0.0, 5.5}, 0.0, 1);
      simulation.step(1.0 / 60.0, {&pressed, 1});
      for (int i = 1; i < 40; ++i) simulation.step(1.0 / 60.0, {});
      simulation.holdFeed(true);
      simulation.step(1.0 / 60.0, {});
      const double removed = test::stateOf(simulation)->removed;
      for (int i = 1; i < held; ++i) simulation.step(1.0 / 60.0, {});
      if (held > 1 && (test::stateOf(simulation)->removed != removed || test::stateOf(simulation)->thrust != 0.0))
        qFatal("not held");
      simulation.holdFeed(false);
      for (int i = 0; i < 80; ++i) simulation.step(1.0 / 60.0, {});
      return test::stateOf(simulation);
    };
    const auto brief = drilled(1), lengthy = drilled(61);
    QCOMPARE(lengthy->removed, brief->removed);
    QVERIFY(std::abs(*lengthy->breakthrough - *brief->breakthrough - 1.0) < 1e-5);
  }

  // By the hand: as DrillRun with the same positions; a hand that only moves drills nothing. The record gives the very
  // same hole.
  void byTheHand() {
    DrillSimulation simulation(drilledBall(), fineDrill(), std::nullopt, std::make_shared<ClayChannel>());
    SparseVolume volume = drilledBall()->volume;
    DrillRun run(volume, fineDrill());
    for (int i = 0; i < 200; ++i) {
      const Vec3 position(0.1, 0.2, 6.0 - 0.02 * i);
      const std::uint32_t gesture = i < 20 ? 0 : 1;
      const SimulationInput input = test::handAt(position, 0.001 * i, gesture);
      simulation.step(1.0 / 60.0, {&input, 1});
      if (gesture != 0) move(run, DrillPose::of(position, Vec3::UnitZ(), 0.001 * (i - 20)));
    }
    QVERIFY(run.removed() > 0.0);
    QVERIFY(std::abs(test::stateOf(simulation)->removed - run.removed()) < 1e-9);
    QVERIFY(std::abs(test::stateOf(simulation)->energy / run.energy() - 1.0) < 1e-6);
    const double thrust = test::stateOf(simulation)->figures.thrust;  // largest of the means
    QVERIFY(thrust > 0.0 && thrust <= run.maxThrust() * (1.0 + 1e-6));

    const auto made = test::stateOf(simulation);
    QCOMPARE(made->poses.size(), std::size_t{180});
    auto record = std::make_shared<DrillRecord>();
    record->setup = fineDrill();
    record->poses = made->poses;
    const std::shared_ptr<const DrillRecord> holes[] = {record};
    const auto again = reviewDrilling(drilledBall()->volume, *made->plan, holes);
    QVERIFY(again.has_value());
    QCOMPARE(again->moments.size(), made->moments.size());
    for (std::size_t i = 0; i < again->moments.size(); ++i) {
      QCOMPARE(again->moments[i].thrust, made->moments[i].thrust);
      QCOMPARE(again->moments[i].temperature, made->moments[i].temperature);
    }
    QCOMPARE(countedMaterial(again->left), countedMaterial(made->volume));
  }
};

HANDWHEEL_TEST(DrillSimulationTest)
#include "DrillSimulationTest.moc"
