// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/NumberText.h"

#include <QTest>
#include <cmath>
#include <string>

using namespace handwheel;

class NumberTextTest : public QObject {
  Q_OBJECT

 private slots:
  void numbers();
  void notFiniteOnes();
  void refuses();
  void rounded();
};

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

HANDWHEEL_TEST(NumberTextTest)
#include "NumberTextTest.moc"
