// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <optional>
#include <string_view>
#include <vector>

// Helpers for image headers that consist of lines of text.
namespace handwheel::imageHeader {

// Removes and returns the next line of a text, without its end (LF or CR LF).
std::string_view takeLine(std::string_view& text);
std::string_view trimmed(std::string_view text);
// Returns the words between blanks, at most a hundred.
std::vector<std::string_view> wordsOf(std::string_view text);
// Returns the numbers between blanks; none if a word is not a finite number, or if there are not exactly `count`.
std::optional<std::vector<double>> numbersOf(std::string_view text, std::size_t count);
// Returns an integer from 0 to 2^53; none if the word is not one.
std::optional<std::size_t> countOf(std::string_view word);
// Returns the text with ASCII letters in lower case.
std::string lowered(std::string_view text);

// Returns ElementMalformed for a field.
Error malformed(std::string_view field, const char* why);

}  // namespace handwheel::imageHeader
