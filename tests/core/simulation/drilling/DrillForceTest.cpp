// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "HapticDevices.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "haptics/scene/SceneForces.h"
#include "haptics/servo/ServoTick.h"
#include "simulation/clay/ClayForce.h"
#include "simulation/drilling/DrillSimulation.h"
#include "volume/SurfaceToVolume.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kEdge = 5.0, kDrillRadius = 1.5, kStiff = 4.0;  // mm, mm, N/mm
constexpr double kTurning = 3000.0 * 2.0 * M_PI / 60.0;          // rad/s

DeviceCapabilities deviceWithTorque(double mostTorque) {
  DeviceCapabilities device = forceDevice();
  device.outputs = mostTorque > 0.0 ? 6 : 3;
  device.maxTorque = mostTorque;
  return device;
}

// A hand at a device that drills down through a block of bone: servo loop, safety chain and simulation, in turns on one
// thread.
struct DrillingHand {
  DrillSetup setup;
  std::shared_ptr<ClayChannel> channel = std::make_shared<ClayChannel>();
  std::unique_ptr<DrillSimulation> simulation;
  std::shared_ptr<ScriptedDevice::Log> log = std::make_shared<ScriptedDevice::Log>();
  ScriptedDevice device;
  VirtualClock clock;
  ServoChannel servo{4096};
  ServoTick tick{device, {}, clock, servo};
  std::int64_t time = 0;
  int perStep, ticks = 0;
  double energy = 0.0;  // J, that the vectors that were sent have taken from the hand and the spindle
  SafetyActions actions;

  explicit DrillingHand(double mostTorque = 100.0, int ticksOfStep = 1)
      : device(log, deviceWithTorque(mostTorque)), perStep(ticksOfStep) {
    setup.tool.diameter = 2.0 * kDrillRadius;
    setup.material = *drillMaterial("cancellous-bone");
    setup.spindle = kTurning;
    auto begin = std::make_shared<ClayState>();
    begin->volume = volumeOfSurface(moved(cube(kEdge), Vec3(-0.5 * kEdge, -0.5 * kEdge, -kEdge)), 0.18)->volume;
    simulation = std::make_unique<DrillSimulation>(begin, setup, std::nullopt, channel);
    ClayFeel feel{kStiff, fullResistance()};
    feel.isCutting = true;
    feel.spindle = kTurning * 60.0 / (2.0 * M_PI);
    feel.reach = setup.tool.reach();
    ForceSources sources;
    sources.push_back(std::make_unique<ClayForce>(channel, feel));
    auto scene = std::make_unique<HapticScene>();
    scene->renderer = std::make_unique<SceneForces>(std::move(sources));
    servo.scenes.publish(std::move(scene));
    channel->inputs->setDeviceGesture(1);
    log->state.position = Vec3(0.01, -0.02, 3.0);
    for (int i = 0; i < 2500; ++i) run(log->state.position);  // the ramp, beside the material
    log->state.buttons = 1;
    energy = 0.0;
    actions = {};
  }
  // (3-24) of the whole section, by the speed.
  double fullResistance() const {
    return setup.material.energy * M_PI * kDrillRadius * kDrillRadius /
           (setup.material.tangential * kDrillRadius * kTurning);
  }
  ServoSample run(const Vec3& to) {
    const DeviceForce sent = log->last;
    energy -= 1e-3 * sent.force.dot(to - log->state.position);
    log->state.position = to;
    time += kMillisecond;
    clock.set(time);
    tick.run(time);
    energy -= 1e-6 * log->last.torque.dot(setup.spindle * Vec3::UnitZ());
    const ServoSample sample = servo.latest.read();
    for (const SafetyAction action : {SafetyAction::Passivity, SafetyAction::Clamp, SafetyAction::Slew,
                                      SafetyAction::Ramp, SafetyAction::SpeedDamping})
      if (sample.actions.has(action)) actions.add(action);
    if (++ticks % perStep == 0) step();
    return sample;
  }
  void step() {
    std::vector<SimulationInput> inputs;
    for (SimulationInput input; channel->inputs->pop(input);) inputs.push_back(input);
    simulation->step(0.001 * perStep, inputs);
  }
  const DrillState& state() const { return static_cast<const DrillState&>(*simulation->state()); }
};

}  // namespace

