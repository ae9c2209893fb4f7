// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExpressionResults.h"
#include "TestClass.h"

#include <QTest>
#include <clocale>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;
using Kind = ExpressionError::Kind;

namespace {

constexpr double kPi = 3.14159265358979323846;

}  // namespace

class ExpressionTest : public QObject {
  Q_OBJECT

 private slots:
  void values_data();
  void values();
  void errors_data();
  void errors();
  void bounds();
  void noLocaleMatters();
};

void ExpressionTest::values_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<double>("expected");
  QTest::addColumn<ExpressionField>("field");
  const auto row = [](const char* text, double expected, const ExpressionField& field) {
    QTest::newRow(text) << QByteArray(text) << expected << field;
  };
  row("25.4/2", 12.7, kLength);
  row("25.4/2 ", 322.58, kInches);
  row("0.5", 500.0, {Quantity::Length, LengthUnit::Metre});
  row("0.5 m + 1 m", 1500.0, {Quantity::Length, LengthUnit::Metre});
  row("1 in + 2mm", 27.4, kLength);
  row("2*(3+4)", 14.0, kNumber);
  row("90deg", kPi / 2, kAngle);
  row("90", kPi / 2, kAngle);
  row("90\u00b0 - 1\u00b0*45", kPi / 4, kAngle);
  row("pi/2 rad", kPi / 2, kAngle);
  row("\u03c0 rad / 4", kPi / 4, kAngle);
  row("1/2 in", 12.7, kLength);
  row("10 / 4 mm * 2", 5.0, kLength);
  row("2mm/4mm", 0.5, kNumber);
  row("2mm/4mm ", 0.5, kLength);    // a ratio is a bare number
  row("3/2mm/2mm", 0.75, kNumber);  // half of three, in mm, through two
  row("1 + 2*3mm", 7.0, kLength);
  row("1 + 25.4mm", 50.8, kInches);
  row("(1+25.4mm)/2", 25.4, kInches);
  row("--5", 5.0, kNumber);
  row("-2*-3", 6.0, kNumber);
  row("3 - -2", 5.0, kNumber);
  row("2 - 3 - 4", -5.0, kNumber);
  row("64/4/2", 8.0, kNumber);
  row(".5", 0.5, kNumber);
  row("5.", 5.0, kNumber);
  row("1,5", 1.5, kNumber);
  row("0,125", 0.125, kNumber);
  row("1234,567", 1234.567, kNumber);
  row("1,2345", 1.2345, kNumber);
  row("1,234e0", 1.234, kNumber);
  row("1,234", 1.234, kGermanLength);
  row("1.234", 1.234, kGermanLength);
  row("1e3 mm", 1000.0, kLength);
  row("2E-3m", 2.0, kLength);
  row("250 \u00b5m", 0.25, kLength);
  row("250\u03bcm", 0.25, kLength);
  row("250 um", 0.25, kLength);
  row("3\"", 76.2, kLength);
  row("3\u2033+1 INCH", 101.6, kLength);
  row("2\u00d73 \u2212 8\u00f74", 4.0, kNumber);
  row("1\u00a0000", std::nan(""), kNumber);
  row("1e-999", 0.0, kNumber);
  row("-0", 0.0, kNumber);
}

void ExpressionTest::values() {
  QFETCH(QByteArray, text);
  QFETCH(double, expected);
  QFETCH(ExpressionField, field);
  const double value = valueOf(text.toStdString(), field);
  if (std::isnan(expected)) {
    QVERIFY(std::isnan(value));
    return;
  }
  QVERIFY2(std::abs(value - expected) <= 1e-14 * std::abs(expected), QByteArray::number(value, 'g', 17));
  QVERIFY(!std::signbit(value) || expected < 0.0);
}

