// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/device/MouseDevice.h"

#include <QtTest>
#include <atomic>

#include "HapticDevices.h"
#include "TestClass.h"
#include "haptics/servo/ServoLoop.h"

using namespace handwheel;
using namespace handwheel::test;

class MouseDeviceTest : public QObject {
  Q_OBJECT

 private slots:
  void isWhereThePointerIs() {
    MouseDevice mouse;
    QVERIFY(mouse.read().status == DeviceStatus::Absent);
    mouse.point({1, 2, 3}, 5);
    QVERIFY(mouse.read().status == DeviceStatus::Absent);  // not open
    QVERIFY(mouse.open(Progress()).hasValue());
    mouse.point({1, 2, 3}, 5);
    QCOMPARE(mouse.read().position, Vec3(1, 2, 3));
    QCOMPARE(mouse.read().buttons, 5u);
    mouse.leave();
    QVERIFY(mouse.read().status == DeviceStatus::Absent);
    mouse.point({4, 2, 3}, 0);
    mouse.close();
    QVERIFY(mouse.read().status == DeviceStatus::Absent);
  }

  // Through the whole loop: a wall far stiffer than any device could be, far from the origin, and the force to draw.
  void showsTheForce() {
    auto made = std::make_unique<MouseDevice>();
    MouseDevice& mouse = *made;
    QVERIFY(mouse.open(Progress()).hasValue());
    VirtualClock clock;
    Service service("servo");
    ServoLoop loop(std::move(made), {}, clock, service);
    const double far = 1e7;  // mm
    loop.setScene(sceneOf([=](const TipState& tip, ForceOut& out) {
      TipState near = tip;
      near.position.x() -= far;
      wall(50.0)(near, out);
      out.proxy.x() += far;
    }));
    mouse.point({far - 500, 0, 0}, 0);
    loop.runTicks(2000);
    QVERIFY(mouse.force().isZero(0.0));
    mouse.point({far + 0.1, 0, 0}, 0);  // thrown there within a tick: 500 m/s
    loop.runTicks(1000);
    QVERIFY((mouse.force() - Vec3(-5, 0, 0)).norm() < 1e-6);
    mouse.leave();
    loop.runTicks(1);
    QVERIFY(mouse.force().isZero(0.0));
  }

  void theWheelGoesOnFromTheSurface() {
    PointerDepth depth;
    const Vec3 eye(1, 0, 0), away(0, 0, -1);
    depth.setSurface(50.0);
    QCOMPARE(depth.positionOn(eye, away), Vec3(1, 0, -50));
    depth.turnWheel(3.0, 2.0);
    QCOMPARE(depth.positionOn(eye, away), Vec3(1, 0, -56));
    depth.setSurface(40.0);
    QCOMPARE(depth.positionOn(eye, away), Vec3(1, 0, -46));
    depth.resetWheel();
    QCOMPARE(depth.positionOn(eye, away), Vec3(1, 0, -40));
    depth.turnWheel(-100.0, 2.0);
    QCOMPARE(depth.positionOn(eye, away), eye);
  }
};

HANDWHEEL_TEST(MouseDeviceTest)
#include "MouseDeviceTest.moc"
