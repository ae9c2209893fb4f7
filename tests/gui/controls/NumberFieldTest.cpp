// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ControlsTestMain.h"
#include "NumberFieldFixture.h"
#include "controls/ExpressionText.h"

#include <QLabel>
#include <QPointer>
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
  void theReasonMovesNothing();
  void escBringsTheValueBack();
  void outOfRangeIsSaidAtOnce();
  void whatIsTypedStays();
  void untouchedValuesStayExact();
  void keysOfTheWindow();
  void screenReaders();
  void everyErrorHasASentence();
};

void NumberFieldTest::takesExpressions() {
  Fixture fixture;
  fixture.enter("25.4/2");
  QCOMPARE(fixture.said(), Said({{12.7, false}}));
  QCOMPARE(fixture.line->text(), QString("12.7"));
  QCOMPARE(fixture.field->value(), 12.7);
  fixture.type("2*(3+4)");
  fixture.other->setFocus();  // leaving commits, too
  QCOMPARE(fixture.said(), Said({{14.0, false}}));
}

void NumberFieldTest::takesOtherUnits() {
  Fixture fixture(Quantity::Length, LengthUnit::Inch);
  fixture.enter("1 in + 2mm");
  QCOMPARE(fixture.field->value(), 27.4);
  QCOMPARE(fixture.line->text(), QString("1.07874"));  // 27.4 / 25.4 = 1.0787401…
  fixture.enter("2");
  QCOMPARE(fixture.field->value(), 50.8);
  fixture.field->setQuantity(Quantity::Length, LengthUnit::Centimetre);
  QCOMPARE(fixture.line->text(), QString("5.08"));
  QCOMPARE(fixture.field->value(), 50.8);
}

void NumberFieldTest::speaksGerman() {
  Fixture fixture(Quantity::Length, LengthUnit::Millimetre, kGerman);
  fixture.field->setValue(12.345);
  QCOMPARE(fixture.line->text(), QString("12,345"));
  fixture.enter("1,234");  // a thousandth of what an English reader might think
  QCOMPARE(fixture.field->value(), 1.234);
  fixture.enter("2.5");
  QCOMPARE(fixture.field->value(), 2.5);
  QCOMPARE(fixture.line->text(), QString("2,5"));
  Fixture english;
  english.enter("1,234");
  QCOMPARE(english.said(), Said());
  QVERIFY(english.field->problem().contains("1,234"));
  english.enter("1,5");
  QCOMPARE(english.field->value(), 1.5);
  QCOMPARE(english.line->text(), QString("1.5"));
}

void NumberFieldTest::anglesAreDegrees() {
  Fixture fixture(Quantity::Angle);
  fixture.field->setRange(-std::numbers::pi, std::numbers::pi);
  fixture.enter("90");
  QCOMPARE(fixture.field->value(), std::numbers::pi / 2);
  fixture.enter("pi/4 rad");
  QCOMPARE(fixture.line->text(), QString("45"));
  fixture.enter("180");
  QCOMPARE(fixture.field->problem(), QString());
  QVERIFY(fixture.field->value() <= std::numbers::pi);
  QTest::keyClick(fixture.line, Qt::Key_Down);
  QCOMPARE(fixture.line->text(), QString("179"));
}

void NumberFieldTest::refusesAndSaysWhy() {
  Fixture fixture;
  fixture.field->setRange(1.0, 10.0);
  fixture.field->setValue(5.0);
  fixture.enter("25.4");
  QCOMPARE(fixture.field->problem(), QString("Must be at most 10\u00a0mm."));
  QVERIFY(fixture.field->findChild<QWidget*>("numberProblem")->isVisible());
  QCOMPARE(fixture.line->text(), QString("25.4"));
  QCOMPARE(fixture.field->value(), 5.0);
  fixture.type("9");  // no message while it is being corrected
  QCOMPARE(fixture.field->problem(), QString());
  fixture.enter("0");
  QCOMPARE(fixture.field->problem(), QString("Must be at least 1\u00a0mm."));
  fixture.enter("2 mm + 3 deg");
  QVERIFY(fixture.field->problem().contains("6"));  // the position of the plus
  QTest::keyClick(fixture.line, Qt::Key_Up);        // nothing to step from
  QCOMPARE(fixture.said(), Said());
  fixture.other->setFocus();  // it stays, with the reason
  QCOMPARE(fixture.line->text(), QString("2 mm + 3 deg"));
  QVERIFY(!fixture.field->problem().isEmpty());
  fixture.field->setValue(6.0);  // until the value changes
  QCOMPARE(fixture.line->text(), QString("6"));
  QCOMPARE(fixture.field->problem(), QString());
}

