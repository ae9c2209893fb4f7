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
  Fixture fixture;
  fixture.field->setValue(20.0);
  QTest::keyPress(fixture.line, Qt::Key_Up);
  QTest::keyPress(fixture.line, Qt::Key_Up);
  QCOMPARE(fixture.said(), Said({{21.0, true}, {22.0, true}}));
  QTest::keyRelease(fixture.line, Qt::Key_Up);
  QCOMPARE(fixture.said(), Said({{22.0, false}}));
  QTest::keyClick(fixture.line, Qt::Key_Down, Qt::ShiftModifier);
  QTest::keyClick(fixture.line, Qt::Key_Down, Qt::ControlModifier);
  QCOMPARE(fixture.said(), Said({{12.0, true}, {12.0, false}, {11.9, true}, {11.9, false}}));
  QVERIFY(fixture.turnWheel(2));
  QVERIFY(fixture.turnWheel(-1, Qt::ShiftModifier));
  QCOMPARE(fixture.said(), Said({{13.9, true}, {3.9, true}}));
  QVERIFY(fixture.spy->wait());  // a pause ends the run
  QCOMPARE(fixture.said(), Said({{3.9, false}}));
  fixture.turnWheel(1);
  fixture.other->setFocus();
  QCOMPARE(fixture.said(), Said({{4.9, true}, {4.9, false}}));
  fixture.type("7");
  QTest::keyClick(fixture.line, Qt::Key_Up);  // from the text in the line
  QCOMPARE(fixture.said(), Said({{7.0, false}, {8.0, true}, {8.0, false}}));
}

void NumberFieldIncrementsTest::stepsOfSmallValues() {
  Fixture fixture;
  fixture.field->setValue(0.003);
  QTest::keyClick(fixture.line, Qt::Key_Up);
  QCOMPARE(fixture.line->text(), QString("0.004"));
  QTest::keyClick(fixture.line, Qt::Key_Up, Qt::ControlModifier);
  QCOMPARE(fixture.line->text(), QString("0.0041"));
  fixture.field->setValue(0.0);
  QTest::keyClick(fixture.line, Qt::Key_Up);
  QCOMPARE(fixture.field->value(), 1.0);
  fixture.field->setStep(0.25);
  QTest::keyClick(fixture.line, Qt::Key_Up);
  QCOMPARE(fixture.field->value(), 1.25);
}

void NumberFieldIncrementsTest::stepsStayInRange() {
  Fixture fixture;
  fixture.field->setRange(0.0, 10.0);
  fixture.field->setValue(9.5);
  QTest::keyClick(fixture.line, Qt::Key_Up);
  QTest::keyClick(fixture.line, Qt::Key_Up);
  QCOMPARE(fixture.said(), Said({{10.0, true}, {10.0, false}}));
  fixture.field->setRange(5.0, -5.0);  // makes no sense, so there is none
  QTest::keyClick(fixture.line, Qt::Key_Up);
  QCOMPARE(fixture.field->value(), 11.0);
  fixture.field->setValue(std::nan(""));
  QTest::keyClick(fixture.line, Qt::Key_Up);
  QVERIFY(std::isnan(fixture.field->value()));
  fixture.enter("3");
  QCOMPARE(fixture.field->value(), 3.0);
}

void NumberFieldIncrementsTest::wheelNeedsTheFocus() {
  Fixture fixture;
  fixture.other->setFocus();
  QVERIFY(!fixture.turnWheel(1));
  QCOMPARE(fixture.said(), Said());
}

HANDWHEEL_CONTROLS_TEST(NumberFieldIncrementsTest)
#include "NumberFieldIncrementsTest.moc"
