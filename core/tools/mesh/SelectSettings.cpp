// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/SelectSettings.h"

#include <QtGlobal>
#include <algorithm>
#include <numbers>

namespace handwheel {
namespace {

struct Limits {
  double least, largest;
  double bring(double value) const { return std::clamp(value, least, largest); }
};
constexpr Limits kLength = {1e-6, 1e6};    // mm
constexpr Limits kPixels = {1.0, 1000.0};  // logical pixels
constexpr Limits kAngle = {0.0, std::numbers::pi};

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

Property choice(const char* id, const char* label, int chosen, std::vector<std::string> choices) {
  Property property;
  property.id = id;
  property.label = label;
  property.value = static_cast<double>(chosen);
  property.choices = std::move(choices);
  return property;
}

// The number of a choice, where the value is one.
template <class Choice>
bool choose(Choice& choice, const PropertyValue& value, int count) {
  const double* index = std::get_if<double>(&value);
  if (!index || !(*index >= 0.0 && *index < count)) return false;
  choice = static_cast<Choice>(static_cast<int>(*index));
  return true;
}

bool take(double& number, const PropertyValue& value, const Limits& limits) {
  const double* given = std::get_if<double>(&value);
  if (!given || *given != *given) return false;
  number = limits.bring(*given);
  return true;
}

}  // namespace

void SelectSettings::scaleBrush(double factor) {
  if (brushUnit == Unit::Pixels) {
    brushPixels = kPixels.bring(factor * brushPixels);
  } else {
    brushLength = kLength.bring(factor * brushLength);
  }
}

std::vector<Property> SelectSettings::properties() const {
  std::vector<Property> all;
  all.push_back(choice("mode", QT_TRANSLATE_NOOP("Property", "Select by"), static_cast<int>(mode),
                       {QT_TRANSLATE_NOOP("Property", "Click"), QT_TRANSLATE_NOOP("Property", "Brush"),
                        QT_TRANSLATE_NOOP("Property", "Lasso"), QT_TRANSLATE_NOOP("Property", "Connected"),
                        QT_TRANSLATE_NOOP("Property", "Angle")}));
  if (mode == Mode::Brush) {
    all.push_back(
        choice("brush_unit", QT_TRANSLATE_NOOP("Property", "Size in"), static_cast<int>(brushUnit),
               {QT_TRANSLATE_NOOP("Property", "Length on the model"), QT_TRANSLATE_NOOP("Property", "Pixels")}));
    all.push_back(brushUnit == Unit::Pixels ? number("brush_pixels", QT_TRANSLATE_NOOP("Property", "Brush radius"),
                                                     brushPixels, Quantity::Number, kPixels)
                                            : number("brush_length", QT_TRANSLATE_NOOP("Property", "Brush radius"),
                                                     brushLength, Quantity::Length, kLength));
  }
  if (mode == Mode::Lasso) {
    Property property;
    property.id = "through";
    property.label = QT_TRANSLATE_NOOP("Property", "Select through the model");
    property.value = through;
    all.push_back(std::move(property));
  }
  if (mode == Mode::Angle) {
    all.push_back(number("angle", QT_TRANSLATE_NOOP("Property", "Largest angle"), angle, Quantity::Angle, kAngle));
    all.back().continuous = true;
  }
  return all;
}

bool SelectSettings::set(std::string_view id, const PropertyValue& value) {
  if (id == "mode") return choose(mode, value, 5);
  if (id == "brush_unit") return choose(brushUnit, value, 2);
  if (id == "brush_length") return take(brushLength, value, kLength);
  if (id == "brush_pixels") return take(brushPixels, value, kPixels);
  if (id == "angle") return take(angle, value, kAngle);
  if (id != "through" || !std::holds_alternative<bool>(value)) return false;
  through = std::get<bool>(value);
  return true;
}

}  // namespace handwheel
