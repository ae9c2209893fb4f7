// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "HandFixture.h"

using namespace handwheel;
using namespace handwheel::test;

// The bodies of a cell under the hand, with the simulated hand instead of a device.
class RigidTouchTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  // A box is pressed while a ball beside it is moved away, and then into the box: only then the ramp takes the force.
  void theRampComesOnlyWhereSomethingMovesAtTheHand() {
    WindowDriver driver;
    HapticSession& session = *driver.window().findChild<HapticSession*>();
    driver.choose("openRobotSample");
    QVERIFY(driver.settle());
    driver.choose("add-box");
    QVERIFY(driver.settle());
    const auto coordinate = [&](const char* property) {
      return driver.find<QWidget>(property)->findChild<QLineEdit*>()->text().toDouble();
    };
    const Vec3 box(coordinate("property/body.1.x"), coordinate("property/body.1.y"), coordinate("property/body.1.z"));
    driver.choose("add-sphere");
    QVERIFY(driver.settle());
    session.choose("simulated", "hand");
    QTRY_VERIFY(session.latest() != nullptr);
    QVERIFY(driver.settle());
    bool hasRamp = false, isHeld = true;
    const auto leadIn = [&] {
      bringHandTo(session, box);
      return session.latest()->felt.isContact && (session.latest()->tip.position - box).norm() < 70.0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(leadIn(), kPatienceMs);
    const auto isSteady = [&] {
      const ServoSample& now = *session.latest();
      return now.felt.isContact && !now.actions.has(SafetyAction::Ramp) && now.sent.force.norm() > 0.01 &&
             now.tip.velocity.norm() < 20.0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isSteady(), kPatienceMs);
    connect(&session, &HapticSession::sampled, this, [&] {
      hasRamp = hasRamp || session.latest()->actions.has(SafetyAction::Ramp);
      isHeld = isHeld && session.latest()->felt.isContact;
    });
    const std::uint64_t scene = session.latest()->scene;
    driver.edit("body.2.y", "900");
    QVERIFY(driver.settle());
    QTRY_VERIFY(session.latest()->scene > scene);
    QTest::qWait(200);
    QVERIFY(!hasRamp && isHeld);
    driver.edit("body.2.y", QString::number(box.y()));
    driver.edit("body.2.x", QString::number(box.x()));
    QTRY_VERIFY(hasRamp);
    session.close();
  }
};

HANDWHEEL_WINDOW_TEST(RigidTouchTest)
#include "RigidTouchTest.moc"
