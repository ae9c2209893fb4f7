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
// allowed. Numbers too small for a double are zero. Returns false, with the reason, for anything else: NumberMalformed,
// NumberNotFinite (also if too large).
bool parseNumber(std::string_view word, double& value, ErrorCode& why);

// Parses an integer, also one written like "3.0". Returns none if it is no integer or does not fit.
std::optional<std::int64_t> parseInteger(std::string_view word);

// Reads the next three words as a point rounded to the number type. The words are of this line or of any. Returns
// false, with the error, if they are no point.
enum class Words { OfThisLine, OfAnyLine };
bool readPoint(TextScanner& scanner, NumberType type, Vec3& point, Error& error, Words words = Words::OfThisLine);

// Creates an error about a word; a long word is truncated.
Error wordError(ErrorCode code, std::string_view word, InputPosition position);
Error unexpectedWord(std::string_view expected, std::string_view found, InputPosition position);

// Compares words ignoring case. ASCII letters only, independent of the locale.
bool equalsIgnoringCase(std::string_view word, std::string_view lowerCase);

}  // namespace handwheel
