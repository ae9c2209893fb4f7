// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "document/formats/MeshTextValues.h"

#include <rapidcheck.h>
#include <QTest>
#include <bit>
#include <charconv>
#include <cmath>

using namespace handwheel;

class MeshTextValuesTest : public QObject {
  Q_OBJECT
 private slots:
  void words() {
    TextScanner scanner("  one\ttwo \r\n\r\n three # four\r# five\nsix\\\nseven \\\n eight", {'#', '\\'});
    QCOMPARE(scanner.word(), std::string_view("one"));
    QCOMPARE(scanner.peek(), std::string_view("two"));
    QCOMPARE(scanner.word(), std::string_view("two"));
    QVERIFY(scanner.word().empty());
    QCOMPARE(scanner.inputPosition().value, std::uint64_t{1});
    QCOMPARE(scanner.wordOnAnyLine(), std::string_view("three"));
    QCOMPARE(scanner.inputPosition().value, std::uint64_t{3});
    QVERIFY(scanner.word().empty());
    QCOMPARE(scanner.wordOnAnyLine(), std::string_view("six"));
    QCOMPARE(scanner.inputPosition().value, std::uint64_t{5});
    QCOMPARE(scanner.word(), std::string_view("seven"));
    QCOMPARE(scanner.word(), std::string_view("eight"));
    QCOMPARE(scanner.inputPosition().value, std::uint64_t{7});
    QVERIFY(!scanner.nextLine());
    QVERIFY(scanner.wordOnAnyLine().empty());
  }

  void comments() {
    TextScanner scanner("a#b #c\\\nd", {'#', '\\'});
    QCOMPARE(scanner.word(), std::string_view("a#b"));
    QVERIFY(scanner.word().empty());
    QVERIFY(scanner.nextLine());
    QCOMPARE(scanner.word(), std::string_view("d"));
  }

  void continuedLinesAreOne() {
    TextScanner scanner("a b \\\n c \\\r\n d\ne", {-1, '\\'});
    QCOMPARE(scanner.word(), std::string_view("a"));
    QVERIFY(scanner.nextLine());
    QCOMPARE(scanner.word(), std::string_view("e"));
    QCOMPARE(scanner.inputPosition().value, std::uint64_t{4});
  }

  void emptyTexts() {
    for (std::string_view text : {"", " ", "\n", "\r\n\r", "#", "\\", "\\\n", "\xEF\xBB\xBF"}) {
      TextScanner scanner(text, {'#', '\\'});
      while (scanner.findWord()) QCOMPARE(scanner.word(), std::string_view("\\"));
      QCOMPARE(scanner.position(), text.size());
    }
  }

  void numbers_data() {
    QTest::addColumn<QByteArray>("word");
    QTest::addColumn<double>("value");
    const std::initializer_list<std::pair<const char*, double>> rows = {{"0", 0},
                                                                        {"-0", 0},
                                                                        {"1.5", 1.5},
                                                                        {"+1.5", 1.5},
                                                                        {"-1.5", -1.5},
                                                                        {".5", 0.5},
                                                                        {"-.5", -0.5},
                                                                        {"+.5", 0.5},
                                                                        {"5.", 5},
                                                                        {"1.e5", 1e5},
                                                                        {"1E+05", 1e5},
                                                                        {"1e-0005", 1e-5},
                                                                        {".8e-001", 0.08},
                                                                        {"1e308", 1e308},
                                                                        {"1e-400", 0},
                                                                        {"-1e-400", 0},
                                                                        {"0e999999999", 0},
                                                                        {"4.9e-324", 4.9e-324},
                                                                        {"0.000e500", 0},
                                                                        {"2.5e-310", 2.5e-310},
                                                                        {"1e-99999999999999999999", 0},
                                                                        {"000000000000000000000000000000000000001", 1}};
    for (const auto& [word, value] : rows) QTest::newRow(word) << QByteArray(word) << value;
    QTest::newRow("500 zeros") << "0." + QByteArray(500, '0') + "1" << 0.0;
    QTest::newRow("500 zeros, raised") << "0." + QByteArray(500, '0') + "1e501" << 1.0;
    QTest::newRow("500 digits, lowered") << "1" + QByteArray(500, '0') + "e-500" << 1.0;
  }

  void numbers() {
    QFETCH(QByteArray, word);
    QFETCH(double, value);
    double parsed = 99;
    ErrorCode why;
    QVERIFY(parseNumber(word.constData(), parsed, why));
    QVERIFY2(parsed == value, qPrintable(QString::number(parsed)));
  }

  void noNumbers() {
    double value;
    ErrorCode why;
    for (const char* word : {"", "x", "1x", "1,5", "+-1", "--1", "++1", "+", "-", ".", "e5", "1e", "1e+", "0x10", "1 2",
                             "3.1+e2", "1.5f", "1d5"}) {
      QVERIFY2(!parseNumber(word, value, why), word);
      QVERIFY2(why == ErrorCode::NumberMalformed, word);
    }
    for (const char* word : {"nan", "-nan", "NaN", "inf", "+inf", "-Inf", "infinity", "1e309", "-1e309", "1.#IND",
                             "-1.#INF", "1.#QNAN", "1e99999999999999999999", "0.001e400"}) {
      QVERIFY2(!parseNumber(word, value, why), word);
      QVERIFY2(why == ErrorCode::NumberNotFinite, word);
    }
    const std::string digits(400, '9');
    QVERIFY(!parseNumber(digits, value, why));
    QVERIFY(why == ErrorCode::NumberNotFinite);
  }

  void integers() {
    QVERIFY(parseInteger("7") == 7);
    QVERIFY(parseInteger("+7") == 7);
    QVERIFY(parseInteger("-7") == -7);
    QVERIFY(parseInteger("7.0") == 7);
    QVERIFY(parseInteger("7e2") == 700);
    QVERIFY(parseInteger("9223372036854775807") == std::numeric_limits<std::int64_t>::max());
    for (const char* word : {"", "x", "7x", "7.5", "9223372036854775808", "1e30", "nan", "inf", "0x7"})
      QVERIFY2(!parseInteger(word), word);
  }

  // The shortest digits that the standard library prints are read back to the same bits.
  void everyDoubleIsReadBack() {
    QVERIFY(rc::check([] {
      const auto value = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
      RC_PRE(std::isfinite(value));
      char digits[64];
      const auto end = std::to_chars(std::begin(digits), std::end(digits), value).ptr;
      double back = 0.0;
      ErrorCode why;
      RC_ASSERT(parseNumber({digits, static_cast<std::size_t>(end - digits)}, back, why));
      RC_ASSERT(std::bit_cast<std::uint64_t>(back) == std::bit_cast<std::uint64_t>(value));
    }));
  }
};

HANDWHEEL_TEST(MeshTextValuesTest)
#include "MeshTextValuesTest.moc"
