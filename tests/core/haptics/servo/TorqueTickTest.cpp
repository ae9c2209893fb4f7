// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "HapticDevices.h"
#include "TestClass.h"
#include "haptics/device/SimulatedDevice.h"
#include "haptics/scene/MeshHaptics.h"
#include "haptics/scene/SceneForces.h"
#include "haptics/servo/ServoTick.h"

#include <QtTest>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kMostTorque = 100.0;  // N·mm

DeviceCapabilities turningDevice() {
  DeviceCapabilities device = forceDevice();
  device.inputs = 6;
  device.outputs = 6;
  device.maxTorque = kMostTorque;
  return device;
}

// A tick on a virtual clock with a device that has motors for torque, or has none.
struct TurningRig {
  explicit TurningRig(const DeviceCapabilities& capabilities = turningDevice()) : device(log, capabilities) {}

  std::shared_ptr<ScriptedDevice::Log> log = std::make_shared<ScriptedDevice::Log>();
  ScriptedDevice device;
  VirtualClock clock;
  ServoChannel channel{4096};
  ServoTick tick{device, {}, clock, channel};
  std::int64_t time = 0;

  ServoSample run() {
    time += kMillisecond;
    clock.set(time);
    tick.run(time);
    return channel.latest.read();
  }
  ServoSample runMany(int count) {
    ServoSample sample;
    for (int i = 0; i < count; ++i) sample = run();
    return sample;
  }
  void turnTo(const Eigen::Quaterniond& turn, double turning) {
    MeshHaptics feel;
    feel.springs = {{Vec3::Zero(), 0.0, 0.0, turn, turning}};
    auto scene = std::make_unique<HapticScene>();
    scene->renderer = std::make_unique<SceneForces>(forceSources(std::move(feel)));
    channel.scenes.publish(std::move(scene));
  }
};

Eigen::Quaterniond aroundZ(double angle) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
}

}  // namespace

// The path of a torque from a scene to the motors.
class TorqueTickTest : public QObject {
  Q_OBJECT

 private slots:
  // 50 N·mm/rad over 0.4 rad; less and less as the device turns there.
  void turnsTheDevice() {
    TurningRig rig;
    rig.turnTo(aroundZ(0.4), 50.0);
    ServoSample sample = rig.runMany(4000);
    QVERIFY((sample.sent.torque - Vec3(0, 0, 20)).norm() < 1e-9);
    QVERIFY(sample.sent.force.isZero(0.0) && sample.sent.gripper == 0.0);
    QVERIFY((rig.log->last.torque - Vec3(0, 0, 20)).norm() < 1e-9);
    rig.log->state.orientation = aroundZ(0.3);
    sample = rig.runMany(100);
    QVERIFY((sample.sent.torque - Vec3(0, 0, 5)).norm() < 1e-9);
    rig.log->state.orientation = aroundZ(0.4);
    QVERIFY(rig.runMany(100).sent.torque.norm() < 1e-9);
  }

  // In a view that is turned, and with another gain, the hand feels the torque about the axis that it sees.
  void isThatOfTheView() {
    TurningRig rig;
    WorkspaceMapping mapping;
    mapping.sceneFromView.linear() = Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX()).toRotationMatrix();
    mapping.forceGain = 2.0;
    rig.channel.mapping.write({1, mapping});
    rig.channel.scenes.publish([] {
      auto scene = std::make_unique<HapticScene>();
      scene->renderer =
          std::make_unique<FunctionSource>([](const TipState&, ForceOut& out) { out.torque = Vec3(0, 0, 10); });
      return scene;
    }());
    // The scene's z is the view's y.
    QVERIFY((rig.runMany(4000).sent.torque - Vec3(0, 20, 0)).norm() < 1e-9);
  }

  void otherDevicesGetNone() {
    TurningRig rig(forceDevice());
    rig.turnTo(aroundZ(0.4), 50.0);
    for (int i = 0; i < 4000; ++i) QVERIFY(rig.run().sent.isZero());
    QVERIFY(rig.channel.latest.read().actions.isEmpty());
  }

  // The torque never exceeds the device's maximum, nor its slew limit: all of it in 4 ms.
  void isLimited() {
    TurningRig rig;
    rig.turnTo(aroundZ(3.0), 1e4);
    Vec3 last = Vec3::Zero();
    ServoSample sample;
    for (int i = 0; i < 4000; ++i) {
      if (i == 3000) rig.turnTo(aroundZ(-3.0), 1e4);
      sample = rig.run();
      QVERIFY(sample.sent.torque.norm() <= kMostTorque * (1.0 + 1e-12));
      QVERIFY((sample.sent.torque - last).norm() <= kMostTorque / 4.0 + 1e-9);
      last = sample.sent.torque;
      if (i != 2999) continue;
      QVERIFY((last - Vec3(0, 0, kMostTorque)).norm() < 1e-9 && sample.actions.has(SafetyAction::Clamp));
    }
  }

  void whatIsNoNumberIsNothing() {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      TurningRig rig;
      rig.turnTo(aroundZ(0.4), 50.0);
      QVERIFY(rig.runMany(4000).sent.torque.z() > 19.0);
      rig.turnTo(Eigen::Quaterniond(1.0, 0.0, bad, 0.0), 50.0);
      ServoSample sample = rig.run();
      QVERIFY(sample.sent.isZero() && sample.actions.has(SafetyAction::NotFinite));
      QVERIFY(rig.runMany(100).sent.isZero());
      // A finite torque comes back, slowly.
      rig.turnTo(aroundZ(0.4), 50.0);
      QVERIFY(rig.run().sent.torque.norm() < 1.0);
      QVERIFY((rig.runMany(4000).sent.torque - Vec3(0, 0, 20)).norm() < 1e-9);
      rig.log->state.orientation.coeffs().setConstant(bad);
      sample = rig.run();
      QVERIFY(sample.sent.isZero() && sample.actions.has(SafetyAction::DeviceFault));
    }
  }

  // The simulated device has the torque that was sent, 3 ms late.
  void theSimulatedDeviceShowsIt() {
    SimulatedDeviceSettings settings = simulatedTorqueDevice();
    QVERIFY(settings.capabilities.outputs == 6 && settings.capabilities.maxTorque > 0.0);
    settings.capabilities.latency = 0.003;
    VirtualClock clock;
    SimulatedDevice device(settings, PoseTrajectory({{0.0, {0, 0, 0}}}), clock);
    QVERIFY(device.open(Progress()).hasValue());
    device.read();
    device.write({Vec3::Zero(), Vec3(1, 2, 3), 0.0});
    clock.set(2 * kMillisecond);
    device.read();
    QVERIFY(device.torque().isZero(0.0));
    clock.set(4 * kMillisecond);
    QCOMPARE(device.read().position, Vec3(0, 0, 0));
    QCOMPARE(device.torque(), Vec3(1, 2, 3));
  }
};

HANDWHEEL_TEST(TorqueTickTest)
#include "TorqueTickTest.moc"
