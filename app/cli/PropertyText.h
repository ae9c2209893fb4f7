// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Property.h"

#include <string>

namespace handwheel {

// Formats a property value for the command line. Examples: "50 mm", "-30 deg", "196350 mm³", "yes", "cm".
std::string propertyText(const Property& property);

// Formats the limits of a number: "-170 deg to 170 deg".
std::string limitsText(const Property& property);

// Parses a property value from the command line. Accepts a number or an expression, with or without a unit, yes or no,
// one of the choices, or a text, depending on the property. A limit that is rounded for display is accepted as it is
// shown. Returns the value, or the error as a sentence.
std::variant<PropertyValue, std::string> propertyValue(const Property& property, const std::string& word);

}  // namespace handwheel
