// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowDriver.h"
#include "../WindowTestMain.h"
#include "MeshShapes.h"
#include "SoupCorners.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/haptics/HapticSession.h"

#include <QDockWidget>
#include <sstream>

using namespace handwheel;
using namespace handwheel::test;

namespace {

bool isSame(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::abs(b);
}

// A ball of this radius about the origin, closed.
constexpr double kRadius = 50.0;

std::vector<Corners> ballOf(int levels, const Vec3& centre, double radius) {
  return cornersOf(moved(icosphere(levels), centre, radius));
}

// A window with a ball in it and the simulated hand open.
struct HandBench {
  WindowDriver driver;
  HapticSession& session;

  HandBench() : session(*driver.window().findChild<HapticSession*>()) {}
  ~HandBench() {
    if (QTest::currentTestFailed() && session.latest()) report();
    session.close();
  }

  bool begin(const QString& file) {
    if (!driver.open(file)) return false;
    session.choose("simulated", "hand");
    return QTest::qWaitFor([this] { return session.latest() != nullptr; }, kPatienceMs) && driver.settle();
  }
  // The hand goes to where this place in the scene is for it.
  void leadTo(const Vec3& place, std::uint32_t buttons = 0) {
    const WorkspaceMapping mapping = session.mappingInScene();
    HandPose pose;
    pose.position = mapping.viewFromDevice().transpose() * (mapping.sceneFromView.inverse() * place) / mapping.scale;
    pose.buttons = buttons;
    session.simulatedHand()->setTarget(pose);
  }
  // The same of a hand that sees where its tip is: one that stayed where it was when the view changed is not where the
  // mapping alone would have it. Said again and again, as the view may still change; not before the tip has come into
  // the scene.
  void bringTo(const Vec3& place) {
    const WorkspaceMapping mapping = session.mappingInScene();
    const Vec3 inView = mapping.sceneFromView.linear().transpose() * (place - now().tip.position);
    HandPose pose;
    pose.position = now().device.position + mapping.viewFromDevice().transpose() * inView / mapping.scale;
    session.simulatedHand()->setTarget(pose);
  }
  // It comes to rest there, touching nothing: one that flies past would go through an open edge, or touch its inside.
  bool arrives(const Vec3& place, double within) {
    const auto isThere = [&] {
      bringTo(place);
      return (now().tip.position - place).norm() < within && now().tip.velocity.norm() < 10.0 * within &&
             !now().felt.isContact;
    };
    return QTest::qWaitFor(isThere, kPatienceMs);
  }
  const ServoSample& now() { return *session.latest(); }
  bool waitForContact() {
    return QTest::qWaitFor([this] { return now().felt.isContact && now().felt.force.norm() > 0.0; }, kPatienceMs);
  }
  // What a test that failed has last felt.
  void report() {
    const ServoSample& s = now();
    std::ostringstream out;
    out << "tip " << s.tip.position.transpose() << ", " << s.tip.velocity.norm() << " mm/s; proxy "
        << s.felt.proxy.transpose() << "; force " << s.felt.force.transpose() << "; contact " << s.felt.isContact
        << ", held " << s.felt.isHeld << ", scale " << session.mappingInScene().scale << ", tick " << s.tick;
    qInfo("%s", out.str().c_str());
  }
};

}  // namespace

