// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/OperationText.h"

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

// Random values of operations, for property tests.
namespace handwheel::test {

// Returns a random number between the limits, of any magnitude.
inline double anyNumber(double least, double largest) {
  constexpr double kFar = 1e15;
  const double low = std::max(least, -kFar), high = std::min(largest, kFar);
  const double share = 1e-9 * static_cast<double>(*rc::gen::inRange<std::int64_t>(0, 1'000'000'001));
  if (low > 0.0 && *rc::gen::inRange(0, 2) == 0) return std::clamp(low * std::pow(high / low, share), low, high);
  return std::clamp(low + share * (high - low), low, high);
}

inline PropertyValue anyValue(const Parameter& parameter) {
  const Property& p = parameter.property;
  if (parameter.isFlag()) return *rc::gen::inRange(0, 2) == 1;
  if (!parameter.words.empty())
    return static_cast<double>(*rc::gen::inRange(0, static_cast<int>(parameter.words.size())));
  if (std::holds_alternative<double>(p.value)) {
    const double number = anyNumber(p.least, p.largest);
    return parameter.isWhole ? std::clamp(std::round(number), p.least, p.largest) : number;
  }
  if (!parameter.parts.empty()) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < parameter.parts.size(); ++i) numbers.push_back(anyNumber(p.least, p.largest));
    return listText(parameter, numbers);
  }
  return *rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::element('0', '7', '9', ',', ':', 'v')));
}

// Returns random values for some parameters of an operation; some of them are the defaults.
inline OperationValues anyValues(const Operation& operation) {
  OperationValues values(operation);
  for (const Parameter& parameter : operation.parameters) {
    const int what = *rc::gen::inRange(0, 4);
    if (what == 0 && parameter.hasDefault) values.setValid(parameter.id(), parameter.property.value);
    if (what > 1) values.setValid(parameter.id(), anyValue(parameter));
  }
  return values;
}

}  // namespace handwheel::test
