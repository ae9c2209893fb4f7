// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/drawing/Sheet.h"

#include <string>

namespace handwheel {

// The position of a part on its sheet, which maps (r, z) to paper millimetres.
struct DrawingPlace {
  ProfilePoint origin{0, 0};  // of r = 0, z = 0
  double scale = 1.0;

  ProfilePoint at(double r, double z) const { return origin + scale * ProfilePoint(z, r); }
  ProfilePoint at(const ProfilePoint& p) const { return at(p.x(), p.y()); }
  // (r, z) to paper is a reflection, which turns arcs round.
  ProfileSegment at(const ProfileSegment& s) const { return {at(s.from), at(s.to), -s.bulge}; }
  // On the other side of the axis.
  ProfileSegment below(const ProfileSegment& s) const {
    return {at(-s.from.x(), s.from.y()), at(-s.to.x(), s.to.y()), s.bulge};
  }
};

// The largest scale of ISO 5455 at which a length is not drawn longer than `room` (mm).
double standardScale(double length, double room);
// The next smaller one; the least of all where there is none.
double nextScale(double scale);
// "1:2", "5:1".
std::string scaleText(double scale);

// A size as a drawing says it: to 0.01, without zeros at the end.
std::string sizeText(double value);

// The frame and the title block of a sheet. Its height above the frame is kTitleHeight, at the right.
inline constexpr double kFrameLeft = 20.0, kFrame = 10.0;  // mm, from the edges of the paper
inline constexpr double kTitleWidth = 170.0, kTitleHeight = 24.0;
void addTitleBlock(Sheet& sheet, const std::string& name, const std::string& material, double scale);

}  // namespace handwheel
