// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Property.h"
#include "mesh/Sight.h"

#include <string_view>

namespace handwheel {

// How faces are selected.
struct SelectSettings {
  enum class Mode { Click, Brush, Lasso, Connected, Angle };
  enum class Unit { Millimetres, Pixels };

  Mode mode = Mode::Click;
  Unit brushUnit = Unit::Pixels;
  double brushLength = 5.0;   // mm; radius
  double brushPixels = 24.0;  // logical pixels; radius
  double angle = 0.35;        // radian: between the normals of neighbours
  bool through = false;       // the lasso also takes what is turned away or hidden

  // mm, of a brush at a point.
  double brushRadius(const Sight& sight, const Vec3& at) const {
    return brushUnit == Unit::Pixels ? brushPixels * sight.pixelAt(at) : brushLength;
  }
  // By a factor, in its unit.
  void scaleBrush(double factor);

  // Those that matter in the present mode.
  std::vector<Property> properties() const;
  // Numbers are brought between their limits. False, and nothing changed, for what is unknown or of another kind.
  bool set(std::string_view id, const PropertyValue& value);
};

}  // namespace handwheel
