// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

// Parses a decimal number in the C locale, whatever locale the process has. A leading plus is allowed. Numbers too
// small for a double are zero. "inf" and "nan" are accepted, too; the caller decides. False, with the reason, for
// anything else: NumberMalformed, NumberNotFinite (too large for a double).
bool parseDecimal(std::string_view word, double& value, ErrorCode& why);

// Formats a number with the fewest digits that read back the same. In the C locale.
std::string shortestText(double value);
// Formats a number with at most the given number of digits, for display. Zero has no sign. In the C locale.
std::string roundedText(double value, int digits = 6);

// The number of at most this many digits (from 1 on) that is nearest, of two as near the one further from zero: so that
// what is proposed or estimated is easily read. Zero and numbers that are not finite stay as they are.
double roundedNumber(double value, int digits);

// How far a number may be from what is shown of it, as a share of it.
inline constexpr double kShownPrecision = 1e-6;
// Formats a finite number with the fewest digits that are within kShownPrecision of it, for display. Very large and
// very small ones have an exponent; zero has no sign. In the C locale.
std::string shownText(double value);
// The value within limits, which are taken as shownText() shows them: what is beyond one by no more than
// kShownPrecision becomes that limit. None for other values, and those that are not finite.
std::optional<double> withinShownLimits(double value, double least, double largest);

// Whether c is an ASCII digit, whatever the locale.
inline bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
// The same of an ASCII letter.
inline bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

inline std::string_view withoutPlus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace handwheel
