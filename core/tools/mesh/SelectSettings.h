// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Property.h"
#include "mesh/search/PickRay.h"

#include <string_view>

namespace handwheel {

// Settings of SelectTool: mode, brush and angle.
struct SelectSettings {
  enum class Mode { Click, Brush, Lasso, Connected, Angle };
  enum class Unit { Millimetres, Pixels };

  Mode mode = Mode::Click;
  Unit brushUnit = Unit::Pixels;
  double brushLength = 5.0;   // radius, mm
  double brushPixels = 24.0;  // radius, logical pixels
  double angle = 0.35;        // largest angle between the normals of neighbouring faces, radian
  bool through = false;       // the lasso also selects back-facing or hidden faces

  // Returns the radius of the brush at a point, mm.
  double brushRadius(const PickRay& pickRay, const Vec3& at) const {
    return brushUnit == Unit::Pixels ? brushPixels * pickRay.pixelAt(at) : brushLength;
  }
  // Scales the brush by a factor, in its unit.
  void scaleBrush(double factor);

  // Returns the settings that apply in the present mode.
  std::vector<Property> properties() const;
  // Changes a setting. Numbers are clamped to their limits. Returns false for an unknown id or a value of another type.
  bool set(std::string_view id, const PropertyValue& value);
};

}  // namespace handwheel
