// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExpressionResults.h"
#include "TestClass.h"

#include <rapidcheck.h>

#include <QTest>
#include <charconv>
#include <cmath>
#include <memory>
#include <random>

using namespace handwheel;
using namespace handwheel::test;
using Kind = ExpressionError::Kind;

namespace {

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
  long double size = 0.0L;  // largest of the terms, to which the rounding is relative
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
    // The size of a divisor that is nearly zero by cancellation makes any other bound useless.
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

// Prints with few brackets, so that the order of operations is tested, and with blanks here and there.
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

// Tests with random expressions and random text.
class ExpressionPropertiesTest : public QObject {
  Q_OBJECT

 private slots:
  void agreesWithTrees();
  void survivesAnything();
};

void ExpressionPropertiesTest::agreesWithTrees() {
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

void ExpressionPropertiesTest::survivesAnything() {
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

HANDWHEEL_TEST(ExpressionPropertiesTest)
#include "ExpressionPropertiesTest.moc"