// The force on a hand that drills, from the simulation to the motors.
class DrillForceTest : public QObject {
  Q_OBJECT

 private slots:
  // The work of the vectors that were sent is kp times the analytic volume of the hole, to one per cent.
  void workOfWhatWasSent_data() {
    QTest::addColumn<int>("perStep");
    QTest::newRow("in lockstep") << 1;
    QTest::newRow("at 60 Hz") << 16;
  }
  void workOfWhatWasSent() {
    QFETCH(int, perStep);
    DrillingHand hand(100.0, perStep);
    const Vec3 start = hand.log->state.position;
    for (int i = 1; i <= 2000; ++i) hand.run(start - Vec3(0.0, 0.0, 0.005 * i));  // 5 mm/s, through it and beyond
    QVERIFY(hand.state().breakthrough);
    QVERIFY(hand.actions.isEmpty());
    QVERIFY(hand.log->last.force.norm() < 1e-9);
    const double exact = 1e-3 * hand.setup.material.energy * M_PI * kDrillRadius * kDrillRadius * kEdge;
    QVERIFY2(std::abs(hand.energy / exact - 1.0) < 0.01, qPrintable(QString::number(hand.energy / exact)));
    QVERIFY(std::abs(hand.state().energy / exact - 1.0) < 0.01);
  }

  // Deep inside it is the thrust of the whole section at the feed of the hand, against its motion, with the torque that
  // belongs to it. After the breakthrough, a ball of radius r whose centre is h above the face has the share (h / r)²
  // of the section: at the face, nothing.
  void theForceFallsAtTheBreakthrough() {
    DrillingHand hand;
    const Vec3 start = hand.log->state.position;
    constexpr double kFeed = 3.0;  // mm/s
    double deep = 0.0, half = 0.0;
    int ofDeep = 0, ofHalf = 0;
    for (int i = 1; i <= 3200; ++i) {
      const ServoSample sample = hand.run(start - Vec3(0.0, 0.0, 1e-3 * kFeed * i));
      const double height = kEdge + sample.felt.proxy.z();  // height of the tool's centre over the lower face
      const DeviceForce& sent = sample.sent;
      if (height > 1.1 * kDrillRadius && height < 2.0 * kDrillRadius) {
        deep += sent.force.z();
        ++ofDeep;
        QVERIFY(std::hypot(sent.force.x(), sent.force.y()) < 1e-3 * sent.force.z());
        const double torque = hand.setup.material.tangential * kDrillRadius * sent.force.z();
        QVERIFY2(std::abs(-sent.torque.z() / torque - 1.0) < 0.01, qPrintable(QString::number(sent.torque.z())));
      }
      if (height > 0.45 * kDrillRadius && height < 0.55 * kDrillRadius) {
        half += sent.force.z();
        ++ofHalf;
      }
      if (height < -0.25) QVERIFY(sent.isZero());
    }
    QVERIFY(hand.state().breakthrough && ofDeep > 100 && ofHalf > 20);
    const double thrust = hand.fullResistance() * kFeed;
    QVERIFY2(std::abs(deep / ofDeep / thrust - 1.0) < 0.03, qPrintable(QString::number(deep / ofDeep / thrust)));
    const double share = half / ofHalf / thrust;
    QVERIFY2(std::abs(share - 0.25) < 0.07, qPrintable(QString::number(share)));
  }

  // Retraction is free, except for remaining material in voxels on its path, and a device without motors for it is sent
  // no torque.
  void retraction() {
    DrillingHand hand(0.0);
    const Vec3 start = hand.log->state.position;
    for (int i = 1; i <= 800; ++i) hand.run(start - Vec3(0.0, 0.0, 0.005 * i));
    QVERIFY(hand.log->last.force.z() > 0.5);
    QVERIFY(hand.log->last.torque.isZero(0.0));
    const Vec3 deep = hand.log->state.position;
    for (int i = 1; i <= 100; ++i) {
      hand.run(deep + Vec3(0.0, 0.0, 0.02 * i));
      QVERIFY2(hand.log->last.force.z() > -0.1, qPrintable(QString("%1: %2").arg(i).arg(hand.log->last.force.z())));
    }
    QVERIFY(hand.log->last.isZero());
  }
};

HANDWHEEL_TEST(DrillForceTest)
#include "DrillForceTest.moc"
