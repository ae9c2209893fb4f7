// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/machine/HandwheelDial.h"

#include "ControlPictures.h"
#include "ControlsTestMain.h"
#include "controls/machine/DialPainting.h"

#include <QShortcut>
#include <QSignalSpy>
#include <QWheelEvent>
#include <cmath>
#include <limits>
#include <numbers>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A dial of 50 divisions of 0.1 mm, 5 mm to a turn, that has the focus.
struct DialFixture {
  DialFixture() {
    dial.setDivisions(50, 0.1);
    dial.resize(220, 260);
    dial.show();
    dial.activateWindow();
    if (!QTest::qWaitForWindowActive(&dial)) qFatal("the dial does not appear");
    dial.setFocus();
  }
  QPoint at(double degrees, double radius = 60.0) const {
    const double angle = degrees * std::numbers::pi / 180.0;
    return (dial.centre() + QPointF(radius * std::sin(angle), -radius * std::cos(angle))).toPoint();
  }
  // Drags clockwise from the top, in steps of 10 degrees.
  void drag(int from, int to) {
    QTest::mousePress(&dial, Qt::LeftButton, {}, at(from));
    const int step = to > from ? 10 : -10;
    for (int degrees = from; degrees != to; degrees += step) moveTo(at(degrees + step));
    QTest::mouseRelease(&dial, Qt::LeftButton, {}, at(to));
  }
  void moveTo(const QPoint& point) {
    QMouseEvent event(QEvent::MouseMove, point, dial.mapToGlobal(point), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&dial, &event);
  }
  bool turnWheel(int delta, Qt::KeyboardModifiers modifiers = {}) {
    const QPointF middle = dial.centre();
    QWheelEvent event(middle, dial.mapToGlobal(middle), {}, QPoint(0, delta), Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&dial, &event);
    return event.isAccepted();
  }
  HandwheelDial dial;
};

bool isNear(double a, double b) {
  return std::abs(a - b) < 1e-9;
}

}  // namespace

class HandwheelDialTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { applyTheme(*qApp, ThemeKind::Light); }
  void dragCountsTurns();
  void dragBackComesBack();
  void dragFollowsWhoAnswers();
  void aClickTurnsNothing();
  void wheel();
  void keys();
  void zeroRing();
  void stopsAtTheEnds();
  void whatIsSetIsNotSaid();
  void texts();
  void extremes();
  void marksDoNotTouch();
  void anInvisibleChangeIsNotDrawn();
  void pictures();
};

// Two turns and a quarter clockwise are 11.25 mm, on any path; to the precision of pixels at a radius of 60.
void HandwheelDialTest::dragCountsTurns() {
  DialFixture fixture;
  QSignalSpy moved(&fixture.dial, &HandwheelDial::moved);
  fixture.drag(0, 810);
  QVERIFY(moved.size() > 50);
  QCOMPARE(moved.last()[0].toDouble(), fixture.dial.value());
  QVERIFY2(std::abs(fixture.dial.value() - 11.25) < 0.1, qPrintable(QString::number(fixture.dial.value())));
  fixture.drag(90, -630);
  QVERIFY2(std::abs(fixture.dial.value() - 1.25) < 0.1, qPrintable(QString::number(fixture.dial.value())));
  const double tenths = fixture.dial.value() / 0.01;
  QVERIFY2(std::abs(tenths - std::round(tenths)) < 1e-6, "a drag comes to tenths of a division");
}

void HandwheelDialTest::dragBackComesBack() {
  DialFixture fixture;
  QTest::mousePress(&fixture.dial, Qt::LeftButton, {}, fixture.at(20));
  for (int degrees = 20; degrees < 400; degrees += 7) fixture.moveTo(fixture.at(degrees));
  for (int degrees = 400; degrees > 20; degrees -= 11) fixture.moveTo(fixture.at(degrees));
  fixture.moveTo(fixture.at(20));
  QVERIFY2(std::abs(fixture.dial.value()) < 0.02, qPrintable(QString::number(fixture.dial.value())));
}

