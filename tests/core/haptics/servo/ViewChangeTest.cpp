// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The view changes while the hand presses: the felt force stays.
#include <QtTest>
#include <cmath>

#include "HapticDevices.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "haptics/scene/MeshHaptics.h"
#include "haptics/scene/SceneForces.h"
#include "haptics/servo/ServoLoop.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kViewChangeStiffness = 0.5;  // N/mm at the device
constexpr double kNotch = 1.1892071150;       // 2^(1/4), of the wheel

// A hand whose position the test sets, on the top of a cube of 100 mm at z = 100.
struct ViewChangeFixture {
  std::shared_ptr<ScriptedDevice::Log> log = std::make_shared<ScriptedDevice::Log>();
  VirtualClock clock;
  Service service{"servo"};
  ServoLoop loop{std::make_unique<ScriptedDevice>(log), {}, clock, service};
  ContactSurface surface;
  WorkspaceMapping mapping;
  double leastScale = 1.0;

  ViewChangeFixture() {
    const TriangleSoup soup = cube(100.0);
    surface = ContactSurface(soup.points, soup.triangles);
    mapping.sceneFromView.translation() = Vec3(50, 50, 100);
  }
  std::unique_ptr<HapticScene> scene(bool isDiscontinuous) const {
    MeshHaptics feel;
    feel.surface = TouchedSurface{surface, mapping.sceneStiffness(kViewChangeStiffness), 0.0, {}};
    auto scene = std::make_unique<HapticScene>();
    scene->renderer = std::make_unique<SceneForces>(forceSources(std::move(feel)));
    scene->isDiscontinuous = isDiscontinuous;
    return scene;
  }
  // The proxy lies within the skin of the surface, where a millimetre at the device is least in the scene.
  bool isPushedBy(double newtons) const {
    const double skin = 2.0 * surface.skin() / leastScale;
    return (log->last.force - Vec3(0, 0, newtons)).norm() < kViewChangeStiffness * skin + 1e-9;
  }
  // Presses to a depth below the top, mm at the device, and waits past the ramp.
  void pressTo(double depth) {
    loop.setMapping(mapping, scene(true));
    log->state.position = {0, 0, 5};
    loop.runTicks(1500);
    for (; log->state.position.z() > -depth; log->state.position.z() -= 0.01) loop.runTicks(1);
    log->state.position.z() = -depth;
    loop.runTicks(200);
  }
};

}  // namespace

class ViewChangeTest : public QObject {
  Q_OBJECT

 private slots:
  // 4 mm at 0.5 N/mm are 2 N before and after each notch of the wheel, in and out, for any initial scale; and the
  // displayed proxy stays.
  void zoomingInContactIsNotFelt() {
    for (const double scale : {0.1, 1.0, 3.0}) {
      ViewChangeFixture fixture;
      fixture.mapping.scale = scale;
      fixture.leastScale = scale / 4.0;
      fixture.pressTo(4.0);
      const Vec3 seen = fixture.loop.latest().felt.proxy;
      QVERIFY(fixture.isPushedBy(2.0));
      for (int notch = 0; notch < 24; ++notch) {
        fixture.mapping.scale *= notch < 8 ? 1.0 / kNotch : kNotch;
        fixture.loop.setMapping(fixture.mapping, fixture.scene(false));
        for (int i = 0; i < 30; ++i) {
          fixture.loop.runTicks(1);
          QVERIFY2(fixture.isPushedBy(2.0), qPrintable(QString::number(fixture.log->last.force.z())));
          QVERIFY((fixture.loop.latest().felt.proxy - seen).norm() < 1e-6);
        }
      }
      fixture.log->state.position.z() = -3.5;
      fixture.loop.runTicks(1);
      QVERIFY(fixture.isPushedBy(1.75));
      fixture.log->state.position.z() = 0.01;
      fixture.loop.runTicks(1);
      QVERIFY(fixture.log->last.isZero());
    }
  }

  // Another gain with a scene that was made for it: the same force, too.
  void anotherGainIsNotFelt() {
    ViewChangeFixture fixture;
    fixture.pressTo(4.0);
    fixture.mapping.forceGain = 3.0;
    fixture.loop.setMapping(fixture.mapping, fixture.scene(false));
    fixture.loop.runTicks(1);
    QVERIFY(fixture.isPushedBy(2.0));
  }

  // A view that turns the force of 2 N by so many degrees changes it by 4·sin(half of it): above 0.2 N by the ramp.
  void turningTheForceFarIsByTheRamp() {
    for (const double degrees : {1.0, 5.0, 6.0, 90.0, 180.0}) {
      ViewChangeFixture fixture;
      fixture.pressTo(4.0);
      fixture.mapping.sceneFromView.linear() =
          Eigen::AngleAxisd(degrees * M_PI / 180.0, Vec3::UnitX()).toRotationMatrix();
      fixture.loop.setMapping(fixture.mapping, fixture.scene(false));
      fixture.loop.runTicks(1);
      const double change = 4.0 * std::sin(degrees * M_PI / 360.0);
      QCOMPARE(fixture.loop.latest().actions.has(SafetyAction::Ramp), change > 0.2);
      QVERIFY(fixture.log->last.force.norm() < (change > 0.2 ? 0.01 : 2.0 + 1e-6));
    }
  }
};

HANDWHEEL_TEST(ViewChangeTest)
#include "ViewChangeTest.moc"
