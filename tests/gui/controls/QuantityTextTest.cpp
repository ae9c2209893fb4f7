// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "controls/QuantityText.h"

#include <rapidcheck.h>

#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

using namespace handwheel;

namespace {
const QLocale kQuantityTextGerman(QLocale::German, QLocale::Germany);
}

class QuantityTextTest : public QObject {
  Q_OBJECT

 private slots:
  void numbersAsShort_data();
  void numbersAsShort();
  void numbersAreNearEnoughAndNoLonger();
  void quantities();
  void numbersInTexts();
};

void QuantityTextTest::numbersAsShort_data() {
  QTest::addColumn<double>("value");
  QTest::addColumn<QString>("text");
  const auto row = [](double value, const char* text) { QTest::newRow(text) << value << QString::fromUtf8(text); };
  row(0.0, "0");
  row(-0.0, "0 ");
  row(0.003, "0.003");
  row(12.7, "12.7");
  row(25.4 / 25.4, "1");
  row(0.1 + 0.2, "0.3");
  row(-1e-7, "-0.0000001");
  row(3e-9, "3e-09");
  row(1.0 / 3.0, "0.333333");
  row(2.0 / 3.0, "0.666667");
  row(90.0 + 1e-12, "90");
  row(1000000.0, "1000000");
  row(1234567.0, "1234567");
  row(1e15, "1e+15");
  row(INFINITY, "∞");
  row(-INFINITY, "−∞");
  row(std::nan(""), "—");
}

void QuantityTextTest::numbersAsShort() {
  QFETCH(double, value);
  QFETCH(QString, text);
  QCOMPARE(numberText(value, QLocale::c()), text.trimmed());
}

void QuantityTextTest::numbersAreNearEnoughAndNoLonger() {
  QVERIFY(rc::check("number texts", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const double value = std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random),
                                    std::uniform_int_distribution(-60, 60)(random));
    const QString text = numberText(value, QLocale::c());
    RC_ASSERT(std::abs(text.toDouble() - value) <= 1.0000001e-6 * std::abs(value));
    // One digit less would be too far away.
    const bool exponent = text.contains('e');
    const int digits = text.contains('.') ? text.section('.', 1).section('e', 0, 0).size() : 0;
    if (digits > 0) {
      const double shorter = QString::number(value, exponent ? 'e' : 'f', digits - 1).toDouble();
      RC_ASSERT(std::abs(shorter - value) > 1e-6 * std::abs(value));
    }
    RC_ASSERT(numberText(value, kQuantityTextGerman) == QString(text).replace('.', ','));
  }));
}

// The numbers that a German types for limits and tolerances; a point is accepted, too, and files have points.
void QuantityTextTest::numbersInTexts() {
  QCOMPARE(withLocalNumbers("±0.05", kQuantityTextGerman), QString("±0,05"));
  QCOMPARE(withLocalNumbers("1.5; 2; -0.25", kQuantityTextGerman), QString("1,5; 2; -0,25"));
  QCOMPARE(withLocalNumbers("h10", kQuantityTextGerman), QString("h10"));
  for (const char* typed : {"±0,05", "±0.05"}) QCOMPARE(withPoints(typed, kQuantityTextGerman), QString("±0.05"));
  QCOMPARE(withPoints("1,5; 2,25;,5", kQuantityTextGerman), QString("1.5; 2.25;.5"));
  QCOMPARE(withPoints("35,95", QLocale::c()), QString("35.95"));  // the same as in all other fields
  QCOMPARE(withLocalNumbers("1.5", QLocale::c()), QString("1.5"));
}

void QuantityTextTest::quantities() {
  QCOMPARE(quantityText(12.7, Quantity::Length, LengthUnit::Inch, QLocale::c()), QString("0.5\u00a0in"));
  QCOMPARE(quantityText(12.7, Quantity::Length, LengthUnit::Millimetre, kQuantityTextGerman), QString("12,7\u00a0mm"));
  QCOMPARE(quantityText(std::numbers::pi / 2, Quantity::Angle, LengthUnit::Metre, QLocale::c()), QString("90°"));
  QCOMPARE(quantityText(-2.5, Quantity::Number, LengthUnit::Metre, QLocale::c()), QString("-2.5"));
  // The rounding error of an angle of 0; one of a millionth of a degree is meant.
  for (const double noise : {4e-13, -4e-13, -0.0})
    QCOMPARE(quantityText(noise, Quantity::Angle, LengthUnit::Metre, QLocale::c()), QString("0°"));
  QCOMPARE(quantityText(kRadiansPerDegree * 1e-6, Quantity::Angle, LengthUnit::Metre, QLocale::c()),
           QString("0.000001°"));
}

HANDWHEEL_TEST(QuantityTextTest)
#include "QuantityTextTest.moc"
