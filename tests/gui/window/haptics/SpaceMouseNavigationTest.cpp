// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/SpaceMouseNavigation.h"

#include "../WindowTestMain.h"
#include "CapFixture.h"
#include "MeshShapes.h"
#include "SoupCorners.h"

using namespace handwheel;
using namespace handwheel::test;

// A SpaceMouse moves the view as soon as it is plugged in, beside any haptic device.
class SpaceMouseNavigationTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;
  QString ball() {
    const QString path = m_folder.filePath(QStringLiteral("ball.stl"));
    writeStl(path, cornersOf(moved(icosphere(3), Vec3::Zero(), 50.0)));
    return path;
  }

 private slots:
  void init() { QSettings().clear(); }

  // Nobody has opened the panel of devices. The model goes where the cap is pushed: right, up, towards the user.
  void theModelFollowsTheCap() {
    CapFixture fixture;
    QVERIFY(fixture.begin(ball()));
    QCOMPARE(fixture.device.names(), std::vector<std::string>{"SpaceMouse Compact"});
    QVERIFY(!fixture.session.isOpen());
    const auto waitFor = [&](auto isThere) {
      return QTest::qWaitFor([&] { return isThere(fixture.view.camera()); }, kPatienceMs);
    };
    const CameraState start = fixture.rest();
    fixture.translation = {350, 0, 0};
    QVERIFY(waitFor(
        [&](const CameraState& c) { return (c.centre - start.centre).dot(start.right()) < -0.1 * start.height; }));
    const CameraState right = fixture.rest();
    QVERIFY(std::abs((right.centre - start.centre).dot(start.up())) < 1e-9 * start.height);
    QVERIFY(right.orientation.isApprox(start.orientation) && right.height == start.height);
    fixture.translation = {0, 0, -350};  // Z is down
    QVERIFY(
        waitFor([&](const CameraState& c) { return (c.centre - right.centre).dot(start.up()) < -0.1 * start.height; }));
    const CameraState up = fixture.rest();
    fixture.translation = {0, 350, 0};
    QVERIFY(waitFor([&](const CameraState& c) { return c.height < 0.8 * start.height; }));
    const CameraState near = fixture.rest();
    QVERIFY((near.centre - up.centre).norm() < 1e-9 * start.height);
    fixture.rotation = {0, 0, -350};  // anticlockwise from above
    QVERIFY(waitFor([&](const CameraState& c) { return c.orientation.angularDistance(near.orientation) > 0.3; }));
    const Eigen::AngleAxisd turned(near.orientation.conjugate() * fixture.rest().orientation);
    QVERIFY((turned.axis() * (turned.angle() > 0 ? 1.0 : -1.0) + Vec3::UnitY()).norm() <
            1e-6);  // the camera goes clockwise
  }

  void besideAHapticDevice() {
    CapFixture fixture;
    QVERIFY(fixture.begin(ball()));
    fixture.session.choose("simulated", "hand");
    QTRY_VERIFY_WITH_TIMEOUT(fixture.session.latest(), kPatienceMs);
    const CameraState start = fixture.rest();
    fixture.translation = {350, 0, 0};
    QTRY_VERIFY_WITH_TIMEOUT((fixture.view.camera().centre - start.centre).norm() > 0.1 * start.height, kPatienceMs);
    QCOMPARE(fixture.session.status(), DeviceStatus::Ready);
    QVERIFY(fixture.session.simulatedHand());
  }

  // Chosen as the device it leads the tip, and only that.
  void chosenItLeadsTheTip() {
    CapFixture fixture;
    QVERIFY(fixture.begin(ball()));
    fixture.session.choose("spacemouse", "/dev/hidraw0");
    QVERIFY(fixture.device.names().empty());
    QTRY_VERIFY_WITH_TIMEOUT(fixture.session.latest(), kPatienceMs);
    const CameraState start = fixture.rest();
    const Vec3 tip = fixture.session.latest()->tip.position;
    fixture.translation = {350, 0, 0};
    QTRY_VERIFY_WITH_TIMEOUT((fixture.session.latest()->tip.position - tip).norm() > 1.0, kPatienceMs);
    QVERIFY(fixture.view.camera() == start);
    fixture.translation = {};
    fixture.session.close();
    QVERIFY(fixture.waitForNavigation(true));
  }

  void unpluggedAndPluggedInAgain() {
    CapFixture fixture;
    QVERIFY(fixture.begin(ball()));
    fixture.plug(false);
    QVERIFY(fixture.waitForNavigation(false));
    fixture.plug(true);
    QVERIFY(fixture.waitForNavigation(true));
  }

  void switchedOff() {
    CapFixture fixture;
    QVERIFY(fixture.begin(ball()));
    fixture.device.setMotion(false, 1.0);
    const CameraState start = fixture.rest();
    fixture.translation = {350, 0, 0};
    QTest::qWait(300);
    QVERIFY(fixture.view.camera() == start);
    fixture.device.setMotion(true, 1.0);
    QTRY_VERIFY_WITH_TIMEOUT(!(fixture.view.camera() == start), kPatienceMs);
  }

  // Without a node of a device nothing is looked for, and no plugin loaded.
  void withoutADeviceNothingIsLoaded() {
    CapFixture fixture;
    fixture.device.watch({fixture.dev.path()});
    QTest::qWait(1500);
    QVERIFY(fixture.session.finder().found().empty() && fixture.device.names().empty());
  }
};

HANDWHEEL_WINDOW_TEST(SpaceMouseNavigationTest)
#include "SpaceMouseNavigationTest.moc"
