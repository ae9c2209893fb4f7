// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <optional>
#include <string_view>
#include <vector>

// Pieces of the headers of images, which are lines of text.
namespace handwheel::imageHeader {

// Takes the next line off a text, without its end (LF or CR LF).
std::string_view takeLine(std::string_view& text);
std::string_view trimmed(std::string_view text);
// The words between blanks, at most a hundred.
std::vector<std::string_view> wordsOf(std::string_view text);
// The numbers between blanks; none where a word is no finite number, or there are not so many.
std::optional<std::vector<double>> numbersOf(std::string_view text, std::size_t count);
// A whole number from 0 to 2^53; none where it is not.
std::optional<std::size_t> countOf(std::string_view word);
// Small letters of ASCII.
std::string lowered(std::string_view text);

// ElementMalformed, of a field.
Error malformed(std::string_view field, const char* why);

}  // namespace handwheel::imageHeader
