// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>

#include "TestClass.h"
#include "TickRig.h"

using namespace handwheel;
using namespace handwheel::test;

class ServoTickTest : public QObject {
  Q_OBJECT

 private slots:
  // The whole chain: 2 mm deep in a wall of 1 N/mm.
  void aWallPushesBack() {
    Rig rig;
    rig.channel.scenes.publish(sceneOf(wall(1.0)));
    const ServoSample sample = rig.pressTo(2.0);
    QVERIFY((sample.sent.force - Vec3(-2, 0, 0)).norm() < 1e-12);
    QCOMPARE(rig.log->last.force, sample.sent.force);
    QVERIFY(sample.actions.isEmpty());
    QVERIFY(sample.hasSource && sample.felt.isContact && !sample.felt.isSoftened);
    QCOMPARE(sample.tip.position, Vec3(2, 0, 0));
    QCOMPARE(sample.felt.proxy, Vec3(0, 0, 0));
  }

  void withoutASceneThereIsATipAndNoForce() {
    Rig rig;
    rig.log->state.position = {1, 2, 3};
    const ServoSample sample = rig.runMany(10);
    QCOMPARE(sample.tip.position, Vec3(1, 2, 3));
    QCOMPARE(sample.felt.proxy, Vec3(1, 2, 3));
    QVERIFY(!sample.hasSource);
    QVERIFY(sample.sent.isZero());
    QCOMPARE(rig.log->writes, 10);
  }

  // b/(T/2) = 0.005/0.0005 = 10 N/mm once the loop has measured itself; until then for a loop half as fast.
  void theSceneGetsTheStiffnessLimit() {
    Rig rig;
    QVERIFY(qAbs(rig.run().tip.stiffnessLimit - 5.0) < 1e-9);
    QVERIFY(qAbs(rig.runMany(10000).tip.stiffnessLimit - 10.0) < 1e-6);
    QCOMPARE(rig.run().tip.dampingLimit, 0.005);
  }

  // One mm of the device is ten in the scene: the scene may be a tenth as stiff, to feel the same.
  void theLimitIsThatOfTheScene() {
    Rig rig;
    WorkspaceMapping mapping;
    mapping.scale = 10.0;
    mapping.forceGain = 0.5;
    rig.channel.mapping.write({1, mapping});
    rig.channel.scenes.publish(sceneOf(wall(100.0)));
    QVERIFY(qAbs(rig.runMany(10000).tip.stiffnessLimit - 2.0) < 1e-6);
    rig.log->state.position = {0.5, 0, 0};
    const ServoSample sample = rig.runMany(3000);
    QVERIFY(sample.felt.isSoftened);
    QVERIFY(qAbs(sample.sent.force.x() + 10.0 * 0.5) < 1e-4);  // 10 N/mm at the device
  }

  void velocityIsEstimatedWhereTheDeviceGivesNone() {
    Rig rig;
    ServoSample sample;
    for (int i = 0; i < 50; ++i) {
      rig.log->state.position = {0.1 * i, 0, 0};
      sample = rig.run();
    }
    QVERIFY((sample.tip.velocity - Vec3(100, 0, 0)).norm() < 1e-9);
    rig.log->state.hasVelocity = true;
    rig.log->state.velocity = {0, 7, 0};
    QCOMPARE(rig.run().tip.velocity, Vec3(0, 7, 0));
  }

  // Another model starts the ramp. An edit under the tip does not, and the new source follows the old.
  void scenesLeapOrDoNot() {
    Rig rig;
    rig.channel.scenes.publish(sceneOf(wall(1.0)));
    rig.pressTo(2.0);
    auto edited = sceneOf(wall(1.0), false);
    auto* source = static_cast<FunctionSource*>(edited->renderer.get());
    rig.channel.scenes.publish(std::move(edited));
    ServoSample sample = rig.run();
    QVERIFY(source->followed != nullptr);
    QVERIFY(sample.actions.isEmpty());
    QVERIFY(!sample.tip.isRestart);
    QVERIFY((sample.sent.force - Vec3(-2, 0, 0)).norm() < 1e-12);
    rig.channel.scenes.publish(sceneOf(wall(1.0), true));
    sample = rig.run();
    QVERIFY(sample.actions.has(SafetyAction::Ramp));
    rig.channel.scenes.collect();
  }

