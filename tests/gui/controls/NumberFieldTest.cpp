// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/NumberField.h"

#include "ControlsTestMain.h"
#include "controls/ExpressionText.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <cmath>
#include <numbers>

using namespace handwheel;

namespace {

const QLocale kGerman(QLocale::German, QLocale::Germany);

// A field in a window, with what it says.
struct Bench {
  explicit Bench(Quantity quantity = Quantity::Length, LengthUnit unit = LengthUnit::Millimetre,
                 const QLocale& locale = QLocale::c()) {
    window.setLocale(locale);
    field = new NumberField(&window);
    other = new QLineEdit(&window);
    auto* column = new QVBoxLayout(&window);
    column->addWidget(field);
    column->addWidget(other);
    field->setQuantity(quantity, unit);
    field->setLabel("Diameter");
    line = field->findChild<QLineEdit*>("numberLine");
    spy = std::make_unique<QSignalSpy>(field, &NumberField::valueEdited);
    window.show();
    window.activateWindow();
    if (!QTest::qWaitForWindowActive(&window)) qFatal("the window does not appear");
    line->setFocus();
  }
  void type(const QString& text) {
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, text);
  }
  void enter(const QString& text) {
    type(text);
    QTest::keyClick(line, Qt::Key_Return);
  }
  // The values said so far, without the last digits, and whether each was on the way.
  QList<std::pair<double, bool>> said() {
    QList<std::pair<double, bool>> values;
    for (const QList<QVariant>& call : *spy) {
      values << std::pair(std::round(call[0].toDouble() * 1e9) / 1e9, call[1].toBool());
    }
    spy->clear();
    return values;
  }
  bool turnWheel(int notches, Qt::KeyboardModifiers modifiers = {}) {
    const QPointF middle = line->rect().center();
    QWheelEvent event(middle, line->mapToGlobal(middle), {}, QPoint(0, 120 * notches), Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(line, &event);
    return event.isAccepted();
  }

  QWidget window;
  NumberField* field;
  QLineEdit* other;
  QLineEdit* line;
  std::unique_ptr<QSignalSpy> spy;
};

using Said = QList<std::pair<double, bool>>;

}  // namespace

class NumberFieldTest : public QObject {
  Q_OBJECT

 private slots:
  void takesExpressions();
  void takesOtherUnits();
  void speaksGerman();
  void anglesAreDegrees();
  void steps();
  void stepsOfSmallValues();
  void stepsStayInRange();
  void wheelNeedsTheFocus();
  void refusesAndSaysWhy();
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

void NumberFieldTest::steps() {
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

void NumberFieldTest::stepsOfSmallValues() {
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

void NumberFieldTest::stepsStayInRange() {
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

void NumberFieldTest::wheelNeedsTheFocus() {
  Bench bench;
  bench.other->setFocus();
  QVERIFY(!bench.turnWheel(1));
  QCOMPARE(bench.said(), Said());
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
