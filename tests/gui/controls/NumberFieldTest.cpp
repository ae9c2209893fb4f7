// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ControlsTestMain.h"
#include "NumberFieldFixture.h"
#include "controls/ExpressionText.h"

#include <numbers>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const QLocale kGerman(QLocale::German, QLocale::Germany);

}  // namespace

class NumberFieldTest : public QObject {
  Q_OBJECT

 private slots:
  void takesExpressions();
  void takesOtherUnits();
  void speaksGerman();
  void anglesAreDegrees();
  void refusesAndSaysWhy();
  void takesLimitsAsTheyAreShown();
  void escBringsTheValueBack();
  void outOfRangeIsSaidAtOnce();
  void whatIsTypedStays();
  void untouchedValuesStayExact();
  void keysOfTheWindow();
  void screenReaders();
  void everyErrorHasASentence();
};

void NumberFieldTest::takesExpressions() {
  Bench bench;
  bench.enter("25.4/2");
  QCOMPARE(bench.said(), Said({{12.7, false}}));
  QCOMPARE(bench.line->text(), QString("12.7"));
  QCOMPARE(bench.field->value(), 12.7);
  bench.type("2*(3+4)");
  bench.other->setFocus();  // leaving takes it as well
  QCOMPARE(bench.said(), Said({{14.0, false}}));
}

void NumberFieldTest::takesOtherUnits() {
  Bench bench(Quantity::Length, LengthUnit::Inch);
  bench.enter("1 in + 2mm");
  QCOMPARE(bench.field->value(), 27.4);
  QCOMPARE(bench.line->text(), QString("1.07874"));  // 27.4 / 25.4 = 1.0787401…
  bench.enter("2");
  QCOMPARE(bench.field->value(), 50.8);
  bench.field->setQuantity(Quantity::Length, LengthUnit::Centimetre);
  QCOMPARE(bench.line->text(), QString("5.08"));
  QCOMPARE(bench.field->value(), 50.8);
}

void NumberFieldTest::speaksGerman() {
  Bench bench(Quantity::Length, LengthUnit::Millimetre, kGerman);
  bench.field->setValue(12.345);
  QCOMPARE(bench.line->text(), QString("12,345"));
  bench.enter("1,234");  // a thousandth of what an English reader might think
  QCOMPARE(bench.field->value(), 1.234);
  bench.enter("2.5");
  QCOMPARE(bench.field->value(), 2.5);
  QCOMPARE(bench.line->text(), QString("2,5"));
  Bench english;
  english.enter("1,234");
  QCOMPARE(english.said(), Said());
  QVERIFY(english.field->problem().contains("1,234"));
  english.enter("1,5");
  QCOMPARE(english.field->value(), 1.5);
  QCOMPARE(english.line->text(), QString("1.5"));
}

void NumberFieldTest::anglesAreDegrees() {
  Bench bench(Quantity::Angle);
  bench.field->setRange(-std::numbers::pi, std::numbers::pi);
  bench.enter("90");
  QCOMPARE(bench.field->value(), std::numbers::pi / 2);
  bench.enter("pi/4 rad");
  QCOMPARE(bench.line->text(), QString("45"));
  bench.enter("180");
  QCOMPARE(bench.field->problem(), QString());
  QVERIFY(bench.field->value() <= std::numbers::pi);
  QTest::keyClick(bench.line, Qt::Key_Down);
  QCOMPARE(bench.line->text(), QString("179"));
}

void NumberFieldTest::refusesAndSaysWhy() {
  Bench bench;
  bench.field->setRange(1.0, 10.0);
  bench.field->setValue(5.0);
  bench.enter("25.4");
  QCOMPARE(bench.field->problem(), QString("Must be at most 10\u00a0mm."));
  QVERIFY(bench.field->findChild<QWidget*>("numberProblem")->isVisible());
  QCOMPARE(bench.line->text(), QString("25.4"));
  QCOMPARE(bench.field->value(), 5.0);
  bench.type("9");  // no word while it is being mended
  QCOMPARE(bench.field->problem(), QString());
  bench.enter("0");
  QCOMPARE(bench.field->problem(), QString("Must be at least 1\u00a0mm."));
  bench.enter("2 mm + 3 deg");
  QVERIFY(bench.field->problem().contains("6"));  // the place of the plus
  QTest::keyClick(bench.line, Qt::Key_Up);        // nothing to step from
  QCOMPARE(bench.said(), Said());
  bench.other->setFocus();  // it stays, with the reason
  QCOMPARE(bench.line->text(), QString("2 mm + 3 deg"));
  QVERIFY(!bench.field->problem().isEmpty());
  bench.field->setValue(6.0);  // until the value changes
  QCOMPARE(bench.line->text(), QString("6"));
  QCOMPARE(bench.field->problem(), QString());
}

