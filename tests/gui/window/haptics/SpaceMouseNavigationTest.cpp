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
    CapFixture b;
    QVERIFY(b.begin(ball()));
    QCOMPARE(b.device.names(), std::vector<std::string>{"SpaceMouse Compact"});
    QVERIFY(!b.session.isOpen());
    const auto waitFor = [&](auto isThere) {
      return QTest::qWaitFor([&] { return isThere(b.view.camera()); }, kPatienceMs);
    };
    const CameraState start = b.rest();
    b.translation = {350, 0, 0};
    QVERIFY(waitFor(
        [&](const CameraState& c) { return (c.centre - start.centre).dot(start.right()) < -0.1 * start.height; }));
    const CameraState right = b.rest();
    QVERIFY(std::abs((right.centre - start.centre).dot(start.up())) < 1e-9 * start.height);
    QVERIFY(right.orientation.isApprox(start.orientation) && right.height == start.height);
    b.translation = {0, 0, -350};  // Z is down
    QVERIFY(
        waitFor([&](const CameraState& c) { return (c.centre - right.centre).dot(start.up()) < -0.1 * start.height; }));
    const CameraState up = b.rest();
    b.translation = {0, 350, 0};
    QVERIFY(waitFor([&](const CameraState& c) { return c.height < 0.8 * start.height; }));
    const CameraState near = b.rest();
    QVERIFY((near.centre - up.centre).norm() < 1e-9 * start.height);
    b.rotation = {0, 0, -350};  // anticlockwise from above
    QVERIFY(waitFor([&](const CameraState& c) { return c.orientation.angularDistance(near.orientation) > 0.3; }));
    const Eigen::AngleAxisd turned(near.orientation.conjugate() * b.rest().orientation);
    QVERIFY((turned.axis() * (turned.angle() > 0 ? 1.0 : -1.0) + Vec3::UnitY()).norm() <
            1e-6);  // the camera goes clockwise
  }

  void besideAHapticDevice() {
    CapFixture b;
    QVERIFY(b.begin(ball()));
    b.session.choose("simulated", "hand");
    QTRY_VERIFY_WITH_TIMEOUT(b.session.latest(), kPatienceMs);
    const CameraState start = b.rest();
    b.translation = {350, 0, 0};
    QTRY_VERIFY_WITH_TIMEOUT((b.view.camera().centre - start.centre).norm() > 0.1 * start.height, kPatienceMs);
    QCOMPARE(b.session.status(), DeviceStatus::Ready);
    QVERIFY(b.session.simulatedHand());
  }

  // Chosen as the device it leads the tip, and only that.
  void chosenItLeadsTheTip() {
    CapFixture b;
    QVERIFY(b.begin(ball()));
    b.session.choose("spacemouse", "/dev/hidraw0");
    QVERIFY(b.device.names().empty());
    QTRY_VERIFY_WITH_TIMEOUT(b.session.latest(), kPatienceMs);
    const CameraState start = b.rest();
    const Vec3 tip = b.session.latest()->tip.position;
    b.translation = {350, 0, 0};
    QTRY_VERIFY_WITH_TIMEOUT((b.session.latest()->tip.position - tip).norm() > 1.0, kPatienceMs);
    QVERIFY(b.view.camera() == start);
    b.translation = {};
    b.session.close();
    QVERIFY(b.waitForNavigation(true));
  }

  void unpluggedAndPluggedInAgain() {
    CapFixture b;
    QVERIFY(b.begin(ball()));
    b.plug(false);
    QVERIFY(b.waitForNavigation(false));
    b.plug(true);
    QVERIFY(b.waitForNavigation(true));
  }

  void switchedOff() {
    CapFixture b;
    QVERIFY(b.begin(ball()));
    b.device.setMotion(false, 1.0);
    const CameraState start = b.rest();
    b.translation = {350, 0, 0};
    QTest::qWait(300);
    QVERIFY(b.view.camera() == start);
    b.device.setMotion(true, 1.0);
    QTRY_VERIFY_WITH_TIMEOUT(!(b.view.camera() == start), kPatienceMs);
  }

  // Without a node of a device nothing is looked for, and no plugin loaded.
  void withoutADeviceNothingIsLoaded() {
    CapFixture b;
    b.device.watch({b.dev.path()});
    QTest::qWait(1500);
    QVERIFY(b.session.finder().found().empty() && b.device.names().empty());
  }
};

HANDWHEEL_WINDOW_TEST(SpaceMouseNavigationTest)
#include "SpaceMouseNavigationTest.moc"
