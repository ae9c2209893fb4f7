// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Result.h"

#include <span>
#include <string_view>

namespace handwheel {

// Removes and returns the next word of a text. Words are separated by blanks and line ends. Empty at the end.
std::string_view takeWord(std::string_view& text);

// Parses a number as parseDecimal() does. Errors: NumberMalformed, NumberNotFinite (out of the range of a double).
Result<double> parseNumber(std::string_view word);

// Parses exactly as many finite numbers as the span has room for. Errors: NumberMalformed, NumberNotFinite,
// CountMismatch.
Status parseNumbers(std::string_view text, std::span<double> numbers);

}  // namespace handwheel
