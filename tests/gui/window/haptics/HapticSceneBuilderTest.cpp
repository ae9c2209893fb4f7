// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/HapticSceneBuilder.h"

#include "OwnSettings.h"
#include "TestClass.h"
#include "window/WindowServices.h"
#include "window/haptics/HapticSession.h"

#include <QSettings>
#include <QThreadPool>
#include <QtTest>

using namespace handwheel;

namespace {

constexpr int kLongestMs = 120000;  // a busy machine softens forces for a minute

// The simulated hand, and a scene for it. Lengths and forces are those at the device.
struct TouchSceneFixture {
  QThreadPool pool;
  JobRunner jobs{JobRunner::Policy::Queue, pool};
  WindowServices services;
  MonotonicClock clock;
  std::unique_ptr<HapticSession> session =
      std::make_unique<HapticSession>(HapticSession::Parts{jobs, pool, services, clock});
  std::unique_ptr<HapticSceneBuilder> scene = std::make_unique<HapticSceneBuilder>(*session);

  ~TouchSceneFixture() {
    scene.reset();
    session.reset();
    pool.waitForDone();
  }
  bool begin() {
    session->choose("simulated", "hand");
    return QTest::qWaitFor([this] { return session->latest() != nullptr; }, kLongestMs);
  }
  Vec3 inScene(const Vec3& position) const {
    const WorkspaceMapping mapping = session->mappingInScene();
    return mapping.sceneFromView * (mapping.scale * (mapping.viewFromDevice() * position));
  }
  // Points that draw from so far.
  void offer(std::initializer_list<Vec3> points, double distance) {
    SnapFeatures features;
    for (const Vec3& point : points) features.addPoint(0, inScene(point));
    scene->setSnap(SnapField(features), distance * session->mappingInScene().scale, false);
  }
  void lead(const Vec3& position) {
    HandPose pose;
    pose.position = position;
    session->simulatedHand()->setTarget(pose);
  }
  // The tip at the last tick, and the force that the scene requested there.
  Vec3 tip() const { return session->latest()->device.position; }
  Vec3 force() const { return session->mappingInScene().deviceForce(session->latest()->felt.force); }
  bool isSoftened() const { return session->latest()->felt.isSoftened; }
};

// He 2008, figure 3-2a and equations 3-1 to 3-3.
double forceOf(SnapShape shape, double k, double ls, double x) {
  if (!(x > 0.0 && x < ls)) return 0.0;
  const auto g = [&](double at) { return std::exp(-0.5 * std::pow((at - ls / 2) / (ls / 6), 2)); };
  switch (shape) {
    case SnapShape::Spring:
      return k * x;
    case SnapShape::Triangular:
      return x <= ls / 2 ? k * x : k * (ls - x);
    case SnapShape::Quadratic:
      return k * x * (ls - x) * 2 / ls;
    case SnapShape::Gaussian:
      return k * ls / 2 * (g(x) - g(0)) / (1 - g(0));
  }
  return 0.0;
}

Vec3 drawn(SnapShape shape, double k, double ls, const Vec3& point, const Vec3& tip) {
  return forceOf(shape, k, ls, (point - tip).norm()) * (point - tip).stableNormalized();
}

}  // namespace

// The feel of snapping follows the settings.
class HapticSceneBuilderTest : public QObject {
  Q_OBJECT

 private:
  test::OwnSettings m_settings;

 private slots:
  void initTestCase() { m_settings.use(); }
  void init() { QSettings().clear(); }

  // A tool turns the hand on a device that has motors for it: by what it asks for, at most as stiffly as the device is.
  void turnsTheHand() {
    TouchSceneFixture fixture;
    fixture.session->choose("simulated", "turned-hand");
    QVERIFY(QTest::qWaitFor([&] { return fixture.session->latest() != nullptr; }, kLongestMs));
    const double stiffest = fixture.session->capabilities().maxAngularStiffness;
    QVERIFY(stiffest > 0.0);
    constexpr double kAngle = 0.1;
    for (const double asked : {0.1 * stiffest, 5.0 * stiffest}) {
      DeviceSpring spring;
      spring.turn = Eigen::AngleAxisd(kAngle, Vec3::UnitX()) * fixture.session->latest()->tip.orientation;
      spring.turning = asked;
      fixture.scene->setSprings({spring});
      const double expected = kAngle * std::min(asked, stiffest);
      const auto isSent = [&] {
        const ServoSample& sample = *fixture.session->latest();
        const Vec3 torque = fixture.session->mappingInScene().deviceTorque(sample.felt.torque);
        return std::abs(torque.norm() - expected) < 1e-6 * stiffest && (sample.sent.torque - torque).norm() < 1e-6;
      };
      QVERIFY(QTest::qWaitFor(isSent, kLongestMs));
    }
  }

