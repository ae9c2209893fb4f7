// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "window/haptics/DeviceMapping.h"

#include <rapidcheck.h>
#include <QtTest>

using namespace handwheel;

namespace {

double number(double least, double largest) {
  return least + (largest - least) * *rc::gen::inRange(0, 1 << 20) / double(1 << 20);
}

Vec3 anyPosition(double far) {
  return {number(-far, far), number(-far, far), number(-far, far)};
}

CameraState anyCamera() {
  CameraState camera;
  camera.centre = anyPosition(1e3);
  camera.orientation =
      Eigen::Quaterniond(Eigen::AngleAxisd(number(0.0, 6.0), (anyPosition(1.0) + Vec3(0, 0, 1.5)).normalized()));
  camera.height = number(0.1, 1e4);
  return camera;
}

DeviceCapabilities falcon() {
  DeviceCapabilities device;
  device.workspaceRadius = 40.0;
  device.buttons = 4;
  return device;
}

}  // namespace

class DeviceMappingTest : public QObject {
  Q_OBJECT

 private slots:
  // Seen in the view, the border of the workspace lies at the border of the view.
  void theWorkspaceFillsTheView() {
    QVERIFY(rc::check([] {
      const CameraState camera = anyCamera();
      const WorkspaceMapping mapping = mappingInView({}, falcon(), camera, Box());
      const Vec3 top = mapping.sceneFromView * Vec3(0.0, mapping.scale * 40.0, 0.0);
      const Vec3 seen = camera.orientation.conjugate() * (top - camera.centre);
      RC_ASSERT((seen - Vec3(0.0, camera.height / 2.0, 0.0)).norm() <= 1e-9 * (camera.height + camera.centre.norm()));
    }));
  }

  // At rest the tip is before the model, unless the view shows so little of it that its front cannot be reached.
  void restIsBeforeTheModel() {
    QVERIFY(rc::check([] {
      const CameraState camera = anyCamera();
      Box model;
      model.extend(Vec3(camera.centre + anyPosition(200.0)));
      model.extend(Vec3(camera.centre + anyPosition(200.0)));
      const Vec3 rest = mappingInView({}, falcon(), camera, model).sceneFromView.translation();
      const double depth = (rest - camera.centre).dot(camera.towardsViewer());
      RC_ASSERT(depth >= 0.0 && depth <= 0.5 * camera.height * (1.0 + 1e-9) + 1e-9);
      if (depth >= 0.499 * camera.height) return;
      for (int i = 0; i < 8; ++i) {
        const Vec3 corner = model.corner(static_cast<Box::CornerType>(i));
        RC_ASSERT((corner - rest).dot(camera.towardsViewer()) <= 1e-9 * (1.0 + rest.norm()));
      }
    }));
  }

  // Seen from near, the surface that is seen counts, however deep the model is: rest lies before it.
  void restIsBeforeWhatIsSeen() {
    QVERIFY(rc::check([] {
      const CameraState camera = anyCamera();
      const double depth = number(-200.0, 200.0);
      const Vec3 seen = camera.centre + depth * camera.towardsViewer();
      const Box model(Vec3(camera.centre - Vec3::Constant(1e3)), Vec3(camera.centre + Vec3::Constant(1e3)));
      const Vec3 rest = mappingInView({}, falcon(), camera, model, seen).sceneFromView.translation();
      const double before = (rest - seen).dot(camera.towardsViewer());
      RC_ASSERT(before > 0.0 && before < 0.5 * camera.height);
    }));
  }

  // A device that does not say how far it reaches is taken at its word, mm for mm.
  void withoutAWorkspaceLengthsAreLengths() {
    CameraState camera;
    camera.height = 300.0;
    QCOMPARE(mappingInView({}, {}, camera, Box()).scale, 1.0);
  }

  void whatIsSeen() {
    CameraState camera;
    camera.centre = Vec3(5.0, 0.0, 0.0);
    camera.height = 10.0;
    QVERIFY(isInView(camera, Vec3(9.9, 4.9, -4.9)));
    QVERIFY(!isInView(camera, Vec3(-0.1, 0.0, 0.0)));
    QVERIFY(!isInView(camera, Vec3(NAN, 0.0, 0.0)));
  }

  // Seen as one stands at a lathe: to the right is along, towards the eye is away from the axis that the tool is
  // before.
  void axesAtALathe() {
    const Ray axis{Vec3::Zero(), Vec3::UnitZ()};
    WorkspaceMapping mapping;
    mapping.sceneFromView.linear() << 0, 0, 1,  // x of the scene is towards the eye,
        0, -1, 0,                               // y down,
        1, 0, 0;                                // z to the right
    const Vec3 tip(30.0, 0.0, 50.0);
    using All = std::array<AboutAxis, 3>;
    QVERIFY((axesAbout(axis, mapping, tip) == All{AboutAxis::Along, AboutAxis::Across, AboutAxis::Radius}));
    // Above the work, up is the radius.
    QVERIFY(
        (axesAbout(axis, mapping, {0.0, -30.0, 50.0}) == All{AboutAxis::Along, AboutAxis::Radius, AboutAxis::Across}));
    // Motions in front of and above the work at 37° both change the radius: neither is called radius or across.
    QVERIFY((axesAbout(axis, mapping, {40.0, -30.0, 50.0}) ==
             All{AboutAxis::Along, AboutAxis::Oblique, AboutAxis::Oblique}));
    // The user has exchanged x and y of the device.
    mapping.axes = {DeviceAxis{1, false}, DeviceAxis{0, true}, DeviceAxis{2, false}};
    QVERIFY((axesAbout(axis, mapping, tip) == All{AboutAxis::Across, AboutAxis::Along, AboutAxis::Radius}));
    // On the axis there is no radius; between two directions none is said.
    QVERIFY(axesAbout(axis, WorkspaceMapping(), Vec3::Zero())[0] == AboutAxis::Oblique);
    WorkspaceMapping oblique;
    oblique.sceneFromView.linear() = Eigen::AngleAxisd(0.25 * M_PI, Vec3::UnitY()).toRotationMatrix();
    QVERIFY((axesAbout(axis, oblique, tip) == All{AboutAxis::Oblique, AboutAxis::Across, AboutAxis::Oblique}));
  }

  void devicesWithAThirdButtonHaveAClutch() {
    QCOMPARE(standardMapping(falcon()).clutchButtons, 4u);
    DeviceCapabilities two;
    two.buttons = 2;
    QCOMPARE(standardMapping(two).clutchButtons, 0u);
    two.isRateControl = true;
    two.workspaceRadius = 10.0;
    QVERIFY(standardMapping(two).isRateControl && standardMapping(two).deadZone > 0.0);
  }
};

HANDWHEEL_TEST(DeviceMappingTest)
#include "DeviceMappingTest.moc"
