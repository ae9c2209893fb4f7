// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Result.h"

#include <span>
#include <string_view>

namespace handwheel {

// The next word of a text, words being divided by blanks and line ends; removes it from the text. Empty at the end.
std::string_view takeWord(std::string_view& text);

// As parseDecimal() reads it. Errors: NumberMalformed, NumberNotFinite (out of the range of a double).
Result<double> parseNumber(std::string_view word);

// Exactly as many finite numbers as there is room. Errors: NumberMalformed, NumberNotFinite, CountMismatch.
Status parseNumbers(std::string_view text, std::span<double> numbers);

}  // namespace handwheel