void ExpressionTest::errors_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<ExpressionField>("field");
  QTest::addColumn<Kind>("kind");
  QTest::addColumn<int>("column");
  QTest::addColumn<QByteArray>("found");
  const auto row = [](const char* text, const ExpressionField& field, Kind kind, int column, const char* found = "") {
    QTest::newRow(*text ? text : "nothing") << QByteArray(text) << field << kind << column << QByteArray(found);
  };
  row("", kLength, Kind::Empty, 1);
  row("  \u00a0", kLength, Kind::Empty, 1);
  row("1+", kLength, Kind::NumberMissing, 3);
  row("2*/3", kLength, Kind::NumberMissing, 3, "/");
  row("mm", kLength, Kind::NumberMissing, 1, "mm");
  row("()", kLength, Kind::NumberMissing, 2, ")");
  row("2 3", kLength, Kind::OperatorMissing, 3, "3");
  row("2(3)", kLength, Kind::OperatorMissing, 2, "(");
  row("2 mm mm", kLength, Kind::OperatorMissing, 6, "mm");
  row("2 pi", kNumber, Kind::OperatorMissing, 3, "pi");
  row("3)", kLength, Kind::OperatorMissing, 2, ")");
  row("(1+2", kLength, Kind::BracketMissing, 5);
  row("(1+2 3", kLength, Kind::BracketMissing, 6, "3");
  row("1.2.3", kLength, Kind::NumberMalformed, 1, "1.2.3");
  row("1.234,5", kLength, Kind::NumberMalformed, 1, "1.234,5");
  row("2 + .", kLength, Kind::NumberMalformed, 5, ".");
  row("1,234", kLength, Kind::CommaAmbiguous, 1, "1,234");
  row("12 parsec", kLength, Kind::NameUnknown, 4, "parsec");
  row("\u2212\u00d7", kLength, Kind::NumberMissing, 2, "\u00d7");
  row("\u6beb\u7c73 1", kLength, Kind::NameUnknown, 1, "\u6beb\u7c73");
  row("\u00b5 \u00b5", kLength, Kind::NameUnknown, 1, "\u00b5");
  row("2mm + 3deg", kLength, Kind::UnlikeTerms, 5);
  row("2 + 3deg", kLength, Kind::UnlikeTerms, 3);
  row("2 + 3mm", kNumber, Kind::UnlikeTerms, 3);
  row("2deg", kLength, Kind::WrongQuantity, 1);
  row("2mm*3mm", kLength, Kind::WrongQuantity, 1);

  row("2mm", kNumber, Kind::WrongQuantity, 1);
  row("1/0", kLength, Kind::DivisionByZero, 3);
  row("1/(2-2) + 1/0", kLength, Kind::DivisionByZero, 3);
  row("1e999", kLength, Kind::TooLarge, 1);
  row("1e308*10", kLength, Kind::TooLarge, 6);
  row("1e308+1e308", kLength, Kind::TooLarge, 6);
  row("1e308 in", kLength, Kind::TooLarge, 7);
}

void ExpressionTest::errors() {
  QFETCH(QByteArray, text);
  QFETCH(ExpressionField, field);
  QFETCH(Kind, kind);
  QFETCH(int, column);
  QFETCH(QByteArray, found);
  const ExpressionError error = errorOf(text.toStdString(), field);
  QCOMPARE(int(error.kind), int(kind));
  QCOMPARE(int(error.column), column);
  QCOMPARE(QByteArray::fromStdString(error.found), found);
}

void ExpressionTest::bounds() {
  const auto nested = [](int depth) { return std::string(depth, '(') + "1" + std::string(depth, ')'); };
  QCOMPARE(valueOf(nested(kDeepestExpression), kNumber), 1.0);
  QVERIFY(errorOf(nested(kDeepestExpression + 1), kNumber).kind == Kind::TooDeep);
  QCOMPARE(errorOf(nested(kDeepestExpression + 1), kNumber).column, std::size_t(kDeepestExpression + 1));
  QCOMPARE(valueOf(std::string(kLongestExpression - 1, '-') + "1", kNumber), -1.0);
  QVERIFY(errorOf(std::string(kLongestExpression, '-') + "1", kNumber).kind == Kind::TooLong);
  QVERIFY(errorOf(std::string(1 << 20, '('), kNumber).kind == Kind::TooLong);
  QCOMPARE(valueOf("1" + std::string(200, '0') + "e-200", kNumber), 1.0);
  QCOMPARE(valueOf("0." + std::string(199, '0') + "1e200", kNumber), 1.0);
}

void ExpressionTest::noLocaleMatters() {
  if (!std::setlocale(LC_NUMERIC, "de_DE.UTF-8")) QSKIP("the locale de_DE.UTF-8 is not installed");
  QCOMPARE(valueOf("1.5+1", kNumber), 2.5);
  QCOMPARE(valueOf("1,5+1", kNumber), 2.5);
  QVERIFY(errorOf("1,234", kNumber).kind == Kind::CommaAmbiguous);
  std::setlocale(LC_NUMERIC, "C");
}

HANDWHEEL_TEST(ExpressionTest)
#include "ExpressionTest.moc"
