// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // moc cannot read <numbers>, which Units.h includes, without this before it
#include <string>
#include <string_view>
#include <variant>

#include "base/Units.h"

namespace handwheel {

// The rules by which an input field interprets an expression. They give the meaning of numbers without a unit, and the
// quantity that the result must have.
struct ExpressionField {
  Quantity quantity = Quantity::Number;
  LengthUnit lengthUnit = LengthUnit::Millimetre;  // unit of bare lengths; bare angles are degrees
  bool decimalComma = false;                       // the language writes 1,5; "1,234" is then read as 1.234
};

// The reason why an expression cannot be evaluated, with its position.
struct ExpressionError {
  enum class Kind {
    Empty,
    TooLong,
    TooDeep,
    NumberMissing,    // a number is missing before `found`; empty: at the end
    OperatorMissing,  // an operator is missing before `found`
    BracketMissing,   // a closing bracket before `found`; empty: at the end
    NumberMalformed,  // `found` is not a number
    CommaAmbiguous,   // `found` may have two meanings: "1,234" may be 1.234 or 1234
    NameUnknown,      // there is no unit or constant `found`
    UnlikeTerms,      // a length, an angle and a number cannot be added
    WrongQuantity,    // the result is not the quantity that the field requires
    DivisionByZero,
    TooLarge,  // beyond the range of a double
  };
  Kind kind = Kind::Empty;
  std::size_t column = 1;  // position of the error, from 1, in characters
  std::string found;
};

using ExpressionResult = std::variant<double, ExpressionError>;

inline constexpr std::size_t kLongestExpression = 256;  // bytes
inline constexpr int kDeepestExpression = 32;           // nested brackets

// Evaluates an arithmetic expression with units. Examples are "25.4/2", "1 in + 2mm", "2*(3+4)", "90deg", "pi/2 rad"
// (UTF-8). The result is a finite number in mm or radians or without a unit, according to the quantity of the field. A
// number without a unit gets the unit of the field when it is added to one with a unit, or when it is the result. A
// unit applies to the product before it if that has none yet ("1/2 in" is half an inch), otherwise to the last factor
// ("2mm/4mm" is 0.5). Both decimal signs are accepted, in any locale; a comma that might separate thousands is refused.
// O(length of the text).
ExpressionResult evaluateExpression(std::string_view text, const ExpressionField& field);

}  // namespace handwheel
