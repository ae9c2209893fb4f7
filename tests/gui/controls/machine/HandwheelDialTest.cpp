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
struct DialBench {
  DialBench() {
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
  // Clockwise from the top, in steps of 10 degrees.
  void drag(int from, int to) {
    QTest::mousePress(&dial, Qt::LeftButton, {}, at(from));
    const int step = to > from ? 10 : -10;
    for (int degrees = from; degrees != to; degrees += step) moveTo(at(degrees + step));
    QTest::mouseRelease(&dial, Qt::LeftButton, {}, at(to));
  }
  void moveTo(const QPoint& place) {
    QMouseEvent event(QEvent::MouseMove, place, dial.mapToGlobal(place), Qt::NoButton, Qt::LeftButton, {});
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

// Two turns and a quarter clockwise are 11.25 mm, whatever the way; to the precision of pixels at a radius of 60.
void HandwheelDialTest::dragCountsTurns() {
  DialBench bench;
  QSignalSpy moved(&bench.dial, &HandwheelDial::moved);
  bench.drag(0, 810);
  QVERIFY(moved.size() > 50);
  QCOMPARE(moved.last()[0].toDouble(), bench.dial.value());
  QVERIFY2(std::abs(bench.dial.value() - 11.25) < 0.1, qPrintable(QString::number(bench.dial.value())));
  bench.drag(90, -630);
  QVERIFY2(std::abs(bench.dial.value() - 1.25) < 0.1, qPrintable(QString::number(bench.dial.value())));
  const double tenths = bench.dial.value() / 0.01;
  QVERIFY2(std::abs(tenths - std::round(tenths)) < 1e-6, "a drag comes to tenths of a division");
}

void HandwheelDialTest::dragBackComesBack() {
  DialBench bench;
  QTest::mousePress(&bench.dial, Qt::LeftButton, {}, bench.at(20));
  for (int degrees = 20; degrees < 400; degrees += 7) bench.moveTo(bench.at(degrees));
  for (int degrees = 400; degrees > 20; degrees -= 11) bench.moveTo(bench.at(degrees));
  bench.moveTo(bench.at(20));
  QVERIFY2(std::abs(bench.dial.value()) < 0.02, qPrintable(QString::number(bench.dial.value())));
}

// A machine that lets the slide only up to 1 mm: turned back from there it moves at once.
void HandwheelDialTest::dragFollowsWhoAnswers() {
  DialBench bench;
  connect(&bench.dial, &HandwheelDial::moved, this, [&bench](double mm) { bench.dial.setValue(std::min(mm, 1.0)); });
  QTest::mousePress(&bench.dial, Qt::LeftButton, {}, bench.at(0));
  for (int degrees = 0; degrees <= 180; degrees += 6) bench.moveTo(bench.at(degrees));
  QCOMPARE(bench.dial.value(), 1.0);
  for (int degrees = 180; degrees >= 144; degrees -= 6) bench.moveTo(bench.at(degrees));
  QVERIFY2(std::abs(bench.dial.value() - 0.5) < 0.05, qPrintable(QString::number(bench.dial.value())));
}

void HandwheelDialTest::aClickTurnsNothing() {
  DialBench bench;
  QSignalSpy moved(&bench.dial, &HandwheelDial::moved);
  QTest::mousePress(&bench.dial, Qt::LeftButton, {}, bench.at(45));
  bench.moveTo(bench.at(45) + QPoint(1, 1));
  QTest::mouseRelease(&bench.dial, Qt::LeftButton, {}, bench.at(45));
  QTest::mousePress(&bench.dial, Qt::RightButton, {}, bench.at(45));
  bench.moveTo(bench.at(45) + QPoint(1, 1));
  QTest::mousePress(&bench.dial, Qt::LeftButton, {}, bench.dial.centre().toPoint());  // no direction there
  bench.moveTo(bench.dial.centre().toPoint() + QPoint(1, 0));
  QCOMPARE(moved.size(), 0);
}

void HandwheelDialTest::wheel() {
  DialBench bench;
  QVERIFY(bench.turnWheel(120));
  QCOMPARE(bench.dial.value(), 0.1);
  bench.turnWheel(-240);
  QCOMPARE(bench.dial.value(), -0.1);
  bench.turnWheel(120, Qt::ShiftModifier);
  QCOMPARE(bench.dial.value(), 0.9);
  bench.turnWheel(120, Qt::ControlModifier);
  QCOMPARE(bench.dial.value(), 0.91);
  for (int i = 0; i < 8; ++i) bench.turnWheel(15);  // a smooth wheel: an eighth of a notch at a time
  QVERIFY(isNear(bench.dial.value(), 1.01));
  bench.dial.clearFocus();
  QVERIFY(!bench.turnWheel(120));  // the panel around it scrolls
  QVERIFY(isNear(bench.dial.value(), 1.01));
}

void HandwheelDialTest::keys() {
  DialBench bench;
  const auto press = [&bench](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&bench.dial, key, modifiers);
    return bench.dial.value();
  };
  QShortcut ofTheWindow(Qt::Key_Up, &bench.dial, nullptr, nullptr, Qt::WindowShortcut);  // the dial comes first
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
  QCOMPARE(bench.dial.value(), 15.99);  // exactly: steps are counted, not added up
}

// As the ring of a slide: what is set to zero is the reading, the slide stays.
void HandwheelDialTest::zeroRing() {
  DialBench bench;
  QSignalSpy zeroed(&bench.dial, &HandwheelDial::zeroChanged), moved(&bench.dial, &HandwheelDial::moved);
  bench.dial.setValue(12.34);
  QTest::keyClick(&bench.dial, Qt::Key_Home);
  QCOMPARE(zeroed.size(), 1);
  QCOMPARE(zeroed[0][0].toDouble(), 12.34);
  QCOMPARE(bench.dial.value(), 12.34);
  QCOMPARE(bench.dial.numberText(), QString("0.00 mm"));
  QTest::keyClick(&bench.dial, Qt::Key_Up);
  QCOMPARE(bench.dial.value(), 12.44);
  QCOMPARE(bench.dial.numberText(), QString("0.10 mm"));
  QTest::mouseDClick(&bench.dial, Qt::LeftButton, {}, bench.at(30));
  QCOMPARE(zeroed.size(), 2);
  QCOMPARE(bench.dial.zero(), 12.44);
  QTest::mouseDClick(&bench.dial, Qt::LeftButton, {}, bench.at(30));
  QCOMPARE(zeroed.size(), 2);  // it is there
  QCOMPARE(moved.size(), 1);
}

void HandwheelDialTest::stopsAtTheEnds() {
  DialBench bench;
  bench.dial.setRange(-1.0, 1.05);
  QTest::keyClick(&bench.dial, Qt::Key_PageUp);
  QCOMPARE(bench.dial.value(), 1.05);
  QTest::keyClick(&bench.dial, Qt::Key_PageDown);
  QCOMPARE(bench.dial.value(), -1.0);
  bench.dial.setValue(3.0);  // the machine says so
  QCOMPARE(bench.dial.value(), 3.0);
  QSignalSpy moved(&bench.dial, &HandwheelDial::moved);
  QTest::keyClick(&bench.dial, Qt::Key_Up);
  QCOMPARE(moved.size(), 0);
  QTest::keyClick(&bench.dial, Qt::Key_Down);
  QCOMPARE(bench.dial.value(), 2.9);
  bench.dial.setRange(1.0, -1.0);
  QTest::keyClick(&bench.dial, Qt::Key_PageUp);
  QCOMPARE(bench.dial.value(), 7.9);
}

void HandwheelDialTest::whatIsSetIsNotSaid() {
  DialBench bench;
  QSignalSpy moved(&bench.dial, &HandwheelDial::moved), zeroed(&bench.dial, &HandwheelDial::zeroChanged);
  bench.dial.setValue(3.0);
  bench.dial.setZero(1.0);
  bench.dial.setDivisions(100, 0.02);
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
  QCOMPARE(dial.text(), QString("-0.050 mm, 1 turn below zero + 99.0 div"));
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
  DialBench bench;
  bench.dial.setValue(1.5);
  bench.dial.setValue(kNoNumber);
  bench.dial.setValue(kInf);
  bench.dial.setZero(kNoNumber);
  bench.dial.setDivisions(50, 0.0);
  bench.dial.setDivisions(50, -1.0);
  bench.dial.setDivisions(50, kNoNumber);
  QCOMPARE(bench.dial.text(), QString("1.50 mm, 15.0 div"));
  bench.dial.setDivisions(-3, 1e-9);
  bench.dial.setValue(1e300);
  QTest::keyClick(&bench.dial, Qt::Key_PageUp);
  bench.dial.grab();
  QVERIFY(std::isfinite(bench.dial.value()));
  QVERIFY(bench.dial.text().size() < 60);
  bench.dial.setDivisions(1 << 30, 1e9);
  bench.dial.setValue(-1e300);
  bench.turnWheel(std::numeric_limits<int>::max(), Qt::ShiftModifier);
  bench.dial.grab();
  bench.dial.resize(1, 1);
  bench.dial.grab();
  QVERIFY(std::isfinite(bench.dial.value()));
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

// Noise of a measured place far below a division does not make the picture tremble.
void HandwheelDialTest::anInvisibleChangeIsNotDrawn() {
  DialBench bench;
  bench.dial.setValue(2.0);
  const QImage still = bench.dial.grab().toImage();
  for (double noise : {1e-7, -1e-7, 1e-6, 1e-5}) {
    bench.dial.setValue(2.0 + noise);
    QVERIFY2(bench.dial.grab().toImage() == still, qPrintable(QString::number(noise)));
  }
  bench.dial.setValue(2.01);
  QVERIFY(bench.dial.grab().toImage() != still);
  bench.dial.setValue(2.0 + 5.0);  // a whole turn: the same picture but for the numbers
  const QRect ring(QPoint(0, 0), QSize(220, 200) * still.devicePixelRatio());
  QVERIFY(bench.dial.grab().toImage().copy(ring) == still.copy(ring));
}

void HandwheelDialTest::pictures() {
  DialBench bench;
  bench.dial.setDivisions(100, 0.05);
  bench.dial.setPrefix("⌀");
  bench.dial.setValue(12.35);
  lookAt(bench.dial, "dial");
  bench.dial.setDivisions(25, 0.02);
  bench.dial.setZero(12.0);
  bench.dial.resize(bench.dial.minimumSizeHint());
  lookAt(bench.dial, "dial-small");
}

HANDWHEEL_CONTROLS_TEST(HandwheelDialTest)
#include "HandwheelDialTest.moc"
