// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

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

// Whether c is an ASCII digit, whatever the locale.
inline bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

inline std::string_view withoutPlus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace handwheel
