// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/Expression.h"

#include "base/ExpressionScanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

namespace handwheel {

namespace {

using Kind = ExpressionError::Kind;

// The value of a number, with the powers of its units.
struct Value {
  double number = 0.0;  // mm, radian
  int length = 0;
  int angle = 0;

  bool isBare() const { return length == 0 && angle == 0; }
  bool isLike(const Value& other) const { return length == other.length && angle == other.angle; }
};

struct Unit {
  std::string_view name;  // lower case
  Value value;
};

constexpr Unit kUnits[] = {
    {"mm", {1.0, 1, 0}},
    {"cm", {10.0, 1, 0}},
    {"m", {1000.0, 1, 0}},
    {"um", {1e-3, 1, 0}},
    {"\u00b5m", {1e-3, 1, 0}},  // micro sign
    {"\u03bcm", {1e-3, 1, 0}},  // Greek mu
    {"in", {25.4, 1, 0}},
    {"inch", {25.4, 1, 0}},
    {"\"", {25.4, 1, 0}},
    {"\u2033", {25.4, 1, 0}},  // double prime
    {"deg", {kRadiansPerDegree, 0, 1}},
    {"\u00b0", {kRadiansPerDegree, 0, 1}},
    {"rad", {1.0, 0, 1}},
};

Value unitOf(const ExpressionField& field) {
  switch (field.quantity) {
    case Quantity::Length:
      return {millimetresPer(field.lengthUnit), 1, 0};
    case Quantity::Angle:
      return {kRadiansPerDegree, 0, 1};
    case Quantity::Number:
      break;
  }
  return {1.0, 0, 0};
}

const Unit* unitNamed(std::string_view word) {
  const auto* unit =
      std::find_if(std::begin(kUnits), std::end(kUnits), [word](const Unit& u) { return u.name == word; });
  return unit == std::end(kUnits) ? nullptr : unit;
}

bool isPi(std::string_view word) {
  return word == "pi" || word == "\u03c0";
}

std::string lowerCase(std::string_view word) {
  std::string lower(word);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

class Evaluation {
 public:
  Evaluation(std::string_view text, const ExpressionField& field) : m_field(field), m_scanner(text) {}

  std::optional<Value> whole() {
    if (m_scanner.sign() == '\0' && m_scanner.atEnd()) return fail(Kind::Empty, 0);
    std::optional<Value> value = sum();
    if (!value) return {};
    m_scanner.skipBlanks();
    if (!m_scanner.atEnd()) return failHere(Kind::OperatorMissing);
    if (value->isBare()) value = product(*value, unitOf(m_field), 0);
    if (value && !value->isLike(unitOf(m_field))) return fail(Kind::WrongQuantity, 0);
    return value;
  }

  const ExpressionError& error() const { return m_error; }

 private:
  std::optional<Value> sum() {
    std::optional<Value> left = term();
    while (left) {
      const char op = m_scanner.sign();
      const std::size_t at = m_scanner.at();
      if (op != '+' && op != '-') break;
      m_scanner.skipSign();
      std::optional<Value> right = term();
      if (right && op == '-') right->number = -right->number;
      left = right ? total(*left, *right, at) : right;
    }
    return left;
  }

  std::optional<Value> total(Value a, Value b, std::size_t at) {
    for (Value* side : {&a, &b}) {
      if (a.isLike(b) || !side->isBare()) continue;
      const std::optional<Value> inFieldUnit = product(*side, unitOf(m_field), at);
      if (!inFieldUnit) return {};
      *side = *inFieldUnit;
    }
    if (!a.isLike(b)) return fail(Kind::UnlikeTerms, at);
    return finite({a.number + b.number, a.length, a.angle}, at);
  }

  std::optional<Value> term() {
    std::optional<Value> result = factor();
    if (result) result = withUnit(*result);
    while (result) {
      const char op = m_scanner.sign();
      const std::size_t at = m_scanner.at();
      if (op != '*' && op != '/') break;
      m_scanner.skipSign();
      m_scanner.skipBlanks();
      const std::size_t start = m_scanner.at();
      std::optional<Value> right = factor();
      const bool unitOfAll = right && right->isBare() && result->isBare();
      if (right && !unitOfAll) right = withUnit(*right);
      if (!right) return {};
      if (op == '/' && right->number == 0.0) return fail(Kind::DivisionByZero, start);
      result = op == '*' ? product(*result, *right, at) : quotient(*result, *right, at);
      if (result && unitOfAll) result = withUnit(*result);
    }
    return result;
  }

  // Parses signs and a number, a constant or an expression in brackets.
  std::optional<Value> factor() {
    bool negative = false;
    char c = m_scanner.sign();
    for (; c == '+' || c == '-'; c = m_scanner.sign()) {
      negative ^= c == '-';
      m_scanner.skipSign();
    }
    const bool digits = (c >= '0' && c <= '9') || c == '.' || c == ',';
    std::optional<Value> value = c == '(' ? inBrackets() : digits ? number() : constant();
    if (value && negative) value->number = -value->number;
    return value;
  }

  std::optional<Value> inBrackets() {
    if (m_depth == kDeepestExpression) return fail(Kind::TooDeep, m_scanner.at());
    ++m_depth;
    m_scanner.skip(1);
    std::optional<Value> value = sum();
    --m_depth;
    if (!value) return {};
    if (m_scanner.sign() != ')') return failHere(Kind::BracketMissing);
    m_scanner.skip(1);
    return value;
  }

  std::optional<Value> number() {
    const std::size_t start = m_scanner.at();
    const ExpressionScanner::Number number = m_scanner.number();
    if (!number.wellFormed) return fail(Kind::NumberMalformed, start, number.word);
    if (number.perhapsThousands && !m_field.decimalComma) return fail(Kind::CommaAmbiguous, start, number.word);
    std::string digits(number.word);
    std::replace(digits.begin(), digits.end(), ',', '.');
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    // The text is too short for a mantissa beyond the range of a double: the exponent's sign says which end was passed.
    if (error == std::errc::result_out_of_range && digits.find('-') != std::string::npos) return Value{};
    if (error != std::errc()) return fail(Kind::TooLarge, start);
    return Value{value};
  }

  std::optional<Value> constant() {
    const std::string word = lowerCase(m_scanner.peekWord());
    if (!isPi(word)) return failHere(word.empty() || unitNamed(word) ? Kind::NumberMissing : Kind::NameUnknown);
    m_scanner.skip(word.size());
    return Value{std::numbers::pi};
  }

  // Returns the value times the unit that follows, if there is one.
  std::optional<Value> withUnit(const Value& value) {
    m_scanner.skipBlanks();
    const std::string word = lowerCase(m_scanner.peekWord());
    if (word.empty()) return value;
    const Unit* unit = unitNamed(word);
    if (!unit) return failHere(isPi(word) ? Kind::OperatorMissing : Kind::NameUnknown);
    const std::size_t at = m_scanner.at();
    m_scanner.skip(word.size());
    return product(value, unit->value, at);
  }

  std::optional<Value> product(const Value& a, const Value& b, std::size_t at) {
    return finite({a.number * b.number, a.length + b.length, a.angle + b.angle}, at);
  }

  std::optional<Value> quotient(const Value& a, const Value& b, std::size_t at) {
    return finite({a.number / b.number, a.length - b.length, a.angle - b.angle}, at);
  }

  std::optional<Value> finite(const Value& value, std::size_t at) {
    if (!std::isfinite(value.number)) return fail(Kind::TooLarge, at);
    return value;
  }

  std::nullopt_t fail(Kind kind, std::size_t at, std::string_view found = {}) {
    m_error = {kind, m_scanner.column(at), std::string(found)};
    return std::nullopt;
  }

  std::nullopt_t failHere(Kind kind) { return fail(kind, m_scanner.at(), m_scanner.peekToken()); }

  const ExpressionField& m_field;
  ExpressionScanner m_scanner;
  int m_depth = 0;
  ExpressionError m_error;
};

}  // namespace

ExpressionResult evaluateExpression(std::string_view text, const ExpressionField& field) {
  if (text.size() > kLongestExpression) return ExpressionError{Kind::TooLong, kLongestExpression + 1, {}};
  Evaluation evaluation(text, field);
  const std::optional<Value> value = evaluation.whole();
  if (!value) return evaluation.error();
  return value->number + 0.0;  // no negative zero
}

}  // namespace handwheel