// A machine that lets the slide only up to 1 mm: turned back from there it moves at once.
void HandwheelDialTest::dragFollowsWhoAnswers() {
  DialFixture fixture;
  connect(&fixture.dial, &HandwheelDial::moved, this,
          [&fixture](double mm) { fixture.dial.setValue(std::min(mm, 1.0)); });
  QTest::mousePress(&fixture.dial, Qt::LeftButton, {}, fixture.at(0));
  for (int degrees = 0; degrees <= 180; degrees += 6) fixture.moveTo(fixture.at(degrees));
  QCOMPARE(fixture.dial.value(), 1.0);
  for (int degrees = 180; degrees >= 144; degrees -= 6) fixture.moveTo(fixture.at(degrees));
  QVERIFY2(std::abs(fixture.dial.value() - 0.5) < 0.05, qPrintable(QString::number(fixture.dial.value())));
}

void HandwheelDialTest::aClickTurnsNothing() {
  DialFixture fixture;
  QSignalSpy moved(&fixture.dial, &HandwheelDial::moved);
  QTest::mousePress(&fixture.dial, Qt::LeftButton, {}, fixture.at(45));
  fixture.moveTo(fixture.at(45) + QPoint(1, 1));
  QTest::mouseRelease(&fixture.dial, Qt::LeftButton, {}, fixture.at(45));
  QTest::mousePress(&fixture.dial, Qt::RightButton, {}, fixture.at(45));
  fixture.moveTo(fixture.at(45) + QPoint(1, 1));
  QTest::mousePress(&fixture.dial, Qt::LeftButton, {}, fixture.dial.centre().toPoint());  // no direction there
  fixture.moveTo(fixture.dial.centre().toPoint() + QPoint(1, 0));
  QCOMPARE(moved.size(), 0);
}

void HandwheelDialTest::wheel() {
  DialFixture fixture;
  QVERIFY(fixture.turnWheel(120));
  QCOMPARE(fixture.dial.value(), 0.1);
  fixture.turnWheel(-240);
  QCOMPARE(fixture.dial.value(), -0.1);
  fixture.turnWheel(120, Qt::ShiftModifier);
  QCOMPARE(fixture.dial.value(), 0.9);
  fixture.turnWheel(120, Qt::ControlModifier);
  QCOMPARE(fixture.dial.value(), 0.91);
  for (int i = 0; i < 8; ++i) fixture.turnWheel(15);  // a smooth wheel: an eighth of a notch at a time
  QVERIFY(isNear(fixture.dial.value(), 1.01));
  fixture.dial.clearFocus();
  QVERIFY(!fixture.turnWheel(120));  // the panel around it scrolls
  QVERIFY(isNear(fixture.dial.value(), 1.01));
}

void HandwheelDialTest::keys() {
  DialFixture fixture;
  const auto press = [&fixture](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&fixture.dial, key, modifiers);
    return fixture.dial.value();
  };
  QShortcut ofTheWindow(Qt::Key_Up, &fixture.dial, nullptr, nullptr, Qt::WindowShortcut);  // the dial comes first
  QCOMPARE(press(Qt::Key_Up), 0.1);
  QCOMPARE(press(Qt::Key_Right), 0.2);
  QCOMPARE(press(Qt::Key_Down), 0.1);
  QCOMPARE(press(Qt::Key_Left), 0.0);
  QCOMPARE(press(Qt::Key_PageUp), 5.0);
  QCOMPARE(press(Qt::Key_PageUp), 10.0);
  QCOMPARE(press(Qt::Key_PageDown), 5.0);
  QCOMPARE(press(Qt::Key_Up, Qt::ShiftModifier), 6.0);
  QCOMPARE(press(Qt::Key_Down, Qt::ControlModifier), 5.99);
  for (int i = 0; i < 1000; ++i) press(Qt::Key_Up, Qt::ControlModifier);
  QCOMPARE(fixture.dial.value(), 15.99);  // exactly: steps are counted, not added up
}

