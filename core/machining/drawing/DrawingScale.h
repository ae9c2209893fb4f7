// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/drawing/Sheet.h"

#include <string>

namespace handwheel {

// The position and scale of a part on its sheet. They map (r, z) to paper millimetres.
struct DrawingLayout {
  ProfilePoint origin{0, 0};  // position of r = 0, z = 0
  double scale = 1.0;

  ProfilePoint at(double r, double z) const { return origin + scale * ProfilePoint(z, r); }
  ProfilePoint at(const ProfilePoint& p) const { return at(p.x(), p.y()); }
  // Mapping (r, z) to paper is a reflection, which reverses the sense of arcs.
  ProfileSegment at(const ProfileSegment& s) const { return {at(s.from), at(s.to), -s.bulge}; }
  // The segment mirrored to the other side of the axis.
  ProfileSegment below(const ProfileSegment& s) const {
    return {at(-s.from.x(), s.from.y()), at(-s.to.x(), s.to.y()), s.bulge};
  }
};

// Returns the largest scale of ISO 5455 that draws a length no longer than `room` (mm).
double standardScale(double length, double room);
// Returns the next smaller scale, or the least of all.
double nextScale(double scale);
// Returns the text of a scale: "1:2", "5:1".
std::string scaleText(double scale);

// Returns a size as drawings state it: to 0.01, without trailing zeros.
std::string sizeText(double value);

// The frame and the title block of a sheet. The title block is in the lower right corner of the frame.
inline constexpr double kFrameLeft = 20.0, kFrame = 10.0;  // mm, from the edges of the paper
inline constexpr double kTitleWidth = 170.0, kTitleHeight = 24.0;
void addTitleBlock(Sheet& sheet, const std::string& name, const std::string& material, double scale);

}  // namespace handwheel
