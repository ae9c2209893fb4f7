// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/Operation.h"

#include "document/OperationText.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace handwheel {
namespace {

bool isWithin(const Parameter& parameter, double value) {
  if (!(value >= parameter.property.least && value <= parameter.property.largest)) return false;
  return std::isfinite(value) && (!parameter.isWhole || value == std::floor(value));
}

bool takes(const Parameter& parameter, const PropertyValue& value) {
  if (value.index() != parameter.property.value.index()) return false;
  const auto* number = std::get_if<double>(&value);
  if (number && !parameter.words.empty())
    return *number >= 0.0 && *number < static_cast<double>(parameter.words.size()) && *number == std::floor(*number);
  if (number) return isWithin(parameter, *number);
  if (parameter.parts.empty()) return true;
  const auto numbers = numbersIn(parameter, std::get<std::string>(value));
  return numbers && numbers->size() == parameter.parts.size() &&
         std::all_of(numbers->begin(), numbers->end(), [&](double n) { return isWithin(parameter, n); });
}

}  // namespace

Parameter measuredParameter(const char* id, const FidelitySetting& setting, const char* word, std::string meaning) {
  return {.property = {.id = id,
                       .group = {},
                       .label = {},
                       .value = setting.standard,
                       .least = setting.least,
                       .largest = setting.largest},
          .meaning = std::move(meaning),
          .word = word,
          .isWhole = setting.whole};
}

const Parameter* Operation::find(std::string_view parameter) const {
  const auto found =
      std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& p) { return p.id() == parameter; });
  return found == parameters.end() ? nullptr : &*found;
}

const Parameter& OperationValues::parameter(std::string_view id) const {
  const Parameter* found = m_operation->find(id);
  assert(found);
  return *found;
}

std::optional<PropertyValue> OperationValues::value(std::string_view id) const {
  if (const auto set = m_set.find(id); set != m_set.end()) return set->second;
  const Parameter& described = parameter(id);
  return described.hasDefault ? std::optional(described.property.value) : std::nullopt;
}

bool OperationValues::flag(std::string_view id) const {
  return std::get<bool>(*value(id));
}

double OperationValues::number(std::string_view id) const {
  return std::get<double>(*value(id));
}

std::size_t OperationValues::whole(std::string_view id) const {
  return static_cast<std::size_t>(number(id));
}

std::string OperationValues::text(std::string_view id) const {
  return std::get<std::string>(*value(id));
}

std::vector<double> OperationValues::numbers(std::string_view id) const {
  return *numbersIn(parameter(id), text(id));
}

std::optional<double> OperationValues::given(std::string_view id) const {
  const auto set = value(id);
  return set ? std::optional(std::get<double>(*set)) : std::nullopt;
}

std::string OperationValues::set(std::string_view id, const PropertyValue& value) {
  const Parameter& described = parameter(id);
  if (!takes(described, value)) return refusal(described, textOf(described, value));
  const bool isList = !described.parts.empty();
  PropertyValue own =
      isList ? PropertyValue(listText(described, *numbersIn(described, std::get<std::string>(value)))) : value;
  if (described.hasDefault && own == described.property.value) {
    reset(id);
  } else {
    m_set.insert_or_assign(std::string(id), std::move(own));
  }
  return {};
}

void OperationValues::setValid(std::string_view id, const PropertyValue& value) {
  [[maybe_unused]] const std::string problem = set(id, value);
  assert(problem.empty());
}

void OperationValues::setValid(std::string_view id, const std::vector<double>& numbers) {
  setValid(id, PropertyValue(listText(parameter(id), numbers)));
}

void OperationValues::reset(std::string_view id) {
  if (const auto set = m_set.find(id); set != m_set.end()) m_set.erase(set);
}

}  // namespace handwheel
