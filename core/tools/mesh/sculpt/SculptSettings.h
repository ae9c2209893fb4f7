// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Property.h"

#include <string_view>
#include <vector>

namespace handwheel {

// Method of smoothing noise.
enum class NoiseMethod {
  Bilateral,  // smoothNoise(): keeps creases
  Laplace,    // smoothByLaplace()
  Bending,    // smoothByLaplace() with LaplaceSmoothing::isBending
};

// Settings of SculptTool: brush, radius and strength.
struct SculptSettings {
  enum class Brush { Drag, Smooth, Inflate, Flatten };

  Brush brush = Brush::Drag;
  double radius = 5.0;       // mm
  double strength = 0.5;     // 0…1; the brush Drag always follows the pointer fully
  bool movesBorder = false;  // strokes also move vertices on the border of the surface
  NoiseMethod noiseMethod = NoiseMethod::Bilateral;
  double noisePasses = 10.0;  // number of passes of the methods other than Bilateral
  double noiseAngle =
      20.0 * kRadiansPerDegree;  // normals that differ by less than this angle (rad) are considered noise

  void scaleBrush(double factor);

  std::vector<Property> properties() const;
  // Changes a setting. Numbers are clamped to their limits. Returns false for an unknown id or a value of another type.
  bool set(std::string_view id, const PropertyValue& value);
};

}  // namespace handwheel
