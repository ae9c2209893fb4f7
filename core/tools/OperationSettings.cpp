// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/OperationSettings.h"

#include "tools/ToolProperty.h"

#include <cassert>
#include <cmath>

namespace handwheel {
namespace {

std::string settingId(std::string id) {
  std::replace(id.begin(), id.end(), '-', '_');
  return id;
}

// A parameter, or one number of a list.
struct Setting {
  const Parameter* parameter = nullptr;
  std::optional<std::size_t> part = std::nullopt;
};

std::optional<Setting> find(const Operation& operation, std::string_view id) {
  for (const Parameter& parameter : operation.parameters) {
    const std::string own = settingId(parameter.id());
    if (parameter.parts.empty() && own == id) return Setting{&parameter};
    for (std::size_t i = 0; i < parameter.parts.size(); ++i)
      if (own + "_" + parameter.parts[i].id == id) return Setting{&parameter, i};
  }
  return std::nullopt;
}

}  // namespace

Property settingOf(const OperationValues& values, std::string_view id) {
  const auto setting = find(values.operation(), id);
  assert(setting);
  const Parameter& parameter = *setting->parameter;
  Property property = parameter.property;
  property.id = id;
  if (const auto value = values.value(parameter.id())) property.value = *value;
  if (!setting->part) return property;
  property.label = parameter.parts[*setting->part].label;
  property.value = values.numbers(parameter.id())[*setting->part];
  return property;
}

bool takeSetting(OperationValues& values, std::string_view id, const PropertyValue& value) {
  const auto setting = find(values.operation(), id);
  if (!setting) return false;
  const Parameter& parameter = *setting->parameter;
  const auto* number = std::get_if<double>(&value);
  if (!setting->part && (!number || !parameter.words.empty())) return values.set(parameter.id(), value).empty();
  double taken = 0.0;
  if (!assignNumber(taken, value, {parameter.property.least, parameter.property.largest})) return false;
  if (parameter.isWhole) taken = std::round(taken);
  if (!setting->part) return values.set(parameter.id(), taken).empty();
  std::vector<double> numbers = values.numbers(parameter.id());
  numbers[*setting->part] = taken;
  values.setValid(parameter.id(), numbers);
  return true;
}

}  // namespace handwheel
