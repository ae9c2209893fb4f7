// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "GlobeWindow.h"

using namespace handwheel;
using namespace handwheel::test;

// A globe is felt by the simulated hand through a force of its own, in one scene with its poles that attract.
class GlobeTouchTest : public QObject {
  Q_OBJECT

  // Returns the distance at which a pole attracts, mm in the scene: 5 mm at the device, or the value of the kind.
  static double reachOf(const GlobeWindow& globe) { return std::min(3.0, 5.0 * globe.session.mappingInScene().scale); }

 private slots:
  void init() { QSettings().clear(); }

  void isFelt() {
    GlobeWindow globe;
    QVERIFY(globe.begin() && globe.takeHand());
    QVERIFY(!globe.felt().isContact);
    globe.leadTo({14, 0, 0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT((globe.tip() - Vec3(14, 0, 0)).norm() < 0.5, kPatienceMs);
    globe.leadTo({8, 0, 0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(globe.felt().isContact && globe.felt().force.x() > 0.0, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT((globe.felt().proxy - 10.0 * globe.tip().normalized()).norm() < 1e-6, kPatienceMs);
    globe.driver.choose("toggleDocument");  // hidden: nothing is there
    QTRY_VERIFY_WITH_TIMEOUT(!globe.felt().isContact && globe.felt().force.isZero(0.0), kPatienceMs);
    globe.driver.choose("toggleDocument");
    QTRY_VERIFY_WITH_TIMEOUT(globe.felt().isContact, kPatienceMs);
    globe.driver.choose("newWorkpiece");
    QTRY_VERIFY_WITH_TIMEOUT((globe.felt().proxy - 10.0 * globe.tip().normalized()).norm() > 0.1, kPatienceMs);
  }

  // Above the pole only that acts; inside beside it, both.
  void actsBesideSnapping() {
    GlobeWindow globe;
    QVERIFY(globe.begin() && globe.takeHand());
    const double reach = reachOf(globe);
    const auto poleActs = [&] {
      globe.bringTo({0.3 * reach, 0, 10.0 + 0.4 * reach});
      return globe.felt().isHeld && !globe.felt().isContact && globe.felt().force.z() < 0.0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(poleActs(), kPatienceMs);
    QVERIFY((globe.felt().held - Vec3(0, 0, 10)).norm() < 1e-6);
    const auto bothAct = [&] {
      globe.bringTo({0.5 * reach, 0, 10.0 - 0.5 * reach});
      return globe.felt().isContact && globe.felt().isHeld && globe.felt().force.z() > 0.0 &&
             globe.felt().force.x() < 0.0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(bothAct(), kPatienceMs);
    TouchSettings touch = globe.session.touch();
    touch.isSnapping = false;
    globe.session.setTouch(touch);
    const auto oneActs = [&] {
      return globe.felt().isContact && !globe.felt().isHeld && globe.felt().force.cross(globe.tip()).norm() < 1e-6;
    };
    QTRY_VERIFY_WITH_TIMEOUT(oneActs(), kPatienceMs);
  }

  // However stiff the globe is said to be: the scene stays below what the loop carries, and the force below what the
  // device gives.
  void passesTheSafetyChain() {
    GlobeWindow globe;
    QVERIFY(globe.begin() && globe.takeHand());
    TouchSettings touch = globe.session.touch();
    touch.stiffness = 5.0;
    globe.session.setTouch(touch);
    globe.leadTo({0, 0, 3}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(globe.felt().isContact && globe.felt().isSoftened, kPatienceMs);
    const double most = globe.session.capabilities().maxForce;
    for (int i = 0; i < 20; ++i) {
      QTest::qWait(20);
      const ServoSample& now = *globe.session.latest();
      QVERIFY(now.felt.stiffness <= now.tip.stiffnessLimit * (1.0 + 1e-9));
      QVERIFY(now.sent.force.norm() <= most * (1.0 + 1e-9));
    }
  }
};

HANDWHEEL_WINDOW_TEST(GlobeTouchTest)
#include "GlobeTouchTest.moc"
