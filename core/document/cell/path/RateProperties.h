// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Property.h"
#include "robot/program/RobotPath.h"

#include <span>
#include <string_view>

namespace handwheel {

// A field of AssumedRates.
struct RateField {
  const char* key;    // in files; as a property, after "rates."
  const char* label;  // English, context "Property"
  double AssumedRates::*value;
  Quantity quantity;
  double least, largest;  // in the units of AssumedRates
};
std::span<const RateField> rateFields();

// Returns the properties of the assumed rates of a cell, such as "rates.to_speed_s".
std::vector<Property> rateProperties(const AssumedRates& rates);

bool isRateProperty(std::string_view id);

// Returns the plans with another value of one of these properties. Errors: ElementMalformed, ValueOutOfRange,
// ReferenceMissing.
Result<CellPlans> changedRate(const CellPlans& plans, const std::string& id, const PropertyValue& value);

}  // namespace handwheel
