// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/Expression.h"

#include <rapidcheck.h>

#include <QTest>
#include <charconv>
#include <clocale>
#include <cmath>
#include <memory>
#include <random>

using namespace handwheel;
using Kind = ExpressionError::Kind;

namespace {

constexpr double kPi = 3.14159265358979323846;

// The value, or NaN for an error.
double valueOf(const std::string& text, const ExpressionField& field) {
  const ExpressionResult result = evaluateExpression(text, field);
  const double* value = std::get_if<double>(&result);
  return value ? *value : std::nan("");
}

ExpressionError errorOf(const std::string& text, const ExpressionField& field) {
  const ExpressionResult result = evaluateExpression(text, field);
  const auto* error = std::get_if<ExpressionError>(&result);
  return error ? *error : ExpressionError{Kind::Empty, 0, "no error"};
}

const ExpressionField kLength{Quantity::Length};
const ExpressionField kInches{Quantity::Length, LengthUnit::Inch};
const ExpressionField kAngle{Quantity::Angle};
const ExpressionField kNumber{};
const ExpressionField kGermanLength{Quantity::Length, LengthUnit::Millimetre, true};

// A random expression as a tree, which is evaluated and printed without the parser's grammar.
struct Node {
  char op = '0';  // + - * / ~ (change of sign), 0 for a number
  double number = 0.0;
  std::string unit;
  std::unique_ptr<Node> left, right;
};

std::unique_ptr<Node> randomTree(std::mt19937& random, int depth) {
  auto node = std::make_unique<Node>();
  const int choice = int(random() % 8);
  if (depth == 0 || choice < 2) {
    static const char* const kUnits[] = {"", "", "", "mm", "cm", "in", "deg", "rad"};
    node->number = (random() % 5 == 0) ? 0.0 : double(random() % 4000) / 16.0;
    node->unit = kUnits[random() % std::size(kUnits)];
    return node;
  }
  node->op = choice == 2 ? '~' : "+-*/"[random() % 4];
  node->left = randomTree(random, depth - 1);
  if (node->op != '~') node->right = randomTree(random, depth - 1);
  return node;
}

struct Outcome {
  long double value = 0.0L;
  long double size = 0.0L;  // of the largest terms: what the rounding is measured by
  int length = 0, angle = 0;
  bool failed = false;
  Kind kind = Kind::Empty;
};

Outcome failed(Kind kind) {
  Outcome outcome;
  outcome.failed = true;
  outcome.kind = kind;
  return outcome;
}

Outcome scaled(Outcome o, const std::string& unit) {
  const bool length = unit == "mm" || unit == "cm" || unit == "in";
  const long double factor = unit == "cm"    ? 10.0L
                             : unit == "in"  ? 25.4L
                             : unit == "deg" ? 3.14159265358979323846264338327950288L / 180.0L
                                             : 1.0L;
  o.value *= factor;
  o.size *= factor;
  o.length += length;
  o.angle += !length && !unit.empty();
  return o;
}

Outcome evaluated(const Node& node, const std::string& fieldUnit) {
  if (node.op == '0') {
    Outcome o;
    o.value = node.number;
    o.size = node.number;
    return scaled(o, node.unit);
  }
  Outcome a = evaluated(*node.left, fieldUnit);
  if (a.failed) return a;
  if (node.op == '~') {
    a.value = -a.value;
    return a;
  }
  Outcome b = evaluated(*node.right, fieldUnit);
  if (b.failed) return b;
  if (node.op == '*' || node.op == '/') {
    if (node.op == '/' && b.value == 0.0L) return failed(Kind::DivisionByZero);
    const int sign = node.op == '*' ? 1 : -1;
    // A divisor that is nearly zero by cancellation makes any bound useless; its own size tells.
    const long double share = b.size / std::abs(b.value);
    a.size = node.op == '*' ? a.size * b.size : a.size / std::abs(b.value) * share;
    a.value = node.op == '*' ? a.value * b.value : a.value / b.value;
    a.length += sign * b.length;
    a.angle += sign * b.angle;
    return a;
  }
  const bool alike = a.length == b.length && a.angle == b.angle;
  if (!alike && a.length == 0 && a.angle == 0) a = scaled(a, fieldUnit);
  if (!alike && b.length == 0 && b.angle == 0) b = scaled(b, fieldUnit);
  if (a.length != b.length || a.angle != b.angle) return failed(Kind::UnlikeTerms);
  a.value += node.op == '+' ? b.value : -b.value;
  a.size += b.size;
  return a;
}

int rank(char op) {
  return op == '+' || op == '-' ? 1 : op == '*' || op == '/' ? 2 : 3;
}

std::string printed(const Node& node, std::mt19937& random);

std::string inBrackets(const Node& node, bool needed, std::mt19937& random) {
  const std::string text = printed(node, random);
  return needed || random() % 8 == 0 ? "(" + text + ")" : text;
}

// With few brackets, so that the order of operations is tested, and with blanks here and there.
std::string printed(const Node& node, std::mt19937& random) {
  const auto blank = [&] { return random() % 2 ? " " : ""; };
  if (node.op == '0') {
    char digits[32];
    const auto length = std::to_chars(digits, digits + sizeof digits, node.number).ptr - digits;
    return std::string(digits, std::size_t(length)) + blank() + node.unit;
  }
  if (node.op == '~') return "-" + inBrackets(*node.left, node.left->op != '0' || !node.left->unit.empty(), random);
  // A unit within a product would belong to all of it.
  const auto hasUnit = [](const Node& n) { return n.op == '0' && !n.unit.empty(); };
  const bool product = rank(node.op) == 2;
  const bool left = rank(node.left->op) < rank(node.op) || (product && hasUnit(*node.left));
  const bool right = rank(node.right->op) <= rank(node.op) || (product && hasUnit(*node.right));
  return inBrackets(*node.left, left, random) + blank() + node.op + blank() + inBrackets(*node.right, right, random);
}

}  // namespace

