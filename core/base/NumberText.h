// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

// Parses a decimal number in the C locale, whatever locale the process has. A leading plus is allowed. Numbers too
// small for a double are zero. "inf" and "nan" are accepted, too; the caller decides. Returns false, with the reason,
// for anything else: NumberMalformed, NumberNotFinite (too large for a double).
bool parseDecimal(std::string_view word, double& value, ErrorCode& why);

// Formats a number with the fewest digits that read back the same. In the C locale.
std::string shortestText(double value);
// Formats a number with at most the given number of digits, for display. Zero has no sign. In the C locale.
std::string roundedText(double value, int digits = 6);

// Rounds a number to at most this many digits (from 1 on), ties away from zero. Makes proposed and estimated values
// easy to read. Zero and non-finite numbers stay as they are.
double roundedNumber(double value, int digits);

// Largest relative deviation of a displayed number from its value.
inline constexpr double kShownPrecision = 1e-6;
// Formats a finite number with the fewest digits that are within kShownPrecision of it, for display. Very large and
// very small ones have an exponent; zero has no sign. In the C locale.
std::string shownText(double value);
// Returns the value if it is within the limits as shownText() shows them. A value beyond a limit by no more than
// kShownPrecision becomes that limit. Nothing for other values, and those that are not finite.
std::optional<double> withinShownLimits(double value, double least, double largest);

// Returns true if c is an ASCII digit, in any locale.
inline bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
// Returns true if c is an ASCII letter, in any locale.
inline bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

inline std::string_view withoutPlus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace handwheel