// The limit of a robot's joint, 1.9199 rad, is 110.00217…°.
void NumberFieldTest::takesLimitsAsTheyAreShown() {
  Bench bench;
  bench.field->setQuantity(Quantity::Angle, LengthUnit::Millimetre);
  bench.field->setRange(-1.9199, 1.9199);
  bench.enter("110.01");
  QCOMPARE(bench.field->problem(), QString("Must be at most 110.0022°."));
  bench.enter("110.0022");
  QCOMPARE(bench.field->problem(), QString());
  QCOMPARE(bench.field->value(), 1.9199);
  bench.enter("-110.0022");
  QCOMPARE(bench.field->value(), -1.9199);
}

void NumberFieldTest::escBringsTheValueBack() {
  Bench bench;
  bench.field->setValue(5.0);
  bench.enter("1/0");
  QVERIFY(!bench.field->problem().isEmpty());
  QTest::keyClick(bench.line, Qt::Key_Escape);
  QCOMPARE(bench.line->text(), QString("5"));
  QCOMPARE(bench.field->problem(), QString());
  QCOMPARE(bench.said(), Said());
}

void NumberFieldTest::outOfRangeIsSaidAtOnce() {
  Bench bench;
  bench.field->setRange(0.0, 10.0);
  bench.field->setValue(25.0);
  QVERIFY(!bench.field->problem().isEmpty());
  bench.field->setRange(0.0, 30.0);
  QCOMPARE(bench.field->problem(), QString());
}

void NumberFieldTest::whatIsTypedStays() {
  Bench bench;
  bench.field->setValue(5.0);
  bench.type("12");
  bench.field->setValue(6.0);  // a tool or a job says so meanwhile
  QCOMPARE(bench.line->text(), QString("12"));
  QTest::keyClick(bench.line, Qt::Key_Return);
  QCOMPARE(bench.said(), Said({{12.0, false}}));
}

void NumberFieldTest::untouchedValuesStayExact() {
  Bench bench;
  bench.field->setValue(1.0 / 3.0);
  bench.enter("0.333333");
  bench.other->setFocus();
  QCOMPARE(bench.said(), Said());
  QCOMPARE(bench.field->value(), 1.0 / 3.0);
}

// Enter and Esc are the field's only while there is something to take or to take back.
void NumberFieldTest::keysOfTheWindow() {
  Bench bench;
  int commits = 0;
  int reverts = 0;
  QAction commit("commit"), revert("revert");
  commit.setShortcut(Qt::Key_Return);
  revert.setShortcut(Qt::Key_Escape);
  bench.window.addActions({&commit, &revert});
  connect(&commit, &QAction::triggered, this, [&] { ++commits; });
  connect(&revert, &QAction::triggered, this, [&] { ++reverts; });
  bench.enter("4");
  QCOMPARE(commits, 0);
  QTest::keyClick(bench.line, Qt::Key_Return);
  QCOMPARE(commits, 1);
  bench.type("5");
  QTest::keyClick(bench.line, Qt::Key_Escape);
  QCOMPARE(reverts, 0);
  QTest::keyClick(bench.line, Qt::Key_Escape);
  QCOMPARE(reverts, 1);
}

void NumberFieldTest::screenReaders() {
  Bench bench;
  bench.field->setRange(0.0, 10.0);
  QCOMPARE(bench.line->accessibleName(), QString("Diameter"));
  QCOMPARE(bench.line->accessibleDescription(), QString("in mm, at least 0\u00a0mm, at most 10\u00a0mm"));
}

void NumberFieldTest::everyErrorHasASentence() {
  for (int kind = 0; kind <= int(ExpressionError::Kind::TooLarge); ++kind) {
    const QString text = expressionProblem({ExpressionError::Kind(kind), 42, "found%2"});
    QVERIFY2(text.endsWith("(character 42).") && text.size() > 20, qPrintable(text));
  }
}

HANDWHEEL_CONTROLS_TEST(NumberFieldTest)
#include "NumberFieldTest.moc"