// Like the ring of a slide: setting to zero changes the reading, the slide stays.
void HandwheelDialTest::zeroRing() {
  DialFixture fixture;
  QSignalSpy zeroed(&fixture.dial, &HandwheelDial::zeroChanged), moved(&fixture.dial, &HandwheelDial::moved);
  fixture.dial.setValue(12.34);
  QTest::keyClick(&fixture.dial, Qt::Key_Home);
  QCOMPARE(zeroed.size(), 1);
  QCOMPARE(zeroed[0][0].toDouble(), 12.34);
  QCOMPARE(fixture.dial.value(), 12.34);
  QCOMPARE(fixture.dial.numberText(), QString("0.00 mm"));
  QTest::keyClick(&fixture.dial, Qt::Key_Up);
  QCOMPARE(fixture.dial.value(), 12.44);
  QCOMPARE(fixture.dial.numberText(), QString("0.10 mm"));
  QTest::mouseDClick(&fixture.dial, Qt::LeftButton, {}, fixture.at(30));
  QCOMPARE(zeroed.size(), 2);
  QCOMPARE(fixture.dial.zero(), 12.44);
  QTest::mouseDClick(&fixture.dial, Qt::LeftButton, {}, fixture.at(30));
  QCOMPARE(zeroed.size(), 2);  // it is there
  QCOMPARE(moved.size(), 1);
}

void HandwheelDialTest::stopsAtTheEnds() {
  DialFixture fixture;
  fixture.dial.setRange(-1.0, 1.05);
  QTest::keyClick(&fixture.dial, Qt::Key_PageUp);
  QCOMPARE(fixture.dial.value(), 1.05);
  QTest::keyClick(&fixture.dial, Qt::Key_PageDown);
  QCOMPARE(fixture.dial.value(), -1.0);
  fixture.dial.setValue(3.0);  // the machine says so
  QCOMPARE(fixture.dial.value(), 3.0);
  QSignalSpy moved(&fixture.dial, &HandwheelDial::moved);
  QTest::keyClick(&fixture.dial, Qt::Key_Up);
  QCOMPARE(moved.size(), 0);
  QTest::keyClick(&fixture.dial, Qt::Key_Down);
  QCOMPARE(fixture.dial.value(), 2.9);
  fixture.dial.setRange(1.0, -1.0);
  QTest::keyClick(&fixture.dial, Qt::Key_PageUp);
  QCOMPARE(fixture.dial.value(), 7.9);
}

void HandwheelDialTest::whatIsSetIsNotSaid() {
  DialFixture fixture;
  QSignalSpy moved(&fixture.dial, &HandwheelDial::moved), zeroed(&fixture.dial, &HandwheelDial::zeroChanged);
  fixture.dial.setValue(3.0);
  fixture.dial.setZero(1.0);
  fixture.dial.setDivisions(100, 0.02);
  QCOMPARE(moved.size() + zeroed.size(), 0);
}

void HandwheelDialTest::texts() {
  HandwheelDial dial;
  dial.setDivisions(100, 0.05);
  dial.setValue(12.35);  // 247 divisions
  QCOMPARE(dial.text(), QString("12.350 mm, 2 turns + 47.0 div"));
  QCOMPARE(dial.accessibleDescription(), dial.text());
  dial.setValue(5.0 - 1e-9);
  QCOMPARE(dial.readingText(), QString("1 turn + 0.0 div"));
  dial.setValue(-0.05);
  QCOMPARE(dial.text(), QString("-0.050 mm, -1 turn + 99.0 div"));
  dial.setValue(4.999);
  QCOMPARE(dial.readingText(), QString("99.9 div"));
  dial.setPrefix("⌀");
  QCOMPARE(dial.numberText(), QString("⌀ 4.999 mm"));
  dial.setLabel("Cross slide");
  QCOMPARE(dial.accessibleName(), QString("Cross slide"));
  dial.setLocale(QLocale(QLocale::German));
  QCOMPARE(dial.numberText(), QString("⌀ 4,999 mm"));
}

