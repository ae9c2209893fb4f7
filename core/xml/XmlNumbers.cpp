// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "xml/XmlNumbers.h"

#include "base/NumberText.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace handwheel {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

Error about(ErrorCode code, std::string_view word) {
  constexpr std::size_t kShown = 40;
  return {code, {std::string(word.substr(0, kShown))}, {}, {}};
}

}  // namespace

std::string_view takeWord(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
  text.remove_prefix(word.size());
  return word;
}

Result<double> parseNumber(std::string_view word) {
  double value = 0.0;
  ErrorCode why = ErrorCode::NumberMalformed;
  if (!parseDecimal(word, value, why)) return about(why, word);
  return value;
}

Status parseNumbers(std::string_view text, std::span<double> numbers) {
  std::size_t found = 0;
  for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text), ++found) {
    const Result<double> number = parseNumber(word);
    if (!number) return number.error();
    if (!std::isfinite(*number)) return about(ErrorCode::NumberNotFinite, word);
    if (found < numbers.size()) numbers[found] = *number;
  }
  if (found == numbers.size()) return Done{};
  return Error{ErrorCode::CountMismatch, {"numbers", std::to_string(numbers.size()), std::to_string(found)}, {}, {}};
}

}  // namespace handwheel
