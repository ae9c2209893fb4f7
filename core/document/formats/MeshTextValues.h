// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "base/Geometry.h"
#include "document/formats/TextScanner.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace handwheel {

// Parses a finite number of a mesh file in text. Uses the C locale, independently of the process. A leading plus is
// allowed. Numbers too small for a double become zero. Returns false for anything else, and sets `why` to
// NumberMalformed or NumberNotFinite (also for numbers too large for a double).
bool parseNumber(std::string_view word, double& value, ErrorCode& why);

// Parses an integer, which may be written like "3.0". Returns nothing if the word is no integer or the value does not
// fit.
std::optional<std::int64_t> parseInteger(std::string_view word);

// The words that readPoint() reads: of the present line only, or also of the following lines.
enum class Words { OfThisLine, OfAnyLine };
// Reads the next three words as a point and rounds it to the number type. Returns false and sets the error if they are
// no point.
bool readPoint(TextScanner& scanner, NumberType type, Vec3& point, Error& error, Words words = Words::OfThisLine);

// Creates an error about a word, which is truncated if it is long.
Error wordError(ErrorCode code, std::string_view word, InputPosition position);
Error unexpectedWord(std::string_view expected, std::string_view found, InputPosition position);

// Returns true if two words are equal when the case of ASCII letters is ignored. lowerCase: a word in lower case.
bool equalsIgnoringCase(std::string_view word, std::string_view lowerCase);

}  // namespace handwheel