void HandwheelDialTest::extremes() {
  constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
  DialFixture fixture;
  fixture.dial.setValue(1.5);
  fixture.dial.setValue(kNoNumber);
  fixture.dial.setValue(kInf);
  fixture.dial.setZero(kNoNumber);
  fixture.dial.setDivisions(50, 0.0);
  fixture.dial.setDivisions(50, -1.0);
  fixture.dial.setDivisions(50, kNoNumber);
  QCOMPARE(fixture.dial.text(), QString("1.50 mm, 15.0 div"));
  fixture.dial.setDivisions(-3, 1e-9);
  fixture.dial.setValue(1e300);
  QTest::keyClick(&fixture.dial, Qt::Key_PageUp);
  fixture.dial.grab();
  QVERIFY(std::isfinite(fixture.dial.value()));
  QVERIFY(fixture.dial.text().size() < 60);
  fixture.dial.setDivisions(1 << 30, 1e9);
  fixture.dial.setValue(-1e300);
  fixture.turnWheel(std::numeric_limits<int>::max(), Qt::ShiftModifier);
  fixture.dial.grab();
  fixture.dial.resize(1, 1);
  fixture.dial.grab();
  QVERIFY(std::isfinite(fixture.dial.value()));
}

void HandwheelDialTest::marksDoNotTouch() {
  for (int perTurn : {1, 7, 25, 40, 50, 60, 80, 100, 125, 200, 250, 400, 1000}) {
    for (double radius : {20.0, 40.0, 60.0, 150.0}) {
      const DialMarks marks = dialMarks(perTurn, radius, 18.0);
      const double arc = 2.0 * std::numbers::pi * radius / perTurn;
      QVERIFY(marks.eachMark >= 1 && perTurn % marks.eachMark == 0);
      QVERIFY(perTurn % marks.eachFigure == 0 && marks.eachFigure % marks.eachMark == 0);
      QVERIFY(marks.eachMark == perTurn || marks.eachMark * arc >= 3.0);
      QVERIFY(marks.eachFigure == perTurn || marks.eachFigure * arc >= 18.0);
    }
  }
}

// Noise of a measured position far below a division does not make the picture tremble.
void HandwheelDialTest::anInvisibleChangeIsNotDrawn() {
  DialFixture fixture;
  fixture.dial.setValue(2.0);
  const QImage still = fixture.dial.grab().toImage();
  for (double noise : {1e-7, -1e-7, 1e-6, 1e-5}) {
    fixture.dial.setValue(2.0 + noise);
    QVERIFY2(fixture.dial.grab().toImage() == still, qPrintable(QString::number(noise)));
  }
  fixture.dial.setValue(2.01);
  QVERIFY(fixture.dial.grab().toImage() != still);
  fixture.dial.setValue(2.0 + 5.0);  // a whole turn: the same picture but for the numbers
  const QRect ring(QPoint(0, 0), QSize(220, 200) * still.devicePixelRatio());
  QVERIFY(fixture.dial.grab().toImage().copy(ring) == still.copy(ring));
}

void HandwheelDialTest::pictures() {
  DialFixture fixture;
  fixture.dial.setDivisions(100, 0.05);
  fixture.dial.setPrefix("⌀");
  fixture.dial.setValue(12.35);
  lookAt(fixture.dial, "dial");
  fixture.dial.setDivisions(25, 0.02);
  fixture.dial.setZero(12.0);
  fixture.dial.resize(fixture.dial.minimumSizeHint());
  lookAt(fixture.dial, "dial-small");
}

HANDWHEEL_CONTROLS_TEST(HandwheelDialTest)
#include "HandwheelDialTest.moc"
