// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/SelectSettings.h"

#include "tools/ToolProperty.h"

#include <QtGlobal>
#include <algorithm>
#include <numbers>

namespace handwheel {
namespace {

constexpr Limits kBrushLength = {1e-6, 1e6};  // mm
constexpr Limits kPixels = {1.0, 1000.0};     // logical pixels
constexpr Limits kAngle = {0.0, std::numbers::pi};

}  // namespace

void SelectSettings::scaleBrush(double factor) {
  if (brushUnit == Unit::Pixels) {
    brushPixels = kPixels.bring(factor * brushPixels);
  } else {
    brushLength = kBrushLength.bring(factor * brushLength);
  }
}

std::vector<Property> SelectSettings::properties() const {
  std::vector<Property> all;
  all.push_back(choiceSetting("mode", QT_TRANSLATE_NOOP("Property", "Select by"), static_cast<int>(mode),
                              {QT_TRANSLATE_NOOP("Property", "Click"), QT_TRANSLATE_NOOP("Property", "Brush"),
                               QT_TRANSLATE_NOOP("Property", "Lasso"), QT_TRANSLATE_NOOP("Property", "Connected"),
                               QT_TRANSLATE_NOOP("Property", "Angle")}));
  if (mode == Mode::Brush) {
    all.push_back(
        choiceSetting("brush_unit", QT_TRANSLATE_NOOP("Property", "Size in"), static_cast<int>(brushUnit),
                      {QT_TRANSLATE_NOOP("Property", "Length on the model"), QT_TRANSLATE_NOOP("Property", "Pixels")}));
    all.push_back(brushUnit == Unit::Pixels
                      ? numberSetting("brush_pixels", QT_TRANSLATE_NOOP("Property", "Brush radius"), brushPixels,
                                      Quantity::Number, kPixels)
                      : numberSetting("brush_length", QT_TRANSLATE_NOOP("Property", "Brush radius"), brushLength,
                                      Quantity::Length, kBrushLength));
  }
  if (mode == Mode::Lasso) {
    all.push_back(switchSetting("through", QT_TRANSLATE_NOOP("Property", "Select through the model"), through));
  }
  if (mode == Mode::Angle) {
    all.push_back(
        numberSetting("angle", QT_TRANSLATE_NOOP("Property", "Largest angle"), angle, Quantity::Angle, kAngle));
    all.back().continuous = true;
  }
  return all;
}

bool SelectSettings::set(std::string_view id, const PropertyValue& value) {
  if (id == "mode") return assignChoice(mode, value, 5);
  if (id == "brush_unit") return assignChoice(brushUnit, value, 2);
  if (id == "brush_length") return assignNumber(brushLength, value, kBrushLength);
  if (id == "brush_pixels") return assignNumber(brushPixels, value, kPixels);
  if (id == "angle") return assignNumber(angle, value, kAngle);
  return id == "through" && assignSwitch(through, value);
}

}  // namespace handwheel
