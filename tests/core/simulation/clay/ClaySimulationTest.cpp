// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/clay/ClaySimulation.h"

#include "TestClass.h"
#include "volume/VolumeSampler.h"
#include "volume/VolumeShapes.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr double kVoxel = 0.25;  // mm

std::shared_ptr<const ClayState> ball() {
  auto state = std::make_shared<ClayState>();
  state->volume = ballOfVoxels(6.0, kVoxel);
  state->surface = VolumeSurface(state->volume);
  return state;
}

SimulationInput at(const Vec3& position, double time, std::uint32_t gesture = 1) {
  SimulationInput input;
  input.tip.position = input.proxy = position;
  input.tip.time = time;
  input.gesture = gesture;
  return input;
}

ClayBrush carving(double radius) {
  ClayBrush brush;
  brush.action = ClayAction::Carve;
  brush.radius = radius;
  return brush;
}

}  // namespace

class ClaySimulationTest : public QObject {
  Q_OBJECT

 private slots:
  // A stroke removes the same as a ball along its whole path, whatever the steps are.
  void aStrokeIsASweep() {
    ClaySimulation simulation(ball(), carving(1.0), std::make_shared<ClayChannel>());
    const Vec3 from(-7.0, 0.0, 5.5), to(7.0, 0.5, 5.5);
    for (int i = 0; i <= 100; ++i) {
      const SimulationInput input = at(from + i / 100.0 * (to - from), i / 100.0);
      simulation.step(1.0 / 60.0, {&input, 1});
    }
    simulation.finish();
    const auto state = std::static_pointer_cast<const ClayState>(simulation.state());
    const VolumeSampler sampler(state->volume);
    for (int i = 0; i < 2000; ++i) {
      const Vec3 p(8.0 * std::sin(i), 3.0 * std::sin(2.0 * i + 1.0), 4.0 + 3.0 * std::cos(3.0 * i));
      const double share = std::clamp((p - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
      const double exact = std::min(6.0 - p.norm(), (p - from - share * (to - from)).norm() - 1.0);
      // The last bit of the path is shorter than the spacing of dabs.
      if ((p - to).norm() < 1.2 || std::abs(exact) < 0.3 * kVoxel) continue;
      QCOMPARE(sampler.depthAt(p).depth > 0.0, exact > 0.0);
    }
    QVERIFY(state->changedBlocks > 10);
    const VolumeSurface fresh(state->volume);
    QCOMPARE(state->surface.triangleCount(), fresh.triangleCount());
  }

  // The same inputs give the same bytes; also in other portions, once all are applied.
  void isTheSameAgain() {
    const auto run = [](std::size_t portion) {
      ClayBrush brush = carving(0.8);
      brush.action = ClayAction::Inflate;
      ClaySimulation simulation(ball(), brush, std::make_shared<ClayChannel>());
      std::vector<SimulationInput> inputs;
      for (int i = 0; i < 60; ++i)
        inputs.push_back(at({6.0 * std::sin(i / 20.0), 0.0, 6.0 * std::cos(i / 20.0)}, i * 0.004));
      for (std::size_t i = 0; i < inputs.size(); i += portion)
        simulation.step(1.0 / 60.0, std::span(inputs).subspan(i, std::min(portion, inputs.size() - i)));
      simulation.finish();
      return std::static_pointer_cast<const ClayState>(simulation.state())->volume;
    };
    const SparseVolume one = run(1), again = run(1), other = run(60);
    const auto isSame = [](const SparseVolume& a, const SparseVolume& b) {
      bool same = a.blockCount() == b.blockCount() && a.blockCount() > 0;
      for (const VoxelIndex& block : a.blocks()) {
        const auto x = a.content(block), y = b.content(block);
        same = same && x.block && y.block && x.block->depths == y.block->depths;
      }
      return same;
    };
    QVERIFY(isSame(one, again));
    QVERIFY(isSame(one, other));
  }

  // A hand that only moves changes nothing, nor do invalid positions.
  void nothingHappens() {
    const auto begin = ball();
    ClaySimulation simulation(begin, carving(1.0), std::make_shared<ClayChannel>());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const SimulationInput& input :
         {at({0.0, 0.0, 6.0}, 0.0, 0), at({nan, 0.0, 0.0}, 0.1), at({1e300, 0.0, 6.0}, 0.2)})
      simulation.step(1.0 / 60.0, {&input, 1});
    simulation.step(1.0 / 60.0, {});
    simulation.finish();
    QCOMPARE(simulation.state(), std::static_pointer_cast<const SimulationState>(begin));
  }

  // A stroke that masks changes no sample, and protects what it went over in the simulation that follows.
  void masksAndIsHeldBack() {
    const auto begin = ball();
    ClayBrush brush = carving(1.5);
    brush.action = ClayAction::Mask;
    brush.falloff = 0.0;
    ClaySimulation masking(begin, brush, std::make_shared<ClayChannel>());
    for (int i = 0; i <= 20; ++i) {
      const SimulationInput input = at({-2.0 + 0.2 * i, 0.0, 5.6}, 0.01 * i);
      masking.step(1.0 / 60.0, {&input, 1});
    }
    masking.finish();
    const auto masked = std::static_pointer_cast<const ClayState>(masking.state());
    QVERIFY(masked->mask && masked->changedBlocks > 0);
    QCOMPARE(masked->surface.pieces(), begin->surface.pieces());
    for (const double x : {-2.0, -1.0, 0.0, 1.0, 1.5}) QCOMPARE(masked->mask->shareAt({x, 0.0, 5.6}), 1.0);
    for (const double y : {-2.0, 2.0}) QCOMPARE(masked->mask->shareAt({0.0, y, 5.6}), 0.0);
    ClaySimulation carved(masked, carving(0.8), std::make_shared<ClayChannel>());
    for (int i = 0; i <= 60; ++i) {
      const SimulationInput input = at({0.0, -3.0 + 0.1 * i, 5.6}, 0.01 * i);
      carved.step(1.0 / 60.0, {&input, 1});
    }
    carved.finish();
    const VolumeSampler sampler(std::static_pointer_cast<const ClayState>(carved.state())->volume);
    QVERIFY(sampler.depthAt({0.0, 0.0, 5.5}).depth > 0.0);
    for (const double y : {-2.5, 2.5}) QVERIFY(sampler.depthAt({0.0, y, 5.2}).depth < 0.0);
  }

  // Both sides of a plane are worked on at once.
  void mirrors() {
    ClayBrush brush = carving(1.0);
    brush.isMirrored = {true, false, true};
    ClaySimulation simulation(ball(), brush, std::make_shared<ClayChannel>());
    const SimulationInput input = at({4.0, 1.0, 4.0}, 0.0);
    simulation.step(1.0 / 60.0, {&input, 1});
    simulation.finish();
    const VolumeSampler sampler(std::static_pointer_cast<const ClayState>(simulation.state())->volume);
    for (const double x : {-4.0, 4.0})
      for (const double z : {-4.0, 4.0}) {
        QVERIFY(sampler.depthAt({x, 1.0, z}).depth < 0.0);
        QVERIFY(sampler.depthAt({x, -1.0, z}).depth > 0.0);
      }
  }

  // A hand faster than the machine is followed late: no step does more than some dabs.
  void stepsAreShort() {
    ClayBrush brush = carving(0.5);
    brush.action = ClayAction::Smooth;
    ClaySimulation simulation(ball(), brush, std::make_shared<ClayChannel>());
    std::vector<SimulationInput> inputs;
    for (int i = 0; i < 200; ++i)
      inputs.push_back(at({6.0 * std::sin(i / 30.0), 0.0, 6.0 * std::cos(i / 30.0)}, i * 0.001));
    simulation.step(1.0 / 60.0, inputs);
    const auto first = simulation.state();
    int steps = 1;
    for (auto before = first; steps < 1000; ++steps) {
      simulation.step(1.0 / 60.0, {});
      if (simulation.state() == before) break;
      before = simulation.state();
    }
    QVERIFY(steps > 5);
  }
};

HANDWHEEL_TEST(ClaySimulationTest)
#include "ClaySimulationTest.moc"
