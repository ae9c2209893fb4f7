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
    HandFixture b;
    QVERIFY(b.begin(ballIn(m_folder)));
    const Vec3 out = b.towardsViewer();
    b.leadTo(0.9 * kRadius * out);
    QVERIFY(b.waitForContact());
    b.driver.find<QAction>("selectTool")->trigger();
    auto* view = b.driver.find<Viewport>("viewport");
    QTRY_VERIFY(view->isPickingReady());
    QTest::mouseClick(view, Qt::LeftButton, {}, b.pixelOf(kRadius * out));
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
    HandFixture b;
    QVERIFY(b.begin(ballIn(m_folder)));
    b.driver.find<QAction>("selectTool")->trigger();
    QVERIFY(b.driver.settle());
    const Vec3 out = b.towardsViewer();
    QVERIFY(!b.driver.find<QAbstractButton>("toolAction/delete")->isEnabled());
    QVERIFY(b.pressOnBall(out));
    b.leadTo(0.97 * kRadius * out, 0);
    QTRY_VERIFY(b.driver.find<QAbstractButton>("toolAction/delete")->isEnabled());
    QVERIFY(!b.driver.find<QAction>("undo")->isEnabled());
  }

  // While the knobs of the panel have the focus, they take the arrows, and the tool takes its keys.
  void keysWhileTheKnobsHaveTheFocus() {
    HandFixture b;
    QVERIFY(b.begin(ballIn(m_folder)));
    auto* const dock = b.driver.find<QDockWidget>("deviceDock");
    dock->show();
    dock->raise();
    auto* const knobs = b.driver.find<AxisBars>("axisBars");
    QTRY_VERIFY(knobs->isVisible() && knobs->focusPolicy() != Qt::NoFocus);
    b.driver.find<QAction>("selectTool")->trigger();
    QVERIFY(b.driver.settle());
    const Vec3 out = b.towardsViewer();
    QVERIFY(b.pressOnBall(out));
    b.leadTo(0.97 * kRadius * out, 0);
    QTRY_VERIFY(b.driver.find<QAbstractButton>("toolAction/delete")->isEnabled());
    QSignalSpy led(knobs, &AxisBars::handLed);
    QTest::keyClick(knobs, Qt::Key_Right);
    QCOMPARE(led.count(), 1);
    QVERIFY(!b.driver.find<QAction>("undo")->isEnabled());
    QTest::keyClick(knobs, Qt::Key_Delete);
    QVERIFY(b.driver.settle());
    QTRY_VERIFY(b.driver.find<QAction>("undo")->isEnabled());
    QCOMPARE(led.count(), 1);
  }

  // A point of an open edge draws the tip while a tool for such points is in use, and no other.
  void pointsOfOpenEdgesDrawTheTip() {
    HandFixture b;
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
    HandFixture b;
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
    b.leadTo(hand + 30.0 * b.towardsViewer());
    QVERIFY(b.arrives(hand + 30.0 * b.towardsViewer(), 1.0));
    QVERIFY(b.arrives(hand + 3.0 * b.towardsViewer(), 0.1));
    QTRY_VERIFY_WITH_TIMEOUT(isDrawn() && b.now().felt.isHeld, kPatienceMs);
    b.driver.find<QAction>("snapDevice")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!isDrawn() && b.now().felt.force.isZero(0.0), kPatienceMs);
    TouchSettings touch = b.session.touch();
    touch.hasBoundaryCurves = true;
    b.session.setTouch(touch);
    b.driver.choose("snapDevice");
    QTRY_VERIFY_WITH_TIMEOUT(isDrawn() && !b.now().felt.isHeld, kPatienceMs);
    touch = b.session.touch();
    touch.hasBoundaryCurves = false;
    b.session.setTouch(touch);
    QTRY_VERIFY_WITH_TIMEOUT(isDrawn() && b.now().felt.isHeld, kPatienceMs);
  }

  // What a tool takes by a click draws the tip: beside a cube its edge and its corner to measure from, above one of its
  // sides the side to select.
  void whatAToolTakesDrawsTheTip() {
    HandFixture b;
    const QString path = m_folder.filePath(QStringLiteral("cube.stl"));
    writeStl(path, cornersOf(cube(20.0)));
    QVERIFY(b.begin(path));
    // A hand that goes there through the air, and is drawn from there to a place.
    const auto isDrawn = [&](const Vec3& hand, const Vec3& place) {
      b.leadTo(hand + 20.0 * b.towardsViewer());
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
    HandFixture b;
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
    HandFixture b;
    QVERIFY(b.begin(ballIn(m_folder)));
    b.driver.find<QAction>("sculptTool")->trigger();
    QVERIFY(b.driver.settle());
    const Vec3 out = b.towardsViewer();
    QVERIFY(b.pressOnBall(out));
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
};

HANDWHEEL_WINDOW_TEST(HapticToolsTest)
#include "HapticToolsTest.moc"