  void whatMayLeapIsAnnounced() {
    Rig rig;
    rig.channel.scenes.publish(sceneOf(wall(1.0)));
    rig.pressTo(2.0);
    rig.channel.isDiscontinuous.store(true);
    QVERIFY(rig.run().actions.has(SafetyAction::Ramp));
  }

  void forceIsSwitchedOffAndComesBackByTheRamp() {
    Rig rig;
    rig.channel.scenes.publish(sceneOf(wall(1.0)));
    rig.pressTo(2.0);
    rig.channel.isForceOn.store(false);
    ServoSample sample = rig.runMany(10);
    QVERIFY(sample.sent.isZero());
    QVERIFY(sample.felt.isContact);  // the computed force is still shown
    rig.channel.isForceOn.store(true);
    QVERIFY(rig.run().sent.isZero());
    QVERIFY((rig.runMany(2500).sent.force - Vec3(-2, 0, 0)).norm() < 1e-9);
  }

  // Held by the clutch the tip stays, and nothing pushes the hand; let go, it goes on from there without a leap.
  void theClutchMovesTheHandNotTheTip() {
    Rig rig;
    WorkspaceMapping mapping;
    mapping.clutchButtons = 2;
    rig.channel.mapping.write({1, mapping});
    rig.channel.scenes.publish(sceneOf(wall(1.0)));
    rig.pressTo(2.0);
    rig.log->state.buttons = 2;
    ServoSample sample;
    for (int i = 0; i < 100; ++i) {
      rig.log->state.position += Vec3(-0.3, 0.1, 0);
      sample = rig.run();
      QCOMPARE(sample.tip.position, Vec3(2, 0, 0));
      QVERIFY(sample.tip.velocity.isZero(0.0));
    }
    QVERIFY(sample.sent.isZero());
    rig.log->state.buttons = 0;
    sample = rig.run();
    QVERIFY((sample.tip.position - Vec3(2, 0, 0)).norm() < 1e-9);
    QVERIFY(sample.actions.has(SafetyAction::Ramp));
    QVERIFY(!sample.tip.isRestart);
    rig.log->state.position += Vec3(0.5, 0, 0);
    QVERIFY((rig.run().tip.position - Vec3(2.5, 0, 0)).norm() < 1e-9);
  }

  // The view orbits while the tip is in a wall: the tip stays, the force is turned to the device's new axes; at once if
  // that is hardly felt, else by the ramp.
  void anotherViewKeepsTheTipAndTurnsTheForce() {
    Rig rig;
    rig.channel.scenes.publish(sceneOf(wall(1.0)));
    rig.pressTo(2.0);
    WorkspaceMapping turned;  // the right of the scene is now towards the user
    turned.sceneFromView.linear() << 0, 0, 1, 0, 1, 0, -1, 0, 0;
    rig.channel.mapping.write({1, turned});
    ServoSample sample = rig.run();
    QVERIFY((sample.tip.position - Vec3(2, 0, 0)).norm() < 1e-12);
    QVERIFY(sample.hasSource && !sample.tip.isRestart);
    QVERIFY(sample.actions.has(SafetyAction::Ramp));  // a change of 2.8 N
    QVERIFY(sample.sent.force.norm() < 0.01);
    QVERIFY((rig.runMany(3000).sent.force - Vec3(0, 0, -2)).norm() < 1e-12);
    // Turned by 3 degrees, the force of 2 N changes by 2·2·sin(1.5°) = 0.105 N.
    turned.sceneFromView.linear() *= Eigen::AngleAxisd(3.0 * M_PI / 180.0, Vec3::UnitY()).toRotationMatrix();
    rig.channel.mapping.write({2, turned});
    sample = rig.run();
    QVERIFY(!sample.actions.has(SafetyAction::Ramp));
    QVERIFY(std::abs((sample.sent.force - Vec3(0, 0, -2)).norm() - 4.0 * std::sin(M_PI / 120.0)) < 1e-9);
    turned.keepsTip = false;
    rig.channel.mapping.write({3, turned});
    sample = rig.run();
    QVERIFY((sample.tip.position - turned.sceneFromView.linear() * Vec3(2, 0, 0)).norm() < 1e-12);
    QVERIFY(sample.tip.isRestart);
    QVERIFY(sample.actions.has(SafetyAction::Ramp));
  }

