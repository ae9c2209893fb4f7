// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/PropertyText.h"

#include "base/Expression.h"
#include "base/NumberText.h"
#include "document/OperationText.h"

#include <cmath>
#include <optional>

namespace handwheel {

namespace {

constexpr int kLimitDigits = 12;  // without the digits that a conversion of units leaves
constexpr int kShownDigits = 6;
constexpr double kNothing = 1e-9;  // mm or rad: what rounding leaves of zero

std::string numberText(double value, Quantity quantity, int digits) {
  switch (quantity) {
    case Quantity::Length:
      return roundedText(value, digits) + " mm";
    case Quantity::Angle:
      return roundedText(value / kRadiansPerDegree, digits) + " deg";
    case Quantity::Number:
      break;
  }
  return roundedText(value, digits);
}

std::string shownNumber(double value, Quantity quantity) {
  const bool isNothing = quantity != Quantity::Number && std::abs(value) < kNothing;
  return numberText(isNothing ? 0.0 : value, quantity, kShownDigits);
}

// Returns " mm³" of "Volume (mm³)": quantities other than lengths and angles have their unit at the end of the label.
std::string unitInLabel(const Property& property) {
  const std::size_t open = property.translated ? property.label.rfind('(') : std::string::npos;
  if (open == std::string::npos || !property.label.ends_with(')')) return {};
  return " " + property.label.substr(open + 1, property.label.size() - open - 2);
}

// Returns the kind of values that a property accepts, as the end of a sentence.
std::string wanted(const Property& property) {
  if (std::holds_alternative<bool>(property.value)) return "yes or no";
  if (!property.choices.empty()) return choicesText(property.choices);
  switch (property.quantity) {
    case Quantity::Length:
      return "a length, such as 12.5, 25.4/2 or 1in";
    case Quantity::Angle:
      return "an angle, such as 30, 30deg or pi/6 rad";
    case Quantity::Number:
      break;
  }
  return "a number";
}

std::optional<PropertyValue> valueOf(const Property& property, const std::string& word) {
  if (std::holds_alternative<std::string>(property.value)) return word;
  if (std::holds_alternative<bool>(property.value)) {
    return word == "yes" || word == "no" ? std::optional<PropertyValue>(word == "yes") : std::nullopt;
  }
  for (std::size_t i = 0; i < property.choices.size(); ++i) {
    if (property.choices[i] == word) return static_cast<double>(i);
  }
  if (!property.choices.empty()) return std::nullopt;
  const ExpressionResult value = evaluateExpression(word, {.quantity = property.quantity});
  const auto* number = std::get_if<double>(&value);
  return number ? std::optional<PropertyValue>(*number) : std::nullopt;
}

}  // namespace

std::string propertyText(const Property& property) {
  if (const auto* text = std::get_if<std::string>(&property.value)) return *text;
  if (const auto* on = std::get_if<bool>(&property.value)) return *on ? "yes" : "no";
  const double number = std::get<double>(property.value);
  if (property.choices.empty()) return shownNumber(number, property.quantity) + unitInLabel(property);
  return property.choices.at(static_cast<std::size_t>(number));
}

std::string limitsText(const Property& property) {
  return shownNumber(property.least, property.quantity) + " to " + shownNumber(property.largest, property.quantity);
}

std::variant<PropertyValue, std::string> propertyValue(const Property& property, const std::string& word) {
  const std::optional<PropertyValue> value = valueOf(property, word);
  if (!value) return property.id + " takes " + wanted(property) + ", not '" + word + "'.";
  const auto* number = std::get_if<double>(&*value);
  if (!number) return *value;
  if (const auto kept = withinShownLimits(*number, property.least, property.largest)) return PropertyValue(*kept);
  return property.id + " must lie between " + numberText(property.least, property.quantity, kLimitDigits) + " and " +
         numberText(property.largest, property.quantity, kLimitDigits) + ".";
}

}  // namespace handwheel
