// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "HandFixture.h"
#include "window/fidelity/FidelityChoice.h"

#include <QDockWidget>

using namespace handwheel;
using namespace handwheel::test;

namespace {

bool isSame(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::abs(b);
}

}  // namespace

// A haptic device in the window, replaced by the simulated hand.
class HapticWindowTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

 private slots:
  void init() { QSettings().clear(); }

  // Pushed into the ball the tip stays outside, and the hand is pushed back, outwards.
  void theModelIsFelt() {
    HandFixture fixture;
    QVERIFY(fixture.begin(ballIn(m_folder)));
    const Vec3 out = fixture.towardsViewer();
    fixture.leadTo(1.3 * kRadius * out);
    QTRY_VERIFY_WITH_TIMEOUT((fixture.now().tip.position - 1.3 * kRadius * out).norm() < 1.0, kPatienceMs);
    QVERIFY(!fixture.now().felt.isContact);
    fixture.leadTo(0.8 * kRadius * out);
    QVERIFY(fixture.waitForContact());
    QTRY_VERIFY_WITH_TIMEOUT(fixture.now().sent.force.norm() > 0.05, kPatienceMs);  // after the ramp
    const ForceOut felt = fixture.now().felt;
    QVERIFY(felt.proxy.norm() > 0.99 * kRadius && felt.proxy.norm() < 1.01 * kRadius);
    QVERIFY(felt.force.normalized().dot(felt.proxy.normalized()) > 0.95);
    QVERIFY(fixture.now().tip.position.norm() < felt.proxy.norm());
  }

  // With another document in view the one before is not felt any more.
  void onlyWhatIsSeenIsFelt() {
    HandFixture fixture;
    QVERIFY(fixture.begin(ballIn(m_folder)));
    const Vec3 out = fixture.towardsViewer();
    fixture.leadTo(0.8 * kRadius * out);
    QVERIFY(fixture.waitForContact());
    const QString far = m_folder.filePath(QStringLiteral("far.stl"));
    writeStl(far, ballOf(2, Vec3(1e4, 0, 0), 1.0));
    QVERIFY(fixture.driver.open(far));
    // The tip begins before the other ball, on the side of the viewer, and pushes that one.
    const auto height = [&] { return (fixture.now().felt.proxy - Vec3(1e4, 0, 0)).dot(fixture.towardsViewer()); };
    QTRY_VERIFY_WITH_TIMEOUT(!fixture.now().felt.isContact && height() > 1.0, kPatienceMs);
    const auto isPushed = [&] {
      fixture.bringTo(Vec3(1e4, 0, 0) + 0.8 * fixture.towardsViewer());
      return fixture.now().felt.isContact && std::abs(height() - 1.0) < 0.1;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isPushed(), kPatienceMs);
  }

  // Nearer, the same motion of the hand is a finer one, and the tip stays where it is; out of view, it comes back.
  void theWorkspaceFollowsTheCamera() {
    HandFixture fixture;
    QVERIFY(fixture.begin(ballIn(m_folder)));
    auto* view = fixture.driver.find<Viewport>("viewport");
    const Vec3 position = 1.2 * kRadius * fixture.towardsViewer();
    fixture.leadTo(position);
    QTRY_VERIFY_WITH_TIMEOUT((fixture.now().tip.position - position).norm() < 1.0, kPatienceMs);
    const double scale = fixture.session.mappingInScene().scale;
    CameraState camera = view->camera();
    camera.centre = position;
    camera.height /= 2.0;
    view->setCamera(camera);
    // On a busy machine the loop takes over a mapping late; the hand rests, so a wrong one would stay wrong.
    QTRY_VERIFY_WITH_TIMEOUT(isSame(fixture.session.mappingInScene().scale, scale / 2.0), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT((fixture.now().tip.position - position).norm() < 1.0, kPatienceMs);
    camera.centre += 10.0 * camera.height * camera.right();
    view->setCamera(camera);
    QTRY_VERIFY_WITH_TIMEOUT((fixture.now().tip.position - camera.centre).norm() < 1.1 * camera.height, kPatienceMs);
  }

  // Stiffness is meant at the hand: in a view of half the height the scene is twice as stiff.
  void aModelFeelsAlikeFromAfarAndNear() {
    HandFixture fixture;
    QVERIFY(fixture.begin(ballIn(m_folder)));
    auto* view = fixture.driver.find<Viewport>("viewport");
    const auto stiffnessAtHand = [&] {
      const ServoSample sample = fixture.now();
      const double depth = (sample.felt.proxy - sample.tip.position).norm();
      const WorkspaceMapping mapping = fixture.session.mappingInScene();
      return sample.felt.isContact && depth > 0.0 && !sample.felt.isSoftened
                 ? mapping.deviceForce(sample.felt.force).norm() / (depth / mapping.scale)
                 : 0.0;
    };
    fixture.session.setTouch({0.05, 0.0, 0.0});  // a stiffness that the loop carries here, too
    for (const double height : {150.0, 75.0}) {
      CameraState camera = view->camera();
      camera.height = height;
      view->setCamera(camera);
      fixture.leadTo(0.9 * kRadius * fixture.towardsViewer());
      QVERIFY(fixture.waitForContact());
      QTRY_VERIFY_WITH_TIMEOUT(std::abs(stiffnessAtHand() - 0.05) < 1e-6, kPatienceMs);
    }
    fixture.session.setTouch({});
  }

  // A choice in the Fidelity panel holds for the open device: its loop and its forces. The stiffness that is set beside
  // the device is the same.
  void fidelityHoldsForTheOpenDevice() {
    QSettings().remove("fidelity");
    HandFixture fixture;
    auto& choice = *fixture.driver.window().findChild<FidelityChoice*>();
    choice.set("servo.rate", 500.0);
    QVERIFY(fixture.begin(ballIn(m_folder)));
    QCOMPARE(fixture.session.measure()->periods().binSeconds(), 0.002 / 64.0);
    fixture.driver.find<QDockWidget>("fidelityDock")->show();
    fixture.driver.edit("servo.rate", "2000");
    QTRY_COMPARE_WITH_TIMEOUT(fixture.session.measure()->periods().binSeconds(), 0.0005 / 64.0, kPatienceMs);
    fixture.driver.edit("servo.velocity_window", "0.005");
    QCOMPARE(fixture.session.servo().velocityWindow, 0.005);
    fixture.driver.edit("contact.stiffness", "2");
    QCOMPARE(fixture.session.touch().stiffness, 2.0);
    fixture.session.setTouch({0.25, 0.0, 0.0});
    QCOMPARE(choice.of("contact.stiffness"), 0.25);
    choice.use(FidelityValues());
    QCOMPARE(fixture.session.touch().stiffness, 0.5);
    QTRY_COMPARE_WITH_TIMEOUT(fixture.session.measure()->periods().binSeconds(), 0.001 / 64.0, kPatienceMs);
  }

  // After a restart the mouse turns the view again, even if an older program has stored it as device.
  void theMouseAsDeviceEndsWithTheProgram() {
    for (const bool isStored : {false, true}) {
      {
        HandFixture fixture;
        fixture.session.choose("mouse", "pointer");
        QTRY_VERIFY_WITH_TIMEOUT(fixture.session.mouse(), kPatienceMs);
      }
      if (isStored) QSettings().setValue("haptics/driver", "mouse");
      if (isStored) QSettings().setValue("haptics/address", "pointer");
      HandFixture fixture;
      fixture.session.takeUp();
      QVERIFY(fixture.session.chosen().driver.empty());
      QVERIFY(fixture.driver.settle());
      QVERIFY(!fixture.session.isOpen());
    }
  }

  // The tip of the mouse lies on the surface; turned away from the user, the wheel pushes it in and the surface pushes
  // back, while the camera stays. With Ctrl the wheel is the camera's.
  void theMouseAsADevice() {
    HandFixture fixture;
    QVERIFY(fixture.driver.open(ballIn(m_folder)));
    fixture.session.choose("mouse", "pointer");
    auto* view = fixture.driver.find<Viewport>("viewport");
    QTRY_VERIFY_WITH_TIMEOUT(fixture.session.latest() && view->isPickingReady() && fixture.driver.window().isSettled(),
                             kPatienceMs);
    const QPoint middle = fixture.pixelOf(kRadius * fixture.towardsViewer());
    QTest::mouseMove(view, middle + QPoint(5, 5));
    QTest::mouseMove(view, middle);
    const auto isOnBall = [&] { return std::abs(fixture.now().tip.position.norm() - kRadius) < 0.02 * kRadius; };
    QTRY_VERIFY_WITH_TIMEOUT(isOnBall() && fixture.now().device.status == DeviceStatus::Ready, kPatienceMs);
    const double height = view->camera().height;
    const auto turn = [&](Qt::KeyboardModifiers keys) {
      QWheelEvent wheel(middle, view->mapToGlobal(middle), {}, {0, 480}, Qt::NoButton, keys, Qt::NoScrollPhase, false);
      QCoreApplication::sendEvent(view, &wheel);
    };
    turn({});
    QTRY_VERIFY_WITH_TIMEOUT(fixture.now().felt.isContact, kPatienceMs);
    QVERIFY(fixture.now().felt.force.dot(fixture.towardsViewer()) > 0.0);
    QVERIFY(isOnBall() || fixture.now().tip.position.norm() < kRadius);
    QCOMPARE(view->camera().height, height);
    turn(Qt::ControlModifier);
    QVERIFY(view->camera().height < height);
  }

  // Nothing of all that without a device.
  void withoutADeviceThereIsNoScene() {
    WindowDriver driver;
    QVERIFY(driver.open(ballIn(m_folder)));
    auto* view = driver.find<Viewport>("viewport");
    auto& session = *driver.window().findChild<HapticSession*>();
    QVERIFY(!session.isOpen() && !session.latest());
    view->grabImage();
    QTest::qWait(300);
    const int frames = view->framesDrawn();
    QTest::qWait(200);
    QCOMPARE(view->framesDrawn(), frames);
  }
};

HANDWHEEL_WINDOW_TEST(HapticWindowTest)
#include "HapticWindowTest.moc"
