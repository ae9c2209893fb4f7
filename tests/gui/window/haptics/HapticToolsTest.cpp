// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "HandFixture.h"
#include "panels/device/AxisBars.h"

#include <QDockWidget>

using namespace handwheel;
using namespace handwheel::test;

// Tools in the simulated hand: what they take draws the tip, and what the hand does with them is an edit.
class HapticToolsTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

 private slots:
  void init() { QSettings().clear(); }

  // An edit is felt where it was made; undone, what was there is felt again.
  void editsAreFelt() {
    HandFixture fixture;
    QVERIFY(fixture.begin(ballIn(m_folder)));
    const Vec3 out = fixture.towardsViewer();
    fixture.leadTo(0.9 * kRadius * out);
    QVERIFY(fixture.waitForContact());
    fixture.driver.find<QAction>("selectTool")->trigger();
    auto* view = fixture.driver.find<Viewport>("viewport");
    QTRY_VERIFY(view->isPickingReady());
    QTest::mouseClick(view, Qt::LeftButton, {}, fixture.pixelOf(kRadius * out));
    QTRY_VERIFY(fixture.driver.find<QAbstractButton>("toolAction/delete")->isEnabled());
    fixture.driver.find<QAbstractButton>("toolAction/delete")->click();
    QVERIFY(fixture.driver.settle());
    QVERIFY(fixture.driver.find<QAction>("undo")->isEnabled());
    fixture.leadTo(1.3 * kRadius * out);
    QTRY_VERIFY_WITH_TIMEOUT(!fixture.now().felt.isContact, kPatienceMs);
    fixture.leadTo(0.5 * kRadius * out);  // through the hole
    QTRY_VERIFY_WITH_TIMEOUT(fixture.now().tip.position.norm() < 0.6 * kRadius, kPatienceMs);
    QVERIFY(!fixture.now().felt.isContact);
  }

  // The tip on the ball, the first button: what the mouse selects by a click the hand selects by its button.
  void theHandSelects() {
    HandFixture fixture;
    QVERIFY(fixture.begin(ballIn(m_folder)));
    fixture.driver.find<QAction>("selectTool")->trigger();
    QVERIFY(fixture.driver.settle());
    const Vec3 out = fixture.towardsViewer();
    QVERIFY(!fixture.driver.find<QAbstractButton>("toolAction/delete")->isEnabled());
    QVERIFY(fixture.pressOnBall(out));
    fixture.leadTo(0.97 * kRadius * out, 0);
    QTRY_VERIFY(fixture.driver.find<QAbstractButton>("toolAction/delete")->isEnabled());
    QVERIFY(!fixture.driver.find<QAction>("undo")->isEnabled());
  }

  // While the knobs of the panel have the focus, they take the arrows, and the tool takes its keys.
  void keysWhileTheKnobsHaveTheFocus() {
    HandFixture fixture;
    QVERIFY(fixture.begin(ballIn(m_folder)));
    auto* const dock = fixture.driver.find<QDockWidget>("deviceDock");
    dock->show();
    dock->raise();
    auto* const knobs = fixture.driver.find<AxisBars>("axisBars");
    QTRY_VERIFY(knobs->isVisible() && knobs->focusPolicy() != Qt::NoFocus);
    fixture.driver.find<QAction>("selectTool")->trigger();
    QVERIFY(fixture.driver.settle());
    const Vec3 out = fixture.towardsViewer();
    QVERIFY(fixture.pressOnBall(out));
    fixture.leadTo(0.97 * kRadius * out, 0);
    QTRY_VERIFY(fixture.driver.find<QAbstractButton>("toolAction/delete")->isEnabled());
    QSignalSpy led(knobs, &AxisBars::handLed);
    fixture.driver.window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&fixture.driver.window()));
    knobs->setFocus();
    QVERIFY(knobs->hasFocus());
    QTest::keyClick(knobs, Qt::Key_Right);
    QCOMPARE(led.count(), 1);
    QVERIFY(!fixture.driver.find<QAction>("undo")->isEnabled());
    QTest::keyClick(knobs, Qt::Key_Delete);
    QVERIFY(fixture.driver.settle());
    QTRY_VERIFY(fixture.driver.find<QAction>("undo")->isEnabled());
    QCOMPARE(led.count(), 1);
  }

  // A point of an open edge draws the tip while a tool for such points is in use, and no other.
  void pointsOfOpenEdgesDrawTheTip() {
    HandFixture fixture;
    const QString path = m_folder.filePath(QStringLiteral("torus.stl"));
    writeStl(path, torusWithHole());
    QVERIFY(fixture.begin(path));
    // A point on the edge of its hole, and the outward direction there.
    const double u = 2.0 * M_PI * 6 / 48, v = 2.0 * M_PI * 5 / 24, r = 30.0 + 10.0 * std::cos(v);
    const Vec3 point(r * std::cos(u), r * std::sin(u), 10.0 * std::sin(v));
    const Vec3 out(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
    const auto isDrawn = [&] {
      fixture.bringTo(point + 0.4 * out);
      return (fixture.now().felt.proxy - point).norm() < 1e-3;
    };
    fixture.leadTo(point + 30.0 * out);
    QVERIFY(fixture.arrives(point + 30.0 * out, 1.0));
    QVERIFY(fixture.arrives(point + 0.4 * out, 0.1));
    QTest::qWait(100);
    QVERIFY(!isDrawn() && fixture.now().felt.force.isZero(0.0));
    fixture.driver.find<QAction>("boundaryTool")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(isDrawn(), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(fixture.now().felt.force.dot(out) < 0.0, kPatienceMs);
    fixture.driver.find<QAction>("sculptTool")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!isDrawn() && fixture.now().felt.force.isZero(0.0), kPatienceMs);
  }

  // Between two points of an open edge: switched off nothing draws the tip, whatever the tool; with rims as curves it
  // is the whole rim that does, and no edge that a tool could take.
  void snappingIsSwitchedAndRimsAreCurves() {
    HandFixture fixture;
    const QString path = m_folder.filePath(QStringLiteral("torus.stl"));
    writeStl(path, torusWithHole());
    QVERIFY(fixture.begin(path));
    const auto at = [](int i) {
      const double u = 2.0 * M_PI * i / 48, v = 2.0 * M_PI * 5 / 24, r = 30.0 + 10.0 * std::cos(v);
      return Vec3(r * std::cos(u), r * std::sin(u), 10.0 * std::sin(v));
    };
    const Vec3 middle = 0.5 * (at(5) + at(6)), along = (at(6) - at(5)).normalized();
    const Vec3 hand = middle + 0.4 * Vec3(middle.x(), middle.y(), 0.0).normalized() + Vec3(0, 0, 0.4);
    const auto isDrawn = [&] {
      fixture.bringTo(hand);
      const Vec3 off = fixture.now().felt.proxy - middle;
      return (off - off.dot(along) * along).norm() < 1e-3 && !fixture.now().felt.force.isZero(0.0);
    };
    fixture.driver.find<QAction>("boundaryTool")->trigger();
    fixture.leadTo(hand + 30.0 * fixture.towardsViewer());
    QVERIFY(fixture.arrives(hand + 30.0 * fixture.towardsViewer(), 1.0));
    QVERIFY(fixture.arrives(hand + 3.0 * fixture.towardsViewer(), 0.1));
    QTRY_VERIFY_WITH_TIMEOUT(isDrawn() && fixture.now().felt.isHeld, kPatienceMs);
    fixture.driver.find<QAction>("snapDevice")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!isDrawn() && fixture.now().felt.force.isZero(0.0), kPatienceMs);
    TouchSettings touch = fixture.session.touch();
    touch.hasBoundaryCurves = true;
    fixture.session.setTouch(touch);
    fixture.driver.choose("snapDevice");
    QTRY_VERIFY_WITH_TIMEOUT(isDrawn() && !fixture.now().felt.isHeld, kPatienceMs);
    touch = fixture.session.touch();
    touch.hasBoundaryCurves = false;
    fixture.session.setTouch(touch);
    QTRY_VERIFY_WITH_TIMEOUT(isDrawn() && fixture.now().felt.isHeld, kPatienceMs);
  }

  // Features that a click of the tool can pick attract the tip: beside a cube its edge and its corner to measure from,
  // above one of its sides the side to select.
  void whatAToolTakesDrawsTheTip() {
    HandFixture fixture;
    const QString path = m_folder.filePath(QStringLiteral("cube.stl"));
    writeStl(path, cornersOf(cube(20.0)));
    QVERIFY(fixture.begin(path));
    // Moves a hand there through the air, and checks that it is drawn from there to a position.
    const auto isDrawn = [&](const Vec3& hand, const Vec3& position) {
      fixture.leadTo(hand + 20.0 * fixture.towardsViewer());
      if (!QTest::qWaitFor([&] { return (fixture.now().tip.position - hand).norm() > 10.0; }, kPatienceMs))
        return false;
      return QTest::qWaitFor(
          [&] {
            fixture.bringTo(hand);
            return (fixture.now().felt.proxy - position).norm() < 0.2 &&
                   fixture.now().felt.force.dot(position - hand) > 0.0 && !fixture.now().felt.isContact;
          },
          kPatienceMs);
    };
    fixture.driver.find<QAction>("measureTool")->trigger();
    QVERIFY(isDrawn({10.0, -0.6, 20.6}, {10, 0, 20}));
    QVERIFY(fixture.now().felt.isHeld);
    QVERIFY(isDrawn({20.6, 20.6, 20.6}, {20, 20, 20}));
    fixture.driver.find<QAction>("selectTool")->trigger();
    QVERIFY(isDrawn({7.0, 6.0, 21.0}, {7, 6, 20}));
    QVERIFY(!fixture.now().felt.isHeld);
    fixture.driver.find<QAction>("sculptTool")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(fixture.now().felt.force.isZero(0.0), kPatienceMs);
  }

  // Only what is near the tip is looked at, and anew where the tip has gone on.
  void magnetsFollowTheTip() {
    HandFixture fixture;
    const QString path = m_folder.filePath(QStringLiteral("torus.stl"));
    writeStl(path, torusWithHole());
    QVERIFY(fixture.begin(path));
    fixture.driver.find<QAction>("measureTool")->trigger();
    for (const int i : {6, 30, 16}) {
      const double u = 2.0 * M_PI * i / 48, v = 2.0 * M_PI * 5 / 24, r = 30.0 + 10.0 * std::cos(v);
      const Vec3 point(r * std::cos(u), r * std::sin(u), 10.0 * std::sin(v));
      const Vec3 out(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
      const auto isDrawn = [&] {
        fixture.bringTo(point + 0.4 * out);
        return fixture.now().felt.isHeld && (fixture.now().felt.proxy - point).norm() < 1e-3;
      };
      fixture.leadTo(point + 10.0 * out);
      QVERIFY(fixture.arrives(point + 10.0 * out, 1.0));
      QTRY_VERIFY_WITH_TIMEOUT(isDrawn(), kPatienceMs);
    }
  }

  // A drag of the hand is one step, and while it lasts the tool pulls at the hand.
  void aDragIsOneStep() {
    HandFixture fixture;
    QVERIFY(fixture.begin(ballIn(m_folder)));
    fixture.driver.find<QAction>("sculptTool")->trigger();
    QVERIFY(fixture.driver.settle());
    const Vec3 out = fixture.towardsViewer();
    QVERIFY(fixture.pressOnBall(out));
    fixture.leadTo(1.2 * kRadius * out, 1);
    QTRY_VERIFY_WITH_TIMEOUT(fixture.now().tip.position.norm() > 1.1 * kRadius, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(fixture.now().felt.force.dot(out) < -0.01, kPatienceMs);  // back to where it took hold
    fixture.leadTo(1.2 * kRadius * out, 0);
    QTRY_VERIFY_WITH_TIMEOUT(fixture.driver.find<QAction>("undo")->isEnabled(), kPatienceMs);
    QVERIFY(fixture.driver.settle());
    QTRY_VERIFY_WITH_TIMEOUT(fixture.now().felt.force.isZero(0.0), kPatienceMs);
    fixture.driver.find<QAction>("undo")->trigger();
    QVERIFY(!fixture.driver.find<QAction>("undo")->isEnabled());
  }
};

HANDWHEEL_WINDOW_TEST(HapticToolsTest)
#include "HapticToolsTest.moc"
