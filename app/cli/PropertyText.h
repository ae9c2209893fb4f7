// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Property.h"

#include <string>

namespace handwheel {

// The value as the command line shows and takes it: "50 mm", "-30 deg", "yes", "cm".
std::string propertyText(const Property& property);

// The value that a word stands for: a number with or without a unit or an expression, yes or no, one of the choices, a
// text. Or what is wrong with the word, as a sentence.
std::variant<PropertyValue, std::string> propertyValue(const Property& property, const std::string& word);

}  // namespace handwheel
