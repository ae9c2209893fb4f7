// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SimulationLog.h"
#include "TestClass.h"
#include "globe/simulation/DentSimulation.h"
#include "haptics/scene/MeshHaptics.h"
#include "haptics/scene/SceneForces.h"
#include "simulation/SimulationLoop.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kRadius = 10.0, kStiffness = 0.5, kPole = 0.2;  // mm, N/mm
constexpr double kReach = 4.0;                                   // mm, of the poles
const Pose kHere = Pose::Identity();
constexpr double kTick = 0.001;  // s

// A globe and its poles in one scene.
SceneForces sceneOf(const GlobeSurface& surface, std::shared_ptr<DentChannel> channel = {}, const Pose& pose = kHere) {
  SnapFeatures poles;
  poles.addPoint(0, {0, 0, kRadius});
  ForceSources sources;
  sources.push_back(std::make_unique<GlobeForce>(surface, pose, kStiffness, std::move(channel)));
  sources.push_back(std::make_unique<SnapForce>(
      kSnapSource, SnapAttraction{SnapField(poles), SnapProfile(SnapShape::Spring, kPole, kReach), SnapMethod::Sum}));
  return SceneForces(std::move(sources));
}

TipState tipAt(const Vec3& position, std::uint32_t buttons = 0) {
  TipState tip;
  tip.position = position;
  tip.isRestart = false;
  tip.period = kTick;
  tip.buttons = buttons;
  return tip;
}

ForceOut feltAt(SceneForces& scene, const TipState& tip) {
  ForceOut out;
  out.proxy = tip.position;
  scene.tick(tip, out);
  return out;
}

// A path over the northern half, in and out of the globe.
std::vector<SimulationInput> gesture() {
  std::vector<SimulationInput> inputs(1500);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double t = kTick * static_cast<double>(i);
    const Vec3 direction = Vec3(std::cos(2.0 * t), std::sin(3.0 * t), 1.5).normalized();
    inputs[i].tip = tipAt((kRadius - 1.5 * std::sin(9.0 * t)) * direction);
    inputs[i].gesture = i > 100 ? 1u : 0u;
    inputs[i].tip.time = t;
  }
  return inputs;
}

const GlobeSurface& surfaceOf(const std::shared_ptr<const SimulationState>& state) {
  return static_cast<const DentState&>(*state).surface;
}

}  // namespace

// The force and the simulation of a kind that the program does not have, without a window.
class GlobeForceTest : public QObject {
  Q_OBJECT

 private slots:
  // Inside near the pole both act: the spring to the surface above the tip, and that to the pole.
  void actsBesideSnapping() {
    SceneForces scene = sceneOf(GlobeSurface(kRadius));
    const Vec3 tip(1.0, 0.5, 8.5), out = tip.normalized();
    const Vec3 expected = kStiffness * (kRadius - tip.norm()) * out + kPole * (Vec3(0, 0, kRadius) - tip);
    const ForceOut felt = feltAt(scene, tipAt(tip));
    QVERIFY((felt.force - expected).norm() < 1e-9);
    QVERIFY(felt.isContact && std::abs(felt.stiffness - (kStiffness + kPole)) < 1e-12);
    QVERIFY(feltAt(scene, tipAt({0, 0, -10.5})).force.isZero(0.0));  // outside, and far from that pole
    QVERIFY((feltAt(scene, tipAt({0, 0, 12})).force - Vec3(0, 0, -2.0 * kPole)).norm() < 1e-9);
  }

  // Stiffness that the loop cannot carry is taken from both by the same share.
  void isSoftenedTogether() {
    SceneForces scene = sceneOf(GlobeSurface(kRadius));
    const Vec3 position(1.0, 0.5, 8.5);
    const Vec3 whole = feltAt(scene, tipAt(position)).force;
    TipState tip = tipAt(position);
    tip.stiffnessLimit = 0.25 * (kStiffness + kPole);
    const ForceOut felt = feltAt(scene, tip);
    QVERIFY(felt.isSoftened && (felt.force - 0.25 * whole).norm() < 1e-9);
    QVERIFY(feltAt(scene, tipAt({std::nan(""), 0, 0})).force.isZero(0.0));
  }

