// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/NumberText.h"
#include "base/ShownDistance.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <string>

using namespace handwheel;

class NumberTextTest : public QObject {
  Q_OBJECT

 private slots:
  void numbers();
  void notFiniteOnes();
  void refuses();
  void rounded();
  void roundedNumbers();
  void shown();
  void limitsAsShown();
  void distances();
};

// Never more than the distance: tenths, below 1 mm thousandths.
void NumberTextTest::distances() {
  const std::pair<double, const char*> kTexts[] = {{16.98, "16.9"},   {17.0, "17"},      {0.1779, "0.177"},
                                                   {0.9999, "0.999"}, {1.0, "1"},        {0.0, "0"},
                                                   {0.3, "0.3"},      {-2.0001, "-2.1"}, {123456.78, "123456.7"}};
  for (const auto& [distance, text] : kTexts) QCOMPARE(shownText(shownDistance(distance)), std::string(text));
  QVERIFY(std::isinf(shownDistance(HUGE_VAL)) && std::isnan(shownDistance(std::nan(""))));
}

// The expectations are the definition: within a millionth, and no text with a digit less is.
void NumberTextTest::shown() {
  const std::pair<double, const char*> kTexts[] = {{0.0, "0"},
                                                   {-0.0, "0"},
                                                   {110.00223, "110.0022"},
                                                   {30.0 - 4e-15, "30"},
                                                   {-2.0 / 3.0, "-0.666667"},
                                                   {1234567.8, "1234568"},
                                                   {1e-9, "1e-09"},
                                                   {2.5e15, "2.5e+15"},
                                                   {25.4, "25.4"}};
  for (const auto& [value, text] : kTexts) QCOMPARE(shownText(value), std::string(text));
}

void NumberTextTest::limitsAsShown() {
  const double limit = 110.00223;
  QCOMPARE(withinShownLimits(110.0022, -limit, limit), 110.0022);  // it lies within
  QCOMPARE(withinShownLimits(-110.0023, -limit, limit), -limit);
  QCOMPARE(withinShownLimits(110.003, -limit, limit), std::optional<double>());
  QCOMPARE(withinShownLimits(5.0, -limit, limit), 5.0);
  QCOMPARE(withinShownLimits(-1e-12, 0.0, 1.0), std::optional<double>());
  QCOMPARE(withinShownLimits(5.0, -HUGE_VAL, HUGE_VAL), 5.0);
  for (double none : {HUGE_VAL, std::nan("")})
    QCOMPARE(withinShownLimits(none, -HUGE_VAL, HUGE_VAL), std::optional<double>());
}

void NumberTextTest::numbers() {
  const std::string zeros(400, '0');
  const std::pair<std::string, double> kGood[] = {{"+2", 2.0},    {".5", 0.5},     {"1.", 1.0},
                                                  {"-1e3", -1e3}, {"1e-400", 0.0}, {"0." + zeros + "1e5", 0.0}};
  for (const auto& [word, expected] : kGood) {
    double value = -1.0;
    ErrorCode why;
    QVERIFY2(parseDecimal(word, value, why), word.c_str());
    QCOMPARE(value, expected);
  }
}

void NumberTextTest::notFiniteOnes() {
  double value = 0.0;
  ErrorCode why;
  QVERIFY(parseDecimal("-inf", value, why) && value == -HUGE_VAL);
  QVERIFY(parseDecimal("nan", value, why) && std::isnan(value));
}

void NumberTextTest::refuses() {
  const std::pair<std::string, ErrorCode> kBad[] = {
      {"", ErrorCode::NumberMalformed},      {"+-1", ErrorCode::NumberMalformed},
      {"1,5", ErrorCode::NumberMalformed},   {"0x1", ErrorCode::NumberMalformed},
      {"1e400", ErrorCode::NumberNotFinite}, {"1" + std::string(400, '0') + "e-5", ErrorCode::NumberNotFinite}};
  for (const auto& [word, expected] : kBad) {
    double value = 0.0;
    ErrorCode why = ErrorCode::Cancelled;
    QVERIFY2(!parseDecimal(word, value, why), word.c_str());
    QCOMPARE(why, expected);
  }
}

void NumberTextTest::rounded() {
  QCOMPARE(roundedText(0.04438398609306824), std::string("0.044384"));
  QCOMPARE(roundedText(-1234.5678, 3), std::string("-1.23e+03"));
  QCOMPARE(roundedText(-0.0), std::string("0"));
  QCOMPARE(roundedText(2.5), std::string("2.5"));
}

// The numbers that a person writes, and at the ends of the range of double the number itself.
void NumberTextTest::roundedNumbers() {
  const struct {
    double value;
    int digits;
    double expected;
  } kRounded[] = {{123.456, 4, 123.5},   {-123.456, 4, -123.5}, {0.00123456, 4, 0.001235}, {999.96, 4, 1000.0},
                  {98765.0, 2, 99000.0}, {0.84, 1, 0.8},        {1000.0, 4, 1000.0},       {2.5, 1, 3.0},
                  {-2.5, 1, -3.0},       {6.25e-7, 2, 6.3e-7},  {4e300, 4, 4e300}};
  for (const auto& each : kRounded) QCOMPARE(roundedNumber(each.value, each.digits), each.expected);
  // The results have as few decimals as their texts: no 0.30000000000000004.
  for (int i = 1; i < 10'000; ++i) QVERIFY(roundedNumber(i / 1e5 + 1e-12, 4) == i / 1e5);
  const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
  for (const double same : {0.0, least, -least, most, -most, HUGE_VAL, -HUGE_VAL})
    QVERIFY(roundedNumber(same, 4) == same);
  QVERIFY(std::isnan(roundedNumber(std::nan(""), 4)));
}

HANDWHEEL_TEST(NumberTextTest)
#include "NumberTextTest.moc"
