// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/MeshTextValues.h"

#include "base/NumberText.h"
#include "document/formats/MeshFileErrors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace handwheel {

namespace {

// Recognises "1.#INF", "-1.#IND", "1.#QNAN", which Microsoft's C library used to print.
bool isMicrosoftNotFinite(std::string_view word) {
  if (!word.empty() && word[0] == '-') word.remove_prefix(1);
  return word.starts_with("1.#");
}

}  // namespace

bool parseNumber(std::string_view word, double& value, ErrorCode& why) {
  if (!parseDecimal(word, value, why)) {
    if (isMicrosoftNotFinite(withoutPlus(word))) why = ErrorCode::NumberNotFinite;
    return false;
  }
  why = ErrorCode::NumberNotFinite;
  return std::isfinite(value);
}

std::optional<std::int64_t> parseInteger(std::string_view word) {
  const std::string_view digits = withoutPlus(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc() && end == digits.data() + digits.size()) return value;
  double real = 0.0;
  ErrorCode why;
  if (error != std::errc() || !parseNumber(word, real, why)) return {};
  constexpr double kExact = 9007199254740992.0;  // 2^53: beyond, a double skips whole numbers
  if (std::abs(real) > kExact || real != std::trunc(real)) return {};
  return static_cast<std::int64_t>(real);
}

bool readPoint(TextScanner& scanner, NumberType type, Vec3& point, Error& error, Words words) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = words == Words::OfAnyLine ? scanner.wordOnAnyLine() : scanner.word();
    double value = 0.0;
    ErrorCode why = ErrorCode::NumberNotFinite;
    const bool good = !word.empty() && parseNumber(word, value, why);
    point[axis] = rounded(value, type);
    if (good && std::isfinite(point[axis])) continue;
    error = word.empty() ? unexpectedWord("a number", word, scanner.inputPosition())
                         : wordError(why, word, scanner.inputPosition());
    return false;
  }
  return true;
}

Error wordError(ErrorCode code, std::string_view word, InputPosition position) {
  constexpr std::size_t kShown = 40;
  return {code, {std::string(word.substr(0, kShown))}, position, {}};
}

Error unexpectedWord(std::string_view expected, std::string_view found, InputPosition position) {
  Error error = wordError(MeshFileError::TokenUnexpected, found, position);
  error.arguments.insert(error.arguments.begin(), std::string(expected));
  return error;
}

bool equalsIgnoringCase(std::string_view word, std::string_view lowerCase) {
  return std::equal(word.begin(), word.end(), lowerCase.begin(), lowerCase.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

}  // namespace handwheel
