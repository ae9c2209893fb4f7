// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Property.h"

#include <string_view>
#include <vector>

namespace handwheel {

// How noise is smoothed.
enum class NoiseMethod {
  Bilateral,  // smoothNoise(): keeps creases
  Laplace,    // smoothByLaplace()
  Bending,    // the same, bending
};

// Settings of SculptTool: brush, radius and strength.
struct SculptSettings {
  enum class Brush { Drag, Smooth, Inflate, Flatten };

  Brush brush = Brush::Drag;
  double radius = 5.0;       // mm
  double strength = 0.5;     // 0…1; dragging follows the pointer all the way whatever it is
  bool movesBorder = false;  // also the vertices at the end of the surface
  NoiseMethod noiseMethod = NoiseMethod::Bilateral;
  double noisePasses = 10.0;                     // of the others
  double noiseAngle = 20.0 * kRadiansPerDegree;  // normals that differ by less are considered noise

  void scaleBrush(double factor);

  std::vector<Property> properties() const;
  // Numbers are clamped to their limits. False, and nothing changed, for an unknown id or a value of another type.
  bool set(std::string_view id, const PropertyValue& value);
};

}  // namespace handwheel
