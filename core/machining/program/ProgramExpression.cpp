// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramExpression.h"

#include "base/Units.h"

#include <cmath>
#include <cstdint>

namespace handwheel {

namespace {

constexpr double kEqual = 1e-4;  // LinuxCNC's TOLERANCE_EQUAL

struct Operator {
  const char* text;
  int strength, fanuc;  // in LinuxCNC and in Fanuc; 0: not available
  int strengthIn(ProgramDialect dialect) const { return dialect == ProgramDialect::Fanuc ? fanuc : strength; }
};

// The longest operators come first.
constexpr Operator kOperators[] = {{"**", 5, 0}, {"MOD", 4, 4}, {"AND", 1, 4}, {"XOR", 1, 3}, {"EQ", 2, 2},
                                   {"NE", 2, 2}, {"GT", 2, 2},  {"GE", 2, 2},  {"LT", 2, 2},  {"LE", 2, 2},
                                   {"OR", 1, 3}, {"*", 4, 4},   {"/", 4, 4},   {"+", 3, 3},   {"-", 3, 3}};

// Fanuc's AND, OR and XOR of the bits of two whole numbers. Returns NaN for others.
double bitsOf(const std::string& op, double a, double b) {
  constexpr double kMost = 2147483647.0;  // 32 bits with a sign
  if (!(std::abs(a) <= kMost && std::abs(b) <= kMost)) return std::nan("");
  const auto x = static_cast<std::int32_t>(std::lround(a)), y = static_cast<std::int32_t>(std::lround(b));
  return op == "AND" ? x & y : op == "OR" ? x | y : x ^ y;
}

constexpr const char* kFunctions[] = {"ABS", "ACOS", "ASIN", "ATAN",  "COS", "EXISTS", "EXP",
                                      "FIX", "FUP",  "LN",   "ROUND", "SIN", "SQRT",   "TAN"};

bool isSame(const ProgramValue& a, const ProgramValue& b, ProgramDialect dialect) {
  if (dialect == ProgramDialect::LinuxCnc) return std::abs(a.number - b.number) < kEqual;
  return a.isVacant == b.isVacant && a.number == b.number;
}

double moduloOf(double a, double b) {
  const double rest = std::fmod(a, b);  // in LinuxCNC never negative
  return rest < 0.0 ? rest + std::abs(b) : rest;
}

double apply(const std::string& op, const ProgramValue& left, const ProgramValue& right, ProgramDialect dialect) {
  const double a = left.number, b = right.number;
  if (op == "**") return std::pow(a, b);
  if (op == "*") return a * b;
  if (op == "/") return a / b;
  if (op == "+") return a + b;
  if (op == "-") return a - b;
  if (op == "MOD") return dialect == ProgramDialect::Fanuc ? std::fmod(a, b) : moduloOf(a, b);
  if (op == "EQ") return isSame(left, right, dialect) ? 1.0 : 0.0;
  if (op == "NE") return isSame(left, right, dialect) ? 0.0 : 1.0;
  if (op == "GT") return a > b ? 1.0 : 0.0;
  if (op == "GE") return a >= b ? 1.0 : 0.0;
  if (op == "LT") return a < b ? 1.0 : 0.0;
  if (op == "LE") return a <= b ? 1.0 : 0.0;
  if (dialect == ProgramDialect::Fanuc) return bitsOf(op, a, b);
  if (op == "AND") return a != 0.0 && b != 0.0 ? 1.0 : 0.0;
  if (op == "OR") return a != 0.0 || b != 0.0 ? 1.0 : 0.0;
  return (a != 0.0) != (b != 0.0) ? 1.0 : 0.0;  // XOR
}

double functionOf(const std::string& name, double x, bool isFanuc) {
  if (name == "ABS") return std::abs(x);
  if (name == "ACOS") return std::acos(x) / kRadiansPerDegree;
  if (name == "ASIN") return std::asin(x) / kRadiansPerDegree;
  if (name == "COS") return std::cos(x * kRadiansPerDegree);
  if (name == "EXP") return std::exp(x);
  if (name == "FIX") return isFanuc ? std::trunc(x) : std::floor(x);
  if (name == "FUP") return !isFanuc || x > 0.0 ? std::ceil(x) : std::floor(x);
  if (name == "LN") return std::log(x);
  if (name == "ROUND") return std::round(x);
  if (name == "SIN") return std::sin(x * kRadiansPerDegree);
  if (name == "SQRT") return std::sqrt(x);
  return std::tan(x * kRadiansPerDegree);
}

}  // namespace

void ProgramExpression::enter() {
  if (++m_depth > kDeepest)
    refuse(m_scanner.location(), m_scanner.token(), "the expression is nested too deeply",
           "Divide it over several variables.");
}

double ProgramExpression::finite(double value, const SourceLocation& location, const std::string& what) const {
  if (!std::isfinite(value))
    refuse(location, what, "this has no value",
           "Check for a division by zero, a root or logarithm of a negative number.");
  return value;
}

ProgramValue ProgramExpression::value() {
  enter();
  ProgramValue result;
  const char next = m_scanner.peek();
  if (next == '[') {
    result.number = bracketed();
  } else if (next == '#') {
    m_scanner.take();
    result = variable();
  } else if (next == '+' || next == '-') {
    m_scanner.take();
    result = value();
    if (next == '-') result.number = -result.number;
  } else if (m_scanner.nextIsNumber()) {
    result.number = m_scanner.number();
  } else {
    const SourceLocation location = m_scanner.location();
    const std::string token = m_scanner.token();
    for (const char* const name : kFunctions) {
      if (!m_scanner.takeIf(std::string_view(name))) continue;
      result.number = function(name, location);
      --m_depth;
      return result;
    }
    refuse(location, token.empty() ? "end of the line" : token, "a value is expected here",
           "Write a number, a variable such as #1, or an expression in square brackets.");
  }
  --m_depth;
  return result;
}

double ProgramExpression::bracketed() {
  const SourceLocation location = m_scanner.location();
  m_scanner.expect('[', "Write the value in square brackets.");
  const double result = binary(0).number;
  m_scanner.expect(']', "Close the square bracket.");
  return finite(result, location, "[");
}

double ProgramExpression::function(const std::string& name, const SourceLocation& location) {
  if (name == "EXISTS") {
    m_scanner.expect('[', "Write EXISTS[#<name>].");
    m_scanner.expect('#', "Write EXISTS[#<name>].");
    const bool exists = m_scanner.peek() == '<' ? m_variables.get(m_scanner.name()).has_value()
                                                : !m_variables.get(variableNumber(), location).isVacant;
    m_scanner.expect(']', "Close the square bracket.");
    return exists ? 1.0 : 0.0;
  }
  const double x = bracketed();
  if (name != "ATAN") return finite(functionOf(name, x, m_dialect == ProgramDialect::Fanuc), location, name);
  m_scanner.expect('/', "Write ATAN[y]/[x].");
  return std::atan2(x, bracketed()) / kRadiansPerDegree;
}

int ProgramExpression::variableNumber() {
  const SourceLocation location = m_scanner.location();
  const double number = value().number;
  const double whole = std::round(number);
  const bool isZero = whole == 0.0 && m_dialect == ProgramDialect::Fanuc;
  if (std::abs(number - whole) > kEqual || (whole < 1.0 && !isZero) || whole > ProgramVariables::kLargest)
    refuse(location, "#",
           "the number of a variable is a whole number from 1 to " + std::to_string(ProgramVariables::kLargest),
           "Use another number.");
  return static_cast<int>(whole);
}

ProgramValue ProgramExpression::variable() {
  const SourceLocation location = m_scanner.location();
  if (m_scanner.peek() != '<') {
    const int number = variableNumber();
    return number == 0 ? ProgramValue{0.0, true} : m_variables.get(number, location);
  }
  const std::string name = m_scanner.name();
  const std::optional<double> found = m_variables.get(name);
  if (!found)
    refuse(location, "#<" + name + ">", "this variable has no value here",
           "Set it before, or begin its name with an underscore to share it between subprograms.");
  return {*found, false};
}

ProgramValue ProgramExpression::binary(int least) {
  enter();
  ProgramValue left = value();
  for (;;) {
    const Operator* found = nullptr;
    const SourceLocation location = m_scanner.location();
    const std::size_t before = m_scanner.at();
    for (const Operator& op : kOperators) {
      if (op.strengthIn(m_dialect) == 0 || !m_scanner.takeIf(std::string_view(op.text))) continue;
      found = &op;
      break;
    }
    if (!found || found->strengthIn(m_dialect) < least) {
      m_scanner.seek(before);
      break;
    }
    const ProgramValue right = binary(found->strengthIn(m_dialect) + 1);
    left = {finite(apply(found->text, left, right, m_dialect), location, found->text), false};
  }
  --m_depth;
  return left;
}

}  // namespace handwheel
