// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/sculpt/SculptSettings.h"

#include "mesh/sculpt/NoiseSmoothing.h"
#include "tools/ToolProperty.h"

#include <QtGlobal>
#include <cmath>

namespace handwheel {
namespace {

constexpr Limits kRadius = {1e-9, 1e9};  // mm
constexpr Limits kStrength = {0.0, 1.0};
constexpr Limits kNoisePasses = {1.0, 1000.0};
constexpr Limits kNoiseAngle = {NoiseSmoothing::kLeastSpread, NoiseSmoothing::kLargestSpread};  // radian

}  // namespace

void SculptSettings::scaleBrush(double factor) {
  radius = kRadius.bring(factor * radius);
}

std::vector<Property> SculptSettings::properties() const {
  std::vector<Property> all;
  all.push_back(choiceSetting("brush", QT_TRANSLATE_NOOP("Property", "Brush"), static_cast<int>(brush),
                              {QT_TRANSLATE_NOOP("Property", "Drag"), QT_TRANSLATE_NOOP("Property", "Smooth"),
                               QT_TRANSLATE_NOOP("Property", "Inflate"), QT_TRANSLATE_NOOP("Property", "Flatten")}));
  all.push_back(
      numberSetting("radius", QT_TRANSLATE_NOOP("Property", "Brush radius"), radius, Quantity::Length, kRadius));
  if (brush != Brush::Drag) {
    all.push_back(
        numberSetting("strength", QT_TRANSLATE_NOOP("Property", "Strength"), strength, Quantity::Number, kStrength));
    all.back().continuous = true;
  }
  all.push_back(
      switchSetting("moves_border", QT_TRANSLATE_NOOP("Property", "Move boundary vertices, too"), movesBorder));
  all.push_back(choiceSetting("noise_method", QT_TRANSLATE_NOOP("Property", "Noise filter"),
                              static_cast<int>(noiseMethod),
                              {QT_TRANSLATE_NOOP("Property", "Bilateral (preserves edges)"),
                               QT_TRANSLATE_NOOP("Property", "Laplace"), QT_TRANSLATE_NOOP("Property", "Bending")}));
  if (noiseMethod == NoiseMethod::Bilateral) {
    all.push_back(numberSetting("noise_angle", QT_TRANSLATE_NOOP("Property", "Noise angle"), noiseAngle,
                                Quantity::Angle, kNoiseAngle));
  } else {
    all.push_back(numberSetting("noise_passes", QT_TRANSLATE_NOOP("Property", "Passes"), noisePasses, Quantity::Number,
                                kNoisePasses));
  }
  return all;
}

bool SculptSettings::set(std::string_view id, const PropertyValue& value) {
  if (id == "radius") return assignNumber(radius, value, kRadius);
  if (id == "strength") return assignNumber(strength, value, kStrength);
  if (id == "noise_method") return assignChoice(noiseMethod, value, 3);
  if (id == "noise_passes") {
    const bool isAssigned = assignNumber(noisePasses, value, kNoisePasses);
    noisePasses = std::round(noisePasses);
    return isAssigned;
  }
  if (id == "noise_angle") return assignNumber(noiseAngle, value, kNoiseAngle);
  if (id == "brush") return assignChoice(brush, value, 4);
  return id == "moves_border" && assignSwitch(movesBorder, value);
}

}  // namespace handwheel
