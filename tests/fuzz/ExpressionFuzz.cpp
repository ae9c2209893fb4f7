// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/Expression.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is the text; its length
// chooses the field.

namespace {

using namespace handwheel;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "ExpressionFuzz: %s\n", what);
  std::abort();
}

// Brackets around the whole change nothing, unless they make it too long or too deep.
void putInBrackets(std::string_view text, const ExpressionField& field, double value) {
  const ExpressionResult result = evaluateExpression('(' + std::string(text) + ')', field);
  if (const auto* error = std::get_if<ExpressionError>(&result)) {
    require(error->kind == ExpressionError::Kind::TooLong || error->kind == ExpressionError::Kind::TooDeep,
            "refused in brackets");
  } else {
    require(std::get<double>(result) == value, "another value in brackets");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr Quantity kQuantities[] = {Quantity::Number, Quantity::Length, Quantity::Angle};
  constexpr LengthUnit kUnits[] = {LengthUnit::Millimetre, LengthUnit::Inch};
  const ExpressionField field{kQuantities[size % 3], kUnits[size / 3 % 2], size / 6 % 2 == 1};
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const ExpressionResult result = evaluateExpression(text, field);
  if (const auto* error = std::get_if<ExpressionError>(&result)) {
    require(error->column >= 1 && error->column <= size + 1, "an error outside the text");
    require(error->found.size() <= size, "more found than there is");
    return 0;
  }
  require(std::isfinite(std::get<double>(result)), "a number that is not finite");
  putInBrackets(text, field, std::get<double>(result));
  return 0;
}
