// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/PropertyText.h"

#include "base/Expression.h"

#include <charconv>

namespace handwheel {

namespace {

std::string shortest(double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  return {digits, end};
}

std::string numberText(double value, Quantity quantity) {
  switch (quantity) {
    case Quantity::Length:
      return shortest(value) + " mm";
    case Quantity::Angle:
      return shortest(value / kRadiansPerDegree) + " deg";
    case Quantity::Number:
      break;
  }
  return shortest(value);
}

Error malformed(const Property& property, const char* why) {
  return {ErrorCode::ElementMalformed, {property.id, why}, {}, {}};
}

Result<PropertyValue> chosen(const Property& property, const std::string& word) {
  for (std::size_t i = 0; i < property.choices.size(); ++i) {
    if (property.choices[i] == word) return PropertyValue(static_cast<double>(i));
  }
  std::string all;
  for (const std::string& choice : property.choices) all += (all.empty() ? "" : ", ") + choice;
  return malformed(property, ("it takes " + all).c_str());
}

}  // namespace

std::string propertyText(const Property& property) {
  if (const auto* text = std::get_if<std::string>(&property.value)) return *text;
  if (const auto* on = std::get_if<bool>(&property.value)) return *on ? "yes" : "no";
  const double number = std::get<double>(property.value);
  if (property.choices.empty()) return numberText(number, property.quantity);
  return property.choices.at(static_cast<std::size_t>(number));
}

Result<PropertyValue> propertyValue(const Property& property, const std::string& word) {
  if (std::holds_alternative<std::string>(property.value)) return PropertyValue(word);
  if (std::holds_alternative<bool>(property.value)) {
    if (word == "yes" || word == "no") return PropertyValue(word == "yes");
    return malformed(property, "it takes yes or no");
  }
  if (!property.choices.empty()) return chosen(property, word);
  const ExpressionResult value = evaluateExpression(word, {.quantity = property.quantity});
  if (const auto* number = std::get_if<double>(&value)) return PropertyValue(*number);
  return malformed(property, "a number was expected, such as 12.5, 25.4/2, 1in or 30deg");
}

}  // namespace handwheel