  // A leap that is announced with a mapping in the middle of a tick: the tick that finds the mapping has the ramp.
  void aMappingIsNeverFeltBeforeItsLeap() {
    Rig rig;
    rig.channel.scenes.publish(sceneOf(wall(1.0)));
    rig.pressTo(2.0);
    WorkspaceMapping turned;
    turned.axes[0].isInverted = true;
    auto edited = sceneOf(wall(1.0), false);
    static_cast<FunctionSource*>(edited->renderer.get())->onFollow = [&] {
      rig.channel.isDiscontinuous.store(true);
      rig.channel.mapping.write({1, turned});
    };
    rig.channel.scenes.publish(std::move(edited));
    for (int i = 0; i < 3; ++i) {
      const ServoSample sample = rig.run();
      QVERIFY(sample.felt.force == Vec3(-2, 0, 0));
      const bool isAsBefore = sample.sent.force == Vec3(-2, 0, 0);
      QVERIFY2(isAsBefore || sample.actions.has(SafetyAction::Ramp), "the force turned about without the ramp");
    }
  }

  // A scene carries the mapping that its stiffness was made for: neither is felt without the other.
  void aSceneBringsItsMapping() {
    Rig rig;
    WorkspaceMapping wide, narrow;
    wide.scale = 10.0;
    narrow.scale = 0.1;
    rig.channel.mapping.write({1, wide});
    auto scene = sceneOf(wall(narrow.sceneStiffness(1.0)));
    scene->mapping = {2, narrow};
    rig.channel.scenes.publish(std::move(scene));
    rig.log->state.position = {2, 0, 0};
    ServoSample sample = rig.run();
    QVERIFY((sample.felt.force - Vec3(-2, 0, 0)).norm() < 1e-12);
    sample = rig.run();  // the older one does not come back
    QVERIFY((sample.felt.force - Vec3(-2, 0, 0)).norm() < 1e-12);
  }

  // A pointing device has no motors that could become unstable: no limit, and the force is still reported.
  void aDeviceWithoutMotorsHasNoLimit() {
    Rig rig;
    DeviceCapabilities mouse;
    mouse.outputs = 0;
    mouse.maxForce = 10.0;
    ScriptedDevice device(rig.log, mouse);
    ServoTick tick(device, {}, rig.clock, rig.channel);
    for (int i = 1; i < 3000; ++i) tick.run(i * kMillisecond);
    const ServoSample sample = rig.channel.latest.read();
    QVERIFY(std::isinf(sample.tip.stiffnessLimit));
    QVERIFY(std::isinf(sample.tip.dampingLimit));
  }

  void everyTickIsReported() {
    Rig rig;
    rig.runMany(1000);
    ServoSample sample;
    for (std::uint64_t i = 0; i < 1000; ++i) {
      QVERIFY(rig.channel.samples.pop(sample));
      QCOMPARE(sample.tick, i);
    }
    QVERIFY(!rig.channel.samples.pop(sample));
    QCOMPARE(rig.channel.samples.dropped(), std::uint64_t{0});
  }
};

HANDWHEEL_TEST(ServoTickTest)
#include "ServoTickTest.moc"
