// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

// Parses a decimal number in the C locale, regardless of the locale of the process. A leading plus is allowed. Numbers
// too small for a double become zero. "inf" and "nan" are accepted, too; the caller decides about them. For any other
// text, returns false and sets the reason: NumberMalformed, or NumberNotFinite (too large for a double).
bool parseDecimal(std::string_view word, double& value, ErrorCode& why);

// Formats a number with the fewest digits from which it can be restored, in the C locale.
std::string shortestText(double value);
// Formats a number with at most the given number of digits, for display, in the C locale. Zero has no sign.
std::string roundedText(double value, int digits = 6);

// Rounds a number to at most this number of digits (from 1 on), ties away from zero. Proposed and estimated values
// become easy to read. Zero and numbers that are not finite stay unchanged.
double roundedNumber(double value, int digits);

// Largest relative deviation of a displayed number from its value.
inline constexpr double kShownPrecision = 1e-6;
// Formats a finite number with the fewest digits that are within kShownPrecision of it, for display, in the C locale.
// Very large and very small numbers have an exponent. Zero has no sign.
std::string shownText(double value);
// Returns the value if it is within the limits as shownText() displays them. A value that exceeds a limit by at most
// kShownPrecision becomes that limit. Returns nothing for other values, and for values that are not finite.
std::optional<double> withinShownLimits(double value, double least, double largest);

// Returns true if c is an ASCII digit, regardless of the locale.
inline bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
// Returns true if c is an ASCII letter, regardless of the locale.
inline bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

inline std::string_view withoutPlus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace handwheel
