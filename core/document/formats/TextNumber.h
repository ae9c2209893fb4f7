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

// A decimal number in the C locale, whatever locale the process has; a leading plus is allowed. Numbers too small for a
// double are zero. False, with the reason, for anything else: NumberMalformed, NumberNotFinite (also when too large).
bool parseNumber(std::string_view word, double& value, ErrorCode& why);

// A whole number; also one written like "3.0". Nothing when it is not one or does not fit.
std::optional<std::int64_t> parseInteger(std::string_view word);

// Reads the next three words, of this line or of any, as a point rounded to the number type. False, with the error,
// otherwise.
enum class Words { OfThisLine, OfAnyLine };
bool readPoint(TextScanner& scanner, NumberType type, Vec3& point, Error& error, Words words = Words::OfThisLine);

// An error about a word; a long word is cut.
Error wordError(ErrorCode code, std::string_view word, Place place);
Error unexpectedWord(std::string_view expected, std::string_view found, Place place);

// ASCII letters only, so that the locale has no say.
bool equalsIgnoringCase(std::string_view word, std::string_view lowerCase);

}  // namespace handwheel
