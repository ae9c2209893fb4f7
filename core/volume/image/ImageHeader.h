// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <optional>
#include <string_view>
#include <vector>

// Helpers for image headers that consist of lines of text.
namespace handwheel::imageHeader {

// Removes the next line from a text and returns it, without its end (LF or CR LF).
std::string_view takeLine(std::string_view& text);
std::string_view trimmed(std::string_view text);
// Returns the words of a text that blanks separate, at most a hundred.
std::vector<std::string_view> wordsOf(std::string_view text);
// Returns `count` numbers that blanks separate. Returns nothing if a word is not a finite number, or if the count
// differs.
std::optional<std::vector<double>> numbersOf(std::string_view text, std::size_t count);
// Returns an integer from 0 to 2^53, or nothing if the word is not one.
std::optional<std::size_t> countOf(std::string_view word);
// Returns the text with ASCII letters in lower case.
std::string lowered(std::string_view text);

// Returns the error ElementMalformed for a field of a header.
Error malformed(std::string_view field, const char* why);

}  // namespace handwheel::imageHeader
