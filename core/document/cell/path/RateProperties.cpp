// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/path/RateProperties.h"

#include "base/NumberText.h"

#include <QtGlobal>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

const std::string kRates = "rates.";

}  // namespace

std::span<const RateField> rateFields() {
  static constexpr std::array<RateField, 4> kFields{{
      {"turning", QT_TRANSLATE_NOOP("Property", "Speed of joints without one (per second)"), &AssumedRates::turning,
       Quantity::Angle, 0.01, 100.0},
      {"sliding", QT_TRANSLATE_NOOP("Property", "Speed of slides without one (per second)"), &AssumedRates::sliding,
       Quantity::Length, 1.0, 1e5},
      {"to_speed_s", QT_TRANSLATE_NOOP("Property", "From rest to full speed (s)"), &AssumedRates::timeToSpeed,
       Quantity::Number, 0.001, 100.0},
      {"to_acceleration_s", QT_TRANSLATE_NOOP("Property", "From rest to full acceleration (s)"),
       &AssumedRates::timeToRamp, Quantity::Number, 0.001, 100.0},
  }};
  return kFields;
}

std::vector<Property> rateProperties(const AssumedRates& rates) {
  std::vector<Property> all;
  for (const RateField& field : rateFields()) {
    all.push_back({.id = kRates + field.key,
                   .group = QT_TRANSLATE_NOOP("Property", "Assumed for the times of paths"),
                   .label = field.label,
                   .value = rates.*field.value,
                   .quantity = field.quantity,
                   .least = field.least,
                   .largest = field.largest});
  }
  return all;
}

bool isRateProperty(std::string_view id) {
  return id.starts_with(kRates);
}

Result<CellPlans> changedRate(const CellPlans& plans, const std::string& id, const PropertyValue& value) {
  for (const RateField& field : rateFields()) {
    if (id != kRates + field.key) continue;
    const auto* const number = std::get_if<double>(&value);
    if (!number || !std::isfinite(*number))
      return Error{ErrorCode::ElementMalformed, {id, "a number was expected"}, {}, {}};
    const auto kept = withinShownLimits(*number, field.least, field.largest);
    if (!kept) {
      const double unit = field.quantity == Quantity::Angle ? kRadiansPerDegree : 1.0;
      return Error{ErrorCode::ValueOutOfRange,
                   {id, shownText(*number / unit), shownText(field.least / unit), shownText(field.largest / unit)},
                   {},
                   {}};
    }
    CellPlans changed = plans;
    changed.rates.*field.value = *kept;
    return changed;
  }
  return Error{ErrorCode::ReferenceMissing, {"the property", id}, {}, {}};
}

}  // namespace handwheel
