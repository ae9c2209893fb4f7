// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Expression.h"

#include <cmath>
#include <string>

// Functions that return the result of an expression, for the tests of expressions.
namespace handwheel::test {

// Returns the value of an expression, or NaN if it is in error.
inline double valueOf(const std::string& text, const ExpressionField& field) {
  const ExpressionResult result = evaluateExpression(text, field);
  const double* value = std::get_if<double>(&result);
  return value ? *value : std::nan("");
}

inline ExpressionError errorOf(const std::string& text, const ExpressionField& field) {
  const ExpressionResult result = evaluateExpression(text, field);
  const auto* error = std::get_if<ExpressionError>(&result);
  return error ? *error : ExpressionError{ExpressionError::Kind::Empty, 0, "no error"};
}

inline const ExpressionField kLength{Quantity::Length};
inline const ExpressionField kInches{Quantity::Length, LengthUnit::Inch};
inline const ExpressionField kAngle{Quantity::Angle};
inline const ExpressionField kNumber{};
inline const ExpressionField kGermanLength{Quantity::Length, LengthUnit::Millimetre, true};

}  // namespace handwheel::test
