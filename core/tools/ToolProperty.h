// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Property.h"

#include <algorithm>

// Functions to create the properties of tool settings, and to assign values to the settings.
namespace handwheel {

// A closed range of numbers.
struct Limits {
  double least, largest;
  double bring(double value) const { return std::clamp(value, least, largest); }
};

// Create the property of a number, a choice or a switch. Labels and choices: English texts, translated in the context
// "Property".
Property numberSetting(const char* id, const char* label, double value, Quantity quantity, const Limits& limits);
Property choiceSetting(const char* id, const char* label, int chosen, std::vector<std::string> choices);
Property switchSetting(const char* id, const char* label, bool value);
// Creates a read-only length (mm) that is read while the hand moves: it is rounded to a hundredth.
Property shownLength(const char* id, const char* label, double value);

// Assign a property value to a number or a switch. They return false and change nothing if the value is of another type
// or NaN; numbers are clamped to the limits.
bool assignNumber(double& number, const PropertyValue& value, const Limits& limits);
bool assignSwitch(bool& on, const PropertyValue& value);

// Assigns a property value to a choice. count: number of choices. Returns false and changes nothing if the value is not
// the index of a choice.
template <class Choice>
bool assignChoice(Choice& choice, const PropertyValue& value, int count) {
  const double* index = std::get_if<double>(&value);
  if (!index || !(*index >= 0.0 && *index < count)) return false;
  choice = static_cast<Choice>(static_cast<int>(*index));
  return true;
}

}  // namespace handwheel
