// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/OperationJson.h"

#include "base/NumberText.h"
#include "document/OperationText.h"

#include <algorithm>

namespace handwheel {

namespace {

using Json = nlohmann::ordered_json;

std::string keyOf(const Parameter& parameter) {
  std::string key = parameter.id();
  std::replace(key.begin(), key.end(), '-', '_');
  switch (parameter.property.quantity) {
    case Quantity::Length:
      return key + "_mm";
    case Quantity::Angle:
      return key + "_deg";
    case Quantity::Number:
      break;
  }
  return key;
}

// Converts an angle to degrees. Rounds it to the number that the user wrote if that was in degrees.
double degreesOf(double radian) {
  double degrees = radian / kRadiansPerDegree;
  ErrorCode why{};
  if (const std::string text = angleText(radian); !text.ends_with("rad")) parseDecimal(text, degrees, why);
  return degrees;
}

Json numberOf(const Parameter& parameter, double value) {
  if (parameter.isWhole) return static_cast<std::int64_t>(value);
  return parameter.property.quantity == Quantity::Angle ? degreesOf(value) : value;
}

Json valueOf(const OperationValues& values, const Parameter& parameter) {
  const auto value = values.value(parameter.id());
  if (!value) return nullptr;
  if (const auto* on = std::get_if<bool>(&*value)) return *on;
  if (!parameter.words.empty()) return parameter.words[values.whole(parameter.id())];
  if (const auto* number = std::get_if<double>(&*value)) return numberOf(parameter, *number);
  if (parameter.parts.empty()) return std::get<std::string>(*value);
  Json list = Json::array();
  for (const double number : values.numbers(parameter.id())) list.push_back(numberOf(parameter, number));
  return list;
}

}  // namespace

Json toJson(const OperationValues& values) {
  Json json = Json::object();
  for (const Parameter& parameter : values.operation().parameters) json[keyOf(parameter)] = valueOf(values, parameter);
  return json;
}

}  // namespace handwheel
