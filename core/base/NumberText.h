// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <string>
#include <string_view>

namespace handwheel {

// A decimal number in the C locale, whatever locale the process has; a leading plus is allowed. Numbers too small for a
// double are zero. "inf" and "nan" are read, too: who calls decides. False, with the reason, for anything else:
// NumberMalformed, NumberNotFinite (too large for a double).
bool parseDecimal(std::string_view word, double& value, ErrorCode& why);

// The fewest digits that read back as the same number, in the C locale.
std::string shortestText(double value);
// With so many digits at most, for people; without a sign for zero. In the C locale.
std::string roundedText(double value, int digits = 6);

// Of ASCII, whatever the locale.
inline bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

inline std::string_view withoutPlus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace handwheel
