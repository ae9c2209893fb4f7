// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/SculptSettings.h"

#include <QtGlobal>
#include <algorithm>

namespace handwheel {
namespace {

struct Limits {
  double least, largest;
};
constexpr Limits kRadius = {1e-9, 1e9};  // mm
constexpr Limits kStrength = {0.0, 1.0};
constexpr Limits kNoiseAngle = {0.02, 1.5};  // radian

Property number(const char* id, const char* label, double value, Quantity quantity, const Limits& limits) {
  Property property;
  property.id = id;
  property.label = label;
  property.value = value;
  property.quantity = quantity;
  property.least = limits.least;
  property.largest = limits.largest;
  return property;
}

bool take(double& number, const PropertyValue& value, const Limits& limits) {
  const double* given = std::get_if<double>(&value);
  if (!given || *given != *given) return false;
  number = std::clamp(*given, limits.least, limits.largest);
  return true;
}

}  // namespace

void SculptSettings::scaleBrush(double factor) {
  radius = std::clamp(factor * radius, kRadius.least, kRadius.largest);
}

std::vector<Property> SculptSettings::properties() const {
  std::vector<Property> all(1);
  all[0].id = "brush";
  all[0].label = QT_TRANSLATE_NOOP("Property", "Brush");
  all[0].value = static_cast<double>(brush);
  all[0].choices = {QT_TRANSLATE_NOOP("Property", "Drag"), QT_TRANSLATE_NOOP("Property", "Smooth"),
                    QT_TRANSLATE_NOOP("Property", "Inflate"), QT_TRANSLATE_NOOP("Property", "Flatten")};
  all.push_back(number("radius", QT_TRANSLATE_NOOP("Property", "Brush radius"), radius, Quantity::Length, kRadius));
  if (brush != Brush::Drag) {
    all.push_back(number("strength", QT_TRANSLATE_NOOP("Property", "Strength"), strength, Quantity::Number, kStrength));
    all.back().continuous = true;
  }
  Property border;
  border.id = "moves_border";
  border.label = QT_TRANSLATE_NOOP("Property", "Move the edges of holes, too");
  border.value = movesBorder;
  all.push_back(std::move(border));
  all.push_back(
      number("noise_angle", QT_TRANSLATE_NOOP("Property", "Noise up to"), noiseAngle, Quantity::Angle, kNoiseAngle));
  return all;
}

bool SculptSettings::set(std::string_view id, const PropertyValue& value) {
  if (id == "radius") return take(radius, value, kRadius);
  if (id == "strength") return take(strength, value, kStrength);
  if (id == "noise_angle") return take(noiseAngle, value, kNoiseAngle);
  if (id == "brush") {
    const double* index = std::get_if<double>(&value);
    if (!index || !(*index >= 0.0 && *index < 4.0)) return false;
    brush = static_cast<Brush>(static_cast<int>(*index));
    return true;
  }
  if (id != "moves_border" || !std::holds_alternative<bool>(value)) return false;
  movesBorder = std::get<bool>(value);
  return true;
}

}  // namespace handwheel