Q_DECLARE_METATYPE(handwheel::ExpressionField)
Q_DECLARE_METATYPE(handwheel::ExpressionError::Kind)

class ExpressionTest : public QObject {
  Q_OBJECT

 private slots:
  void values_data();
  void values();
  void errors_data();
  void errors();
  void bounds();
  void noLocaleMatters();
  void agreesWithTrees();
  void survivesAnything();
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

void ExpressionTest::agreesWithTrees() {
  int values = 0;
  QVERIFY(rc::check("text and tree give the same value or the same error", [&values] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const struct {
      ExpressionField field;
      const char* unit;
    } kinds[] = {{kLength, "mm"}, {kInches, "in"}, {kAngle, "deg"}, {kNumber, ""}};
    for (int i = 0; i < 40; ++i) {
      const auto& [field, unit] = kinds[random() % 4];
      const auto tree = randomTree(random, int(random() % 5));
      const std::string text = printed(*tree, random);
      if (text.size() > kLongestExpression) continue;
      Outcome expected = evaluated(*tree, unit);
      if (!expected.failed && expected.length == 0 && expected.angle == 0) expected = scaled(expected, unit);
      const bool wanted = expected.length == int(field.quantity == Quantity::Length) &&
                          expected.angle == int(field.quantity == Quantity::Angle);
      if (!expected.failed && !wanted) expected = failed(Kind::WrongQuantity);
      RC_LOG() << text << "\n";
      if (expected.failed) {
        RC_ASSERT(int(errorOf(text, field).kind) == int(expected.kind));
      } else {
        ++values;
        RC_ASSERT(std::abs(valueOf(text, field) - double(expected.value)) <= 1e-13 * double(expected.size));
      }
    }
  }));
  QVERIFY(values > 200);  // not only errors
}

void ExpressionTest::survivesAnything() {
  static const char* const kPieces[] = {"1",  "2.5", "0",    ",",    ".",   "(",      ")",      "+",  "-",      "*",
                                        "/",  " ",   "mm",   "in",   "deg", "\u00b0", "\u00b5", "pi", "\u03c0", "e",
                                        "e9", "\"",  "\xff", "\xc3", "x",   "\u00d7", "1e400",  "rad"};
  QVERIFY(rc::check("any text gives a finite value or an error within it", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    for (int i = 0; i < 100; ++i) {
      std::string text;
      for (auto n = random() % 24; n > 0; --n) {
        if (random() % 16 == 0) {
          text += char(random());
        } else {
          text += kPieces[random() % std::size(kPieces)];
        }
      }
      const ExpressionResult result = evaluateExpression(text, random() % 2 ? kLength : kAngle);
      if (const double* value = std::get_if<double>(&result)) {
        RC_ASSERT(std::isfinite(*value));
      } else {
        RC_ASSERT(std::get<ExpressionError>(result).column >= 1);
        RC_ASSERT(std::get<ExpressionError>(result).column <= text.size() + 1);
      }
    }
  }));
}

QTEST_GUILESS_MAIN(ExpressionTest)
#include "ExpressionTest.moc"
