// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "machining/target/TargetProfile.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace handwheel {

// The lines and arcs of a DXF or SVG file. x points to the right and y up; lengths are in mm.
struct Drawing {
  static constexpr double kCurveTolerance = 1e-4;  // mm; tolerance of arcs that replace other curves

  std::vector<ProfileSegment> curves;         // (x, y); a positive bulge turns from x to y
  std::optional<double> axis;                 // y of the line that is marked as the axis
  bool hasUnit = false;                       // true: the file states its unit of length
  std::map<std::string, std::size_t> others;  // numbers of unread entities by their names, such as "TEXT"
};

// Returns the target that a drawing shows: the half section beside a horizontal axis, on either side of it.
//
// Curves are joined if their ends are within kDrawingGap. Curves along the axis are left out, and duplicates count
// once. Two open outlines, one of the outside and one of the bore, are joined by flat faces. z is x of the drawing, and
// the axis is at y = 0 if no axis is marked. Errors: the errors of TargetProfile::make(), TargetError::NoProfile,
// SeveralProfiles, CrossesItself.
Result<TargetProfile> targetIn(const Drawing& drawing, Progress progress = {});
inline constexpr double kDrawingGap = 1e-3;  // mm

// Returns a target as a drawing for files. z points to the right and the radius up, and the axis is at y = 0.
Drawing drawingOf(const TargetProfile& target);

}  // namespace handwheel
