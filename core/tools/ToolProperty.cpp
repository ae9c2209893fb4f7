// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/ToolProperty.h"

#include <cmath>
#include <limits>
#include <utility>

namespace handwheel {

Property numberSetting(const char* id, const char* label, double value, Quantity quantity, const Limits& limits) {
  Property property;
  property.id = id;
  property.label = label;
  property.value = value;
  property.quantity = quantity;
  property.least = limits.least;
  property.largest = limits.largest;
  return property;
}

Property choiceSetting(const char* id, const char* label, int chosen, std::vector<std::string> choices) {
  Property property;
  property.id = id;
  property.label = label;
  property.value = static_cast<double>(chosen);
  property.choices = std::move(choices);
  return property;
}

Property switchSetting(const char* id, const char* label, bool value) {
  Property property;
  property.id = id;
  property.label = label;
  property.value = value;
  return property;
}

Property shownLength(const char* id, const char* label, double value) {
  constexpr double kUnlimited = std::numeric_limits<double>::infinity();
  Property property =
      numberSetting(id, label, std::round(100.0 * value) / 100.0, Quantity::Length, {-kUnlimited, kUnlimited});
  property.editable = false;
  return property;
}

bool assignNumber(double& number, const PropertyValue& value, const Limits& limits) {
  const double* given = std::get_if<double>(&value);
  if (!given || std::isnan(*given)) return false;
  number = limits.bring(*given);
  return true;
}

bool assignSwitch(bool& on, const PropertyValue& value) {
  const bool* given = std::get_if<bool>(&value);
  if (given) on = *given;
  return given != nullptr;
}

}  // namespace handwheel