  void snapsByTheProfileThatWasChosen_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<double>("stiffness");
    const char* const names[] = {"spring", "triangle", "quadratic", "gaussian"};
    for (int shape = 0; shape < 4; ++shape)
      for (const double stiffness : {0.1, 0.3})
        QTest::addRow("%s, %g N/mm", names[shape], stiffness) << shape << stiffness;
  }
  void snapsByTheProfileThatWasChosen() {
    QFETCH(int, shape);
    QFETCH(double, stiffness);
    TouchSceneFixture fixture;
    QVERIFY(fixture.begin());
    fixture.offer({Vec3::Zero()}, 4.0);
    TouchSettings touch = fixture.session->touch();
    touch.snapShape = static_cast<SnapShape>(shape);
    touch.snapStiffness = stiffness;
    fixture.session->setTouch(touch);
    // The profiles differ here: a spring of 0.3 N/mm against the hand's draws it to about half of that.
    fixture.lead({3.4, 0.0, 0.0});
    const auto isFelt = [&] {
      const Vec3 wanted = drawn(touch.snapShape, stiffness, 4.0, Vec3::Zero(), fixture.tip());
      return !fixture.isSoftened() && wanted.norm() > 0.02 && (fixture.force() - wanted).norm() < 1e-6;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isFelt(), kLongestMs);
    for (int other = 0; other < 4; ++other) {
      if (other == shape) continue;
      const Vec3 differs = drawn(static_cast<SnapShape>(other), stiffness, 4.0, Vec3::Zero(), fixture.tip());
      if ((fixture.tip().norm() - 2.0) > 0.1) QVERIFY((fixture.force() - differs).norm() > 1e-4);
    }
  }

  // Between two points the proxy has one of them; the forces of both add up to less.
  void snapsByTheMethodThatWasChosen() {
    const Vec3 left(-1.0, 0.0, 0.0), right(1.0, 0.0, 0.0);
    TouchSceneFixture fixture;
    QVERIFY(fixture.begin());
    fixture.offer({left, right}, 4.0);
    fixture.lead({0.5, 1.0, 0.0});
    TouchSettings touch = fixture.session->touch();
    touch.snapStiffness =
        0.05;  // both together must be within the stiffness that the loop carries on a busy machine, too
    fixture.session->setTouch(touch);
    const auto pull = [&](const Vec3& point) {
      return drawn(touch.snapShape, touch.snapStiffness, 4.0, point, fixture.tip());
    };
    const auto isNear = [&](const Vec3& wanted) {
      return wanted.norm() > 0.01 && (fixture.force() - wanted).norm() < 1e-6;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isNear(pull(right)) || isNear(pull(left)), kLongestMs);
    touch.snapMethod = SnapMethod::Sum;
    fixture.session->setTouch(touch);
    QTRY_VERIFY_WITH_TIMEOUT(!fixture.isSoftened() && isNear(pull(left) + pull(right)), kLongestMs);
  }

  // Switched off, it attracts nothing, whoever offered it.
  void snapsOnlyWhereThatIsOn() {
    TouchSceneFixture fixture;
    QVERIFY(fixture.begin());
    fixture.offer({Vec3::Zero()}, 4.0);
    fixture.lead({2.5, 0.0, 0.0});
    QTRY_VERIFY_WITH_TIMEOUT(fixture.force().norm() > 0.1, kLongestMs);
    TouchSettings touch = fixture.session->touch();
    touch.isSnapping = false;
    fixture.session->setTouch(touch);
    QTRY_VERIFY_WITH_TIMEOUT(fixture.force().isZero(0.0), kLongestMs);
    touch.isSnapping = true;
    fixture.session->setTouch(touch);
    QTRY_VERIFY_WITH_TIMEOUT(fixture.force().norm() > 0.1, kLongestMs);
  }

  // The stiffness of the feature is another at once; what is sent waits for the ramp.
  void aChangeComesByTheRamp() {
    TouchSceneFixture fixture;
    QVERIFY(fixture.begin());
    fixture.offer({Vec3::Zero()}, 4.0);
    fixture.lead({2.5, 0.0, 0.0});
    const auto isRamped = [&] { return fixture.session->latest()->actions.has(SafetyAction::Ramp); };
    QTRY_VERIFY_WITH_TIMEOUT(!isRamped() && fixture.force().norm() > 0.1, kLongestMs);
    TouchSettings touch = fixture.session->touch();
    touch.snapShape = SnapShape::Spring;
    fixture.session->setTouch(touch);
    QTRY_VERIFY_WITH_TIMEOUT(isRamped(), kLongestMs);
    QTRY_VERIFY_WITH_TIMEOUT(!isRamped() && fixture.force().norm() > 0.1, kLongestMs);
  }
};

HANDWHEEL_WIDGET_TEST(HapticSceneBuilderTest)
#include "HapticSceneBuilderTest.moc"
