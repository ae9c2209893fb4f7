// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ControlsTestMain.h"
#include "NumberFieldFixture.h"

using namespace handwheel;
using namespace handwheel::test;

// Keys and wheel change the number step by step.
class NumberFieldIncrementsTest : public QObject {
  Q_OBJECT

 private slots:
  void steps();
  void stepsOfSmallValues();
  void stepsStayInRange();
  void wheelNeedsTheFocus();
};

void NumberFieldIncrementsTest::steps() {
  Bench bench;
  bench.field->setValue(20.0);
  QTest::keyPress(bench.line, Qt::Key_Up);
  QTest::keyPress(bench.line, Qt::Key_Up);
  QCOMPARE(bench.said(), Said({{21.0, true}, {22.0, true}}));
  QTest::keyRelease(bench.line, Qt::Key_Up);
  QCOMPARE(bench.said(), Said({{22.0, false}}));
  QTest::keyClick(bench.line, Qt::Key_Down, Qt::ShiftModifier);
  QTest::keyClick(bench.line, Qt::Key_Down, Qt::ControlModifier);
  QCOMPARE(bench.said(), Said({{12.0, true}, {12.0, false}, {11.9, true}, {11.9, false}}));
  QVERIFY(bench.turnWheel(2));
  QVERIFY(bench.turnWheel(-1, Qt::ShiftModifier));
  QCOMPARE(bench.said(), Said({{13.9, true}, {3.9, true}}));
  QVERIFY(bench.spy->wait());  // a pause ends the run
  QCOMPARE(bench.said(), Said({{3.9, false}}));
  bench.turnWheel(1);
  bench.other->setFocus();
  QCOMPARE(bench.said(), Said({{4.9, true}, {4.9, false}}));
  bench.type("7");
  QTest::keyClick(bench.line, Qt::Key_Up);  // from what stands there
  QCOMPARE(bench.said(), Said({{7.0, false}, {8.0, true}, {8.0, false}}));
}

void NumberFieldIncrementsTest::stepsOfSmallValues() {
  Bench bench;
  bench.field->setValue(0.003);
  QTest::keyClick(bench.line, Qt::Key_Up);
  QCOMPARE(bench.line->text(), QString("0.004"));
  QTest::keyClick(bench.line, Qt::Key_Up, Qt::ControlModifier);
  QCOMPARE(bench.line->text(), QString("0.0041"));
  bench.field->setValue(0.0);
  QTest::keyClick(bench.line, Qt::Key_Up);
  QCOMPARE(bench.field->value(), 1.0);
  bench.field->setStep(0.25);
  QTest::keyClick(bench.line, Qt::Key_Up);
  QCOMPARE(bench.field->value(), 1.25);
}

void NumberFieldIncrementsTest::stepsStayInRange() {
  Bench bench;
  bench.field->setRange(0.0, 10.0);
  bench.field->setValue(9.5);
  QTest::keyClick(bench.line, Qt::Key_Up);
  QTest::keyClick(bench.line, Qt::Key_Up);
  QCOMPARE(bench.said(), Said({{10.0, true}, {10.0, false}}));
  bench.field->setRange(5.0, -5.0);  // makes no sense, so there is none
  QTest::keyClick(bench.line, Qt::Key_Up);
  QCOMPARE(bench.field->value(), 11.0);
  bench.field->setValue(std::nan(""));
  QTest::keyClick(bench.line, Qt::Key_Up);
  QVERIFY(std::isnan(bench.field->value()));
  bench.enter("3");
  QCOMPARE(bench.field->value(), 3.0);
}

void NumberFieldIncrementsTest::wheelNeedsTheFocus() {
  Bench bench;
  bench.other->setFocus();
  QVERIFY(!bench.turnWheel(1));
  QCOMPARE(bench.said(), Said());
}

HANDWHEEL_CONTROLS_TEST(NumberFieldIncrementsTest)
#include "NumberFieldIncrementsTest.moc"
