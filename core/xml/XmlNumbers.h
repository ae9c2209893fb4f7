// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Result.h"

#include <span>
#include <string_view>

namespace handwheel {

// Removes the next word from a text and returns it. Words are separated by blanks and line ends. The result is empty at
// the end of the text.
std::string_view takeWord(std::string_view& text);

// Parses a number like parseDecimal(). Errors: NumberMalformed, NumberNotFinite (outside the range of a double).
Result<double> parseNumber(std::string_view word);

// Parses a text with as many finite numbers as the span has elements. Errors: NumberMalformed, NumberNotFinite,
// CountMismatch.
Status parseNumbers(std::string_view text, std::span<double> numbers);

}  // namespace handwheel
