// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Property.h"

#include <algorithm>

// What the settings of tools are made of, and how values that were given for them are taken over.
namespace handwheel {

struct Limits {
  double least, largest;
  double bring(double value) const { return std::clamp(value, least, largest); }
};

// Labels and choices: English, context "Property".
Property numberSetting(const char* id, const char* label, double value, Quantity quantity, const Limits& limits);
Property choiceSetting(const char* id, const char* label, int chosen, std::vector<std::string> choices);
Property switchSetting(const char* id, const char* label, bool value);

// False, and nothing changed, where the value is of another kind or no number; numbers are brought between the limits.
bool takeNumber(double& number, const PropertyValue& value, const Limits& limits);
bool takeSwitch(bool& on, const PropertyValue& value);

// The number of a choice among so many.
template <class Choice>
bool takeChoice(Choice& choice, const PropertyValue& value, int count) {
  const double* index = std::get_if<double>(&value);
  if (!index || !(*index >= 0.0 && *index < count)) return false;
  choice = static_cast<Choice>(static_cast<int>(*index));
  return true;
}

}  // namespace handwheel
