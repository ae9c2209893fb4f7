// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"

#include <utility>

// Conversion of the values of operations to and from words, and syntax for help pages. Words are the same on the
// command line and in steps. All text is in English and independent of the locale. Lengths are in mm, angles in
// degrees; numbers have the fewest digits that read back to the same value.
namespace handwheel {

// Formats an angle in degrees if the text reads back to the same angle, otherwise in radians: "0.5rad".
std::string angleText(double radian);

// Splits a list at a separator. An empty list has one empty part.
std::vector<std::string_view> parted(std::string_view list, char separator);

// Returns the word for a value, which need not be within the range. The word for a flag is empty.
std::string textOf(const Parameter& parameter, const PropertyValue& value);
// Parses a word and sets the parameter. Returns an empty text, or the error as a clause; after an error nothing has
// changed.
[[nodiscard]] std::string readWord(OperationValues& values, const Parameter& parameter, std::string_view word);

// Formats the numbers of a list parameter as its text. numbersIn() parses such a text, and returns nothing if it is
// malformed.
std::string listText(const Parameter& parameter, const std::vector<double>& numbers);
std::optional<std::vector<double>> numbersIn(const Parameter& parameter, std::string_view list);

// Returns the names and words of the values that differ from their defaults, and of those that are always written.
std::vector<std::pair<std::string, std::string>> writtenOptions(const OperationValues& values);
// Returns writtenOptions() as a line: "--faces 700 --keep-borders".
std::string optionLine(const OperationValues& values);

// Returns the error for a word that is not accepted: "--open-sheets takes keep, back or fill, not 'off'".
std::string refusal(const Parameter& parameter, std::string_view word);

// Returns words as a list: "fair, ridge or ear".
std::string choicesText(const std::vector<std::string>& words);

// Returns the syntax of a step: "repair [--open-sheets HOW] [--max-hole N] [FILL]".
std::string syntaxOf(const Operation& operation);
// Returns the meaning of a parameter with its choices, range and default.
std::string helpOf(const Parameter& parameter);

}  // namespace handwheel