  // The point that is pressed follows the tip as the sum of the weights says, and no point beyond the reach moves.
  void givesWayUnderTheTip() {
    const Vec3 direction = Vec3(0.3, -0.4, 0.7).normalized();
    double sum = 0.0, squares = 0.0;
    for (const Vec3& each : globeDirections()) {
      const double weight = globeWeight((each - direction).norm());
      sum += weight;
      squares += weight * weight;
    }
    const double perTick = 1.0 + std::expm1(-kTick / DentSimulation::kYield) * squares / sum;
    DentSimulation simulation(GlobeSurface(kRadius), kHere, std::make_shared<DentChannel>());
    SimulationInput input;
    input.tip = tipAt(8.0 * direction);
    input.gesture = 1;
    simulation.step(0.004, std::vector<SimulationInput>(60, input));
    const GlobeSurface& dented = surfaceOf(simulation.state());
    QVERIFY(std::abs(dented.heightTowards(direction) - (8.0 + 2.0 * std::pow(perTick, 60))) < 1e-9);
    for (std::size_t i = 0; i < kGlobePoints; ++i) {
      if ((globeDirections()[i] - direction).norm() > kGlobeReach) QCOMPARE(dented.dent(i), 0.0);
    }
    input.gesture = 0;
    simulation.step(0.004, std::vector<SimulationInput>(60, input));
    QVERIFY(surfaceOf(simulation.state()) == dented);
  }

  // The hand feels what is left as soon as the simulation has reported it; where the globe is.
  void whatIsLeftIsFelt() {
    const Pose pose = Eigen::Translation3d(30, -40, 50) * Eigen::AngleAxisd(1.0, Vec3(1, 2, 3).normalized());
    const auto channel = std::make_shared<DentChannel>();
    channel->inputs->setDeviceGesture(1);
    const GlobeSurface round(kRadius);
    DentSimulation simulation(round, pose, channel);
    SceneForces scene = sceneOf(round, channel, pose);
    const Vec3 inside(8.0, 0, 0), tip = pose * inside, out = pose.linear() * Vec3::UnitX();
    QVERIFY((feltAt(scene, tipAt(tip, 1)).force - 2.0 * kStiffness * out).norm() < 1e-9);
    for (int i = 0; i < 100; ++i) {
      SimulationInput input;
      while (channel->inputs->pop(input)) simulation.step(kTick, {&input, 1});
      const ForceOut felt = feltAt(scene, tipAt(tip, 1));
      const double height = surfaceOf(simulation.state()).heightTowards(inside);
      QVERIFY((felt.force - kStiffness * (height - 8.0) * out).norm() < 1e-9);
      QVERIFY((felt.proxy - pose * Vec3(height, 0, 0)).norm() < 1e-9);
    }
    QVERIFY(surfaceOf(simulation.state()).heightTowards(inside) < 9.0);
  }

  // However the ticks are spread over the steps; and by the log.
  void repeatedBitForBit() {
    std::optional<GlobeSurface> first;
    for (const std::size_t perStep : {1, 4, 37}) {
      VirtualClock clock;
      Service service("dents");
      const auto channel = std::make_shared<DentChannel>();
      auto dents = std::make_unique<DentSimulation>(GlobeSurface(kRadius), kHere, channel);
      SimulationLoop loop(std::make_unique<LoggedSimulation>(std::move(dents)), 250.0, channel->inputs, clock, service);
      loop.setGesture(1);
      std::size_t count = 0;
      for (const SimulationInput& input : gesture()) {
        channel->inputs->push(input);
        if (++count % perStep == 0) loop.runSteps(1);
      }
      const auto taken = loop.take();
      const GlobeSurface live = surfaceOf(loop.state());
      QVERIFY(live.isDented());
      DentSimulation again(GlobeSurface(kRadius), kHere, std::make_shared<DentChannel>());
      replay(again, static_cast<const LoggedSimulation&>(*taken).log());
      QVERIFY(surfaceOf(again.state()) == live);
      if (first) QVERIFY(live == *first);
      first = live;
    }
  }
};

HANDWHEEL_TEST(GlobeForceTest)
#include "GlobeForceTest.moc"