// The limit of a robot's joint, 1.9199 rad, is 110.00217…°.
void NumberFieldTest::takesLimitsAsTheyAreShown() {
  Fixture fixture;
  fixture.field->setQuantity(Quantity::Angle, LengthUnit::Millimetre);
  fixture.field->setRange(-1.9199, 1.9199);
  fixture.enter("110.01");
  QCOMPARE(fixture.field->problem(), QString("Must be at most 110.0022°."));
  fixture.enter("110.0022");
  QCOMPARE(fixture.field->problem(), QString());
  QCOMPARE(fixture.field->value(), 1.9199);
  fixture.enter("-110.0022");
  QCOMPARE(fixture.field->value(), -1.9199);
}

// Over the widgets below the field; it goes when the field is hidden, and comes back with it.
void NumberFieldTest::theReasonMovesNothing() {
  Fixture f;
  f.field->setProblemOver();
  const QPoint below = f.other->pos();
  f.enter("abc");
  QVERIFY(!f.field->problem().isEmpty());
  auto* const reason = f.window.findChild<QLabel*>("numberProblem");
  QVERIFY(reason && reason->isVisible());
  QCoreApplication::processEvents();
  QCOMPARE(f.other->pos(), below);
  f.field->hide();
  QVERIFY(!reason->isVisible());
  f.field->show();
  QVERIFY(reason->isVisible());
  f.enter("12");
  QVERIFY(!reason->isVisible() && f.field->problem().isEmpty());
  const QPointer<QLabel> watched = reason;
  delete f.field;
  QVERIFY(!watched);
}

void NumberFieldTest::escBringsTheValueBack() {
  Fixture fixture;
  fixture.field->setValue(5.0);
  fixture.enter("1/0");
  QVERIFY(!fixture.field->problem().isEmpty());
  QTest::keyClick(fixture.line, Qt::Key_Escape);
  QCOMPARE(fixture.line->text(), QString("5"));
  QCOMPARE(fixture.field->problem(), QString());
  QCOMPARE(fixture.said(), Said());
}

void NumberFieldTest::outOfRangeIsSaidAtOnce() {
  Fixture fixture;
  fixture.field->setRange(0.0, 10.0);
  fixture.field->setValue(25.0);
  QVERIFY(!fixture.field->problem().isEmpty());
  fixture.field->setRange(0.0, 30.0);
  QCOMPARE(fixture.field->problem(), QString());
}

void NumberFieldTest::whatIsTypedStays() {
  Fixture fixture;
  fixture.field->setValue(5.0);
  fixture.type("12");
  fixture.field->setValue(6.0);  // a tool or a job sets it meanwhile
  QCOMPARE(fixture.line->text(), QString("12"));
  QTest::keyClick(fixture.line, Qt::Key_Return);
  QCOMPARE(fixture.said(), Said({{12.0, false}}));
}

void NumberFieldTest::untouchedValuesStayExact() {
  Fixture fixture;
  fixture.field->setValue(1.0 / 3.0);
  fixture.enter("0.333333");
  fixture.other->setFocus();
  QCOMPARE(fixture.said(), Said());
  QCOMPARE(fixture.field->value(), 1.0 / 3.0);
}

// Enter and Esc belong to the field only while there is something to commit or to revert.
void NumberFieldTest::keysOfTheWindow() {
  Fixture fixture;
  int commits = 0;
  int reverts = 0;
  QAction commit("commit"), revert("revert");
  commit.setShortcut(Qt::Key_Return);
  revert.setShortcut(Qt::Key_Escape);
  fixture.window.addActions({&commit, &revert});
  connect(&commit, &QAction::triggered, this, [&] { ++commits; });
  connect(&revert, &QAction::triggered, this, [&] { ++reverts; });
  fixture.enter("4");
  QCOMPARE(commits, 0);
  QTest::keyClick(fixture.line, Qt::Key_Return);
  QCOMPARE(commits, 1);
  fixture.type("5");
  QTest::keyClick(fixture.line, Qt::Key_Escape);
  QCOMPARE(reverts, 0);
  QTest::keyClick(fixture.line, Qt::Key_Escape);
  QCOMPARE(reverts, 1);
}

void NumberFieldTest::screenReaders() {
  Fixture fixture;
  fixture.field->setRange(0.0, 10.0);
  QCOMPARE(fixture.line->accessibleName(), QString("Diameter"));
  QCOMPARE(fixture.line->accessibleDescription(), QString("in mm, at least 0\u00a0mm, at most 10\u00a0mm"));
}

void NumberFieldTest::everyErrorHasASentence() {
  for (int kind = 0; kind <= int(ExpressionError::Kind::TooLarge); ++kind) {
    const QString text = expressionProblem({ExpressionError::Kind(kind), 42, "found%2"});
    QVERIFY2(text.endsWith("(character 42).") && text.size() > 20, qPrintable(text));
  }
}

HANDWHEEL_CONTROLS_TEST(NumberFieldTest)
#include "NumberFieldTest.moc"