// A haptic device in the window, with the simulated hand in its place.
class HapticWindowTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  QString ball() {
    const QString path = m_folder.filePath(QStringLiteral("ball.stl"));
    writeStl(path, ballOf(3, Vec3::Zero(), kRadius));
    return path;
  }
  // Where a place appears in the view.
  static QPoint pixelOf(HandBench& b, const Vec3& place) {
    const auto* view = b.driver.find<Viewport>("viewport");
    const Vec2 at = CameraNavigation(view->camera(), Vec2(view->width(), view->height())).toScreen(place);
    return {static_cast<int>(at.x()), static_cast<int>(at.y())};
  }
  static Vec3 towardsViewer(HandBench& b) { return b.driver.find<Viewport>("viewport")->camera().towardsViewer(); }

 private slots:
  void init() { QSettings().clear(); }

  // Pushed into the ball the tip stays outside, and the hand is pushed back, outwards.
  void theModelIsFelt() {
    HandBench b;
    QVERIFY(b.begin(ball()));
    const Vec3 out = towardsViewer(b);
    b.leadTo(1.3 * kRadius * out);
    QTRY_VERIFY_WITH_TIMEOUT((b.now().tip.position - 1.3 * kRadius * out).norm() < 1.0, kPatienceMs);
    QVERIFY(!b.now().felt.isContact);
    b.leadTo(0.8 * kRadius * out);
    QVERIFY(b.waitForContact());
    QTRY_VERIFY_WITH_TIMEOUT(b.now().sent.force.norm() > 0.05, kPatienceMs);  // after the ramp
    const ForceOut felt = b.now().felt;
    QVERIFY(felt.proxy.norm() > 0.99 * kRadius && felt.proxy.norm() < 1.01 * kRadius);
    QVERIFY(felt.force.normalized().dot(felt.proxy.normalized()) > 0.95);
    QVERIFY(b.now().tip.position.norm() < felt.proxy.norm());
  }

  // With another document in view the one before is not felt any more.
  void onlyWhatIsSeenIsFelt() {
    HandBench b;
    QVERIFY(b.begin(ball()));
    const Vec3 out = towardsViewer(b);
    b.leadTo(0.8 * kRadius * out);
    QVERIFY(b.waitForContact());
    const QString far = m_folder.filePath(QStringLiteral("far.stl"));
    writeStl(far, ballOf(2, Vec3(1e4, 0, 0), 1.0));
    QVERIFY(b.driver.open(far));
    // The tip begins before the other ball, on the side of the viewer, and pushes that one.
    const auto height = [&] { return (b.now().felt.proxy - Vec3(1e4, 0, 0)).dot(towardsViewer(b)); };
    QTRY_VERIFY_WITH_TIMEOUT(!b.now().felt.isContact && height() > 1.0, kPatienceMs);
    const auto isPushed = [&] {
      b.bringTo(Vec3(1e4, 0, 0) + 0.8 * towardsViewer(b));
      return b.now().felt.isContact && std::abs(height() - 1.0) < 0.1;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isPushed(), kPatienceMs);
  }

  // An edit is felt where it was made; undone, what was there is felt again.
  void editsAreFelt() {
    HandBench b;
    QVERIFY(b.begin(ball()));
    const Vec3 out = towardsViewer(b);
    b.leadTo(0.9 * kRadius * out);
    QVERIFY(b.waitForContact());
    b.driver.find<QAction>("selectTool")->trigger();
    auto* view = b.driver.find<Viewport>("viewport");
    QTRY_VERIFY(view->isPickingReady());
    QTest::mouseClick(view, Qt::LeftButton, {}, pixelOf(b, kRadius * out));
    QTRY_VERIFY(b.driver.find<QAbstractButton>("toolAction/delete")->isEnabled());
    b.driver.find<QAbstractButton>("toolAction/delete")->click();
    QVERIFY(b.driver.settle());
    QVERIFY(b.driver.find<QAction>("undo")->isEnabled());
    b.leadTo(1.3 * kRadius * out);
    QTRY_VERIFY_WITH_TIMEOUT(!b.now().felt.isContact, kPatienceMs);
    b.leadTo(0.5 * kRadius * out);  // through the hole
    QTRY_VERIFY_WITH_TIMEOUT(b.now().tip.position.norm() < 0.6 * kRadius, kPatienceMs);
    QVERIFY(!b.now().felt.isContact);
  }

  // The tip on the ball, the first button: what the mouse selects by a click the hand selects by its button.
  void theHandSelects() {
    HandBench b;
    QVERIFY(b.begin(ball()));
    b.driver.find<QAction>("selectTool")->trigger();
    QVERIFY(b.driver.settle());
    const Vec3 out = towardsViewer(b);
    b.leadTo(0.97 * kRadius * out);
    QVERIFY(b.waitForContact());
    QVERIFY(!b.driver.find<QAbstractButton>("toolAction/delete")->isEnabled());
    b.leadTo(0.97 * kRadius * out, 1);
    QTRY_COMPARE_WITH_TIMEOUT(b.now().device.buttons, 1u, kPatienceMs);
    b.leadTo(0.97 * kRadius * out, 0);
    QTRY_VERIFY(b.driver.find<QAbstractButton>("toolAction/delete")->isEnabled());
    QVERIFY(!b.driver.find<QAction>("undo")->isEnabled());
  }

  // Nearer, the same motion of the hand is a finer one, and the tip stays where it is; out of view, it comes back.
  void theWorkspaceFollowsTheCamera() {
    HandBench b;
    QVERIFY(b.begin(ball()));
    auto* view = b.driver.find<Viewport>("viewport");
    const Vec3 place = 1.2 * kRadius * towardsViewer(b);
    b.leadTo(place);
    QTRY_VERIFY_WITH_TIMEOUT((b.now().tip.position - place).norm() < 1.0, kPatienceMs);
    const double scale = b.session.mappingInScene().scale;
    CameraState camera = view->camera();
    camera.centre = place;
    camera.height /= 2.0;
    view->setCamera(camera);
    // On a busy machine the loop takes over a mapping late; the hand rests, so a wrong one would stay wrong.
    QTRY_VERIFY_WITH_TIMEOUT(isSame(b.session.mappingInScene().scale, scale / 2.0), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT((b.now().tip.position - place).norm() < 1.0, kPatienceMs);
    camera.centre += 10.0 * camera.height * camera.right();
    view->setCamera(camera);
    QTRY_VERIFY_WITH_TIMEOUT((b.now().tip.position - camera.centre).norm() < 1.1 * camera.height, kPatienceMs);
  }

  // Stiffness is meant at the hand: in a view of half the height the scene is twice as stiff.
  void aModelFeelsAlikeFromAfarAndNear() {
    HandBench b;
    QVERIFY(b.begin(ball()));
    auto* view = b.driver.find<Viewport>("viewport");
    const auto stiffnessAtHand = [&] {
      const ServoSample sample = b.now();
      const double depth = (sample.felt.proxy - sample.tip.position).norm();
      const WorkspaceMapping mapping = b.session.mappingInScene();
      return sample.felt.isContact && depth > 0.0 && !sample.felt.isSoftened
                 ? mapping.deviceForce(sample.felt.force).norm() / (depth / mapping.scale)
                 : 0.0;
    };
    b.session.setTouch({0.05, 0.0, 0.0});  // what the loop carries here, too
    for (const double height : {150.0, 75.0}) {
      CameraState camera = view->camera();
      camera.height = height;
      view->setCamera(camera);
      b.leadTo(0.9 * kRadius * towardsViewer(b));
      QVERIFY(b.waitForContact());
      QTRY_VERIFY_WITH_TIMEOUT(std::abs(stiffnessAtHand() - 0.05) < 1e-6, kPatienceMs);
    }
    b.session.setTouch({});
  }

  // What is chosen in the Fidelity panel holds for the open device: its loop and what it feels. The stiffness that is
  // set beside the device is the same.
  void fidelityHoldsForTheOpenDevice() {
    QSettings().remove("fidelity");
    HandBench b;
    auto& choice = *b.driver.window().findChild<FidelityChoice*>();
    choice.set("servo.rate", 500.0);
    QVERIFY(b.begin(ball()));
    QCOMPARE(b.session.measure()->periods().binSeconds(), 0.002 / 64.0);
    b.driver.find<QDockWidget>("fidelityDock")->show();
    b.driver.edit("servo.rate", "2000");
    QTRY_COMPARE_WITH_TIMEOUT(b.session.measure()->periods().binSeconds(), 0.0005 / 64.0, kPatienceMs);
    b.driver.edit("servo.velocity_window", "0.005");
    QCOMPARE(b.session.servo().velocityWindow, 0.005);
    b.driver.edit("contact.stiffness", "2");
    QCOMPARE(b.session.touch().stiffness, 2.0);
    b.session.setTouch({0.25, 0.0, 0.0});
    QCOMPARE(choice.of("contact.stiffness"), 0.25);
    choice.use(FidelityValues());
    QCOMPARE(b.session.touch().stiffness, 0.5);
    QTRY_COMPARE_WITH_TIMEOUT(b.session.measure()->periods().binSeconds(), 0.001 / 64.0, kPatienceMs);
  }

  // A point of an open edge draws the tip while a tool for such points is in use, and no other.
  void pointsOfOpenEdgesDrawTheTip() {
    HandBench b;
    const QString path = m_folder.filePath(QStringLiteral("torus.stl"));
    writeStl(path, torusWithHole());
    QVERIFY(b.begin(path));
    // Of the edge of its hole, and which way is out there.
    const double u = 2.0 * M_PI * 6 / 48, v = 2.0 * M_PI * 5 / 24, r = 30.0 + 10.0 * std::cos(v);
    const Vec3 point(r * std::cos(u), r * std::sin(u), 10.0 * std::sin(v));
    const Vec3 out(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
    const auto isDrawn = [&] {
      b.bringTo(point + 0.4 * out);
      return (b.now().felt.proxy - point).norm() < 1e-3;
    };
    b.leadTo(point + 30.0 * out);
    QVERIFY(b.arrives(point + 30.0 * out, 1.0));
    QVERIFY(b.arrives(point + 0.4 * out, 0.1));
    QTest::qWait(100);
    QVERIFY(!isDrawn() && b.now().felt.force.isZero(0.0));
    b.driver.find<QAction>("boundaryTool")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(isDrawn(), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(b.now().felt.force.dot(out) < 0.0, kPatienceMs);
    b.driver.find<QAction>("sculptTool")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!isDrawn() && b.now().felt.force.isZero(0.0), kPatienceMs);
  }

  // Between two points of an open edge: switched off nothing draws the tip, whatever the tool; with rims as curves it
  // is the whole rim that does, and no edge that a tool could take.
  void snappingIsSwitchedAndRimsAreCurves() {
    HandBench b;
    const QString path = m_folder.filePath(QStringLiteral("torus.stl"));
    writeStl(path, torusWithHole());
    QVERIFY(b.begin(path));
    const auto at = [](int i) {
      const double u = 2.0 * M_PI * i / 48, v = 2.0 * M_PI * 5 / 24, r = 30.0 + 10.0 * std::cos(v);
      return Vec3(r * std::cos(u), r * std::sin(u), 10.0 * std::sin(v));
    };
    const Vec3 middle = 0.5 * (at(5) + at(6)), along = (at(6) - at(5)).normalized();
    const Vec3 hand = middle + 0.4 * Vec3(middle.x(), middle.y(), 0.0).normalized() + Vec3(0, 0, 0.4);
    const auto isDrawn = [&] {
      b.bringTo(hand);
      const Vec3 off = b.now().felt.proxy - middle;
      return (off - off.dot(along) * along).norm() < 1e-3 && !b.now().felt.force.isZero(0.0);
    };
    b.driver.find<QAction>("boundaryTool")->trigger();
    b.leadTo(hand + 30.0 * towardsViewer(b));
    QVERIFY(b.arrives(hand + 30.0 * towardsViewer(b), 1.0));
    QVERIFY(b.arrives(hand + 3.0 * towardsViewer(b), 0.1));
    QTRY_VERIFY_WITH_TIMEOUT(isDrawn() && b.now().felt.isHeld, kPatienceMs);
    b.driver.find<QAction>("snapDevice")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!isDrawn() && b.now().felt.force.isZero(0.0), kPatienceMs);
    TouchSettings touch = b.session.touch();
    touch.hasRimCurves = true;
    b.session.setTouch(touch);
    b.driver.choose("snapDevice");
    QTRY_VERIFY_WITH_TIMEOUT(isDrawn() && !b.now().felt.isHeld, kPatienceMs);
    touch = b.session.touch();
    touch.hasRimCurves = false;
    b.session.setTouch(touch);
    QTRY_VERIFY_WITH_TIMEOUT(isDrawn() && b.now().felt.isHeld, kPatienceMs);
  }

  // What a tool takes by a click draws the tip: beside a cube its edge and its corner to measure from, above one of its
  // sides the side to select.
  void whatAToolTakesDrawsTheTip() {
    HandBench b;
    const QString path = m_folder.filePath(QStringLiteral("cube.stl"));
    writeStl(path, cornersOf(cube(20.0)));
    QVERIFY(b.begin(path));
    // A hand that goes there through the air, and is drawn from there to a place.
    const auto isDrawn = [&](const Vec3& hand, const Vec3& place) {
      b.leadTo(hand + 20.0 * towardsViewer(b));
      if (!QTest::qWaitFor([&] { return (b.now().tip.position - hand).norm() > 10.0; }, kPatienceMs)) return false;
      return QTest::qWaitFor(
          [&] {
            b.bringTo(hand);
            return (b.now().felt.proxy - place).norm() < 0.2 && b.now().felt.force.dot(place - hand) > 0.0 &&
                   !b.now().felt.isContact;
          },
          kPatienceMs);
    };
    b.driver.find<QAction>("measureTool")->trigger();
    QVERIFY(isDrawn({10.0, -0.6, 20.6}, {10, 0, 20}));
    QVERIFY(b.now().felt.isHeld);
    QVERIFY(isDrawn({20.6, 20.6, 20.6}, {20, 20, 20}));
    b.driver.find<QAction>("selectTool")->trigger();
    QVERIFY(isDrawn({7.0, 6.0, 21.0}, {7, 6, 20}));
    QVERIFY(!b.now().felt.isHeld);
    b.driver.find<QAction>("sculptTool")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(b.now().felt.force.isZero(0.0), kPatienceMs);
  }

  // Only what is near the tip is looked at, and anew where the tip has gone on.
  void magnetsFollowTheTip() {
    HandBench b;
    const QString path = m_folder.filePath(QStringLiteral("torus.stl"));
    writeStl(path, torusWithHole());
    QVERIFY(b.begin(path));
    b.driver.find<QAction>("measureTool")->trigger();
    for (const int i : {6, 30, 16}) {
      const double u = 2.0 * M_PI * i / 48, v = 2.0 * M_PI * 5 / 24, r = 30.0 + 10.0 * std::cos(v);
      const Vec3 point(r * std::cos(u), r * std::sin(u), 10.0 * std::sin(v));
      const Vec3 out(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
      const auto isDrawn = [&] {
        b.bringTo(point + 0.4 * out);
        return b.now().felt.isHeld && (b.now().felt.proxy - point).norm() < 1e-3;
      };
      b.leadTo(point + 10.0 * out);
      QVERIFY(b.arrives(point + 10.0 * out, 1.0));
      QTRY_VERIFY_WITH_TIMEOUT(isDrawn(), kPatienceMs);
    }
  }

  // A drag of the hand is one step, and while it lasts the tool pulls at the hand.
  void aDragIsOneStep() {
    HandBench b;
    QVERIFY(b.begin(ball()));
    b.driver.find<QAction>("sculptTool")->trigger();
    QVERIFY(b.driver.settle());
    const Vec3 out = towardsViewer(b);
    b.leadTo(0.97 * kRadius * out);
    QVERIFY(b.waitForContact());
    b.leadTo(0.97 * kRadius * out, 1);
    QTRY_COMPARE_WITH_TIMEOUT(b.now().device.buttons, 1u, kPatienceMs);
    b.leadTo(1.2 * kRadius * out, 1);
    QTRY_VERIFY_WITH_TIMEOUT(b.now().tip.position.norm() > 1.1 * kRadius, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(b.now().felt.force.dot(out) < -0.01, kPatienceMs);  // back to where it took hold
    b.leadTo(1.2 * kRadius * out, 0);
    QTRY_VERIFY_WITH_TIMEOUT(b.driver.find<QAction>("undo")->isEnabled(), kPatienceMs);
    QVERIFY(b.driver.settle());
    QTRY_VERIFY_WITH_TIMEOUT(b.now().felt.force.isZero(0.0), kPatienceMs);
    b.driver.find<QAction>("undo")->trigger();
    QVERIFY(!b.driver.find<QAction>("undo")->isEnabled());
  }

  // The tip of the mouse lies on the surface; turned away from the user, the wheel pushes it in and the surface pushes
  // back, while the camera stays. With Ctrl the wheel is the camera's.
  void theMouseAsADevice() {
    HandBench b;
    QVERIFY(b.driver.open(ball()));
    b.session.choose("mouse", "pointer");
    auto* view = b.driver.find<Viewport>("viewport");
    QTRY_VERIFY_WITH_TIMEOUT(b.session.latest() && view->isPickingReady() && b.driver.window().isSettled(),
                             kPatienceMs);
    const QPoint middle = pixelOf(b, kRadius * towardsViewer(b));
    QTest::mouseMove(view, middle + QPoint(5, 5));
    QTest::mouseMove(view, middle);
    const auto isOnBall = [&] { return std::abs(b.now().tip.position.norm() - kRadius) < 0.02 * kRadius; };
    QTRY_VERIFY_WITH_TIMEOUT(isOnBall() && b.now().device.status == DeviceStatus::Ready, kPatienceMs);
    const double height = view->camera().height;
    const auto turn = [&](Qt::KeyboardModifiers keys) {
      QWheelEvent wheel(middle, view->mapToGlobal(middle), {}, {0, 480}, Qt::NoButton, keys, Qt::NoScrollPhase, false);
      QCoreApplication::sendEvent(view, &wheel);
    };
    turn({});
    QTRY_VERIFY_WITH_TIMEOUT(b.now().felt.isContact, kPatienceMs);
    QVERIFY(b.now().felt.force.dot(towardsViewer(b)) > 0.0);
    QVERIFY(isOnBall() || b.now().tip.position.norm() < kRadius);
    QCOMPARE(view->camera().height, height);
    turn(Qt::ControlModifier);
    QVERIFY(view->camera().height < height);
  }

  // Nothing of all that without a device.
  void withoutADeviceThereIsNoScene() {
    WindowDriver driver;
    QVERIFY(driver.open(ball()));
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
