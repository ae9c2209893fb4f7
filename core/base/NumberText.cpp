// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/NumberText.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace handwheel {

namespace {

// Returns true if a well-formed number outside the range of double is too large, not too small: the sign of the
// exponent of its first digit other than zero.
bool isHuge(std::string_view word) {
  const std::size_t e = std::min(word.find_first_of("eE"), word.size());
  const std::string_view mantissa = word.substr(0, e);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == std::string_view::npos) return false;
  const auto power = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  std::string_view digits = word.substr(std::min(e + 1, word.size()));
  const bool negative = !digits.empty() && digits[0] == '-';
  if (!digits.empty() && !isDigit(digits[0])) digits.remove_prefix(1);
  std::int64_t exponent = 0;
  for (char c : digits) exponent = std::min<std::int64_t>(exponent * 10 + (c - '0'), std::int64_t{1} << 40);
  return power + (negative ? -exponent : exponent) > 0;
}

}  // namespace

bool parseDecimal(std::string_view word, double& value, ErrorCode& why) {
  const std::string_view digits = withoutPlus(word);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) {
    why = ErrorCode::NumberMalformed;
    return false;
  }
  if (error != std::errc::result_out_of_range) return true;
  value = 0.0;
  why = ErrorCode::NumberNotFinite;
  return !isHuge(digits);
}

std::string shortestText(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

std::string roundedText(double value, int digits) {
  char text[64];
  const double signless = value == 0.0 ? 0.0 : value;
  return {text, std::to_chars(text, text + sizeof text, signless, std::chars_format::general, digits).ptr};
}

double roundedNumber(double value, int digits) {
  if (value == 0.0 || !std::isfinite(value)) return value;
  // Powers of ten are exact while they are whole numbers, so decimals are divided by them.
  const int decimals = digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  const double scale = std::pow(10.0, std::abs(decimals));
  const double rounded = decimals < 0 ? std::round(value / scale) * scale : std::round(value * scale) / scale;
  return std::isfinite(rounded) ? rounded : value;  // at the ends of the range of double
}

std::string shownText(double value) {
  // Limits beyond which an exponent is easier to read than zeros.
  constexpr double kSmallestFixed = 1e-7, kLargestFixed = 1e12;
  const double size = std::abs(value), signless = value == 0.0 ? 0.0 : value;
  const bool isFixed = size == 0.0 || (size >= kSmallestFixed && size < kLargestFixed);
  const auto form = isFixed ? std::chars_format::fixed : std::chars_format::scientific;
  constexpr int kMostDigits = 17;  // behind the point, which is enough for any
  char text[64];
  for (int digits = 0;; ++digits) {
    char* const end = std::to_chars(text, text + sizeof text, signless, form, digits).ptr;
    double read = 0.0;
    std::from_chars(text, end, read, form);
    if (digits == kMostDigits || std::abs(read - value) <= kShownPrecision * size) return {text, end};
  }
}

std::optional<double> withinShownLimits(double value, double least, double largest) {
  const double kept = std::min(std::max(value, least), largest);
  if (!std::isfinite(value) || !(std::abs(value - kept) <= kShownPrecision * std::abs(kept))) return {};
  return kept;
}

}  // namespace handwheel
