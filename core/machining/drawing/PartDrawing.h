// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/drawing/Sheet.h"
#include "machining/target/TargetProfile.h"

#include <string>
#include <vector>

namespace handwheel {

// A tolerance that a drawing shows behind the dimensions of this size.
struct DrawnTolerance {
  enum class Of { Diameter, Length };
  Of of = Of::Diameter;
  double size = 0.0;  // mm, nominal
  std::string text;   // "h7", "±0.1"
};

// What a drawing says besides the shape of the part.
struct DrawingTitle {
  std::string name, material;  // UTF-8; cut where they are longer than their fields
  std::vector<DrawnTolerance> tolerances;
  double tolerance = 1e-3;  // mm, of the features (featuresOf())
};

// Draws a turned part on A4, or on A3 where it has many dimensions.
//
// The view from the side has the axis horizontal. A part with a bore is shown in half section above the axis, others
// whole. It has diameters, lengths from the upper end, radii, angles and chamfers, a frame (ISO 5457) and a title block
// with name, material, scale (ISO 5455), unit and the sign of first angle projection (ISO 128-3, 5456-2). Dimensions
// are those of the features, to 0.01 mm (ISO 129-1). O(segments).
Sheet drawingSheet(const TargetProfile& part, const DrawingTitle& title);

}  // namespace handwheel
