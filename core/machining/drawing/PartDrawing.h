// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/drawing/DrawingScale.h"
#include "machining/drawing/Sheet.h"
#include "machining/target/TargetProfile.h"

#include <string>
#include <utility>
#include <vector>

namespace handwheel {

// A tolerance that a drawing shows after a dimension. The dimension is found by its nominal size and its z. A part does
// not have exactly the nominal sizes, so a size near the nominal one at this z is shown with the nominal value.
struct DrawnTolerance {
  enum class Of { Diameter, Bore, Length, Radius };
  Of of = Of::Diameter;
  double size = 0.0;             // mm, nominal size
  std::string text;              // "h7", "±0.1"
  double low = 0.0, high = 0.0;  // mm; z of the ends of the surface, or of the two faces of a length
};

// A thread, which is drawn as its crest and a narrow line at its root (ISO 6410-1).
struct DrawnThread {
  std::string designation;          // "M20×2.5", with its tolerance class if it has one
  double low = 0.0, high = 0.0;     // mm, z
  double major = 0.0, minor = 0.0;  // mm, diameters
  bool isInner = false;
};

struct DrawnRoughness {
  double ra = 0.0;               // µm, largest Ra
  double low = 0.0, high = 0.0;  // mm, z
  bool isInner = false;
};

// The texts and annotations of a drawing besides the shape of the part.
struct DrawingTitle {
  std::string name, material;  // UTF-8; truncated if longer than their fields
  std::vector<DrawnTolerance> tolerances;
  double tolerance = 1e-3;  // mm, tolerance of the features (featuresOf())
  std::vector<DrawnThread> threads;
  std::vector<DrawnRoughness> roughness;
};

// Size below which features have no dimension: in mm, and for small parts as a fraction of the size of the part
inline constexpr double kLeastDrawn = 0.05, kLeastDrawnShare = 1.0 / 400.0;

// Draws a turned part on A4, or on A3 if it has many dimensions.
//
// The part is seen from the side, with its axis horizontal. A part with a bore is shown in half section above the axis,
// other parts whole. The drawing has diameters, lengths from the upper end, radii, angles and chamfers, threads,
// roughness (ISO 21920-1), a frame (ISO 5457) and a title block with name, material, scale (ISO 5455), unit and the
// symbol of first angle projection (ISO 128-3, 5456-2). Dimensions are the sizes of the features, to 0.01 mm, each
// once: equal radii and chamfers share a note with their number, and sizes that follow from others are left out (ISO
// 129-1). Texts do not overlap. If the sheet has no room for all dimensions, the dimensions of the smallest features
// are left out, and the sheet says so. O(segments · log segments).
Sheet drawingSheet(const TargetProfile& part, const DrawingTitle& title);

// Returns a sheet that has the dimensions of drawingSheet() but not the part, for a view that displays the part itself
// with this layout. O(segments · log segments).
Sheet dimensionSheet(const TargetProfile& part, const DrawingTitle& title, const DrawingLayout& layout);

}  // namespace handwheel
