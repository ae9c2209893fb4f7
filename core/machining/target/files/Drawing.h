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

// The lines and arcs of a DXF or SVG file. x to the right, y up; mm.
struct Drawing {
  static constexpr double kCurveTolerance = 1e-4;  // mm; tolerance of arcs that replace other curves

  std::vector<ProfileSegment> curves;         // (x, y); a positive bulge turns from x to y
  std::optional<double> axis;                 // y of the line that is marked as the axis
  bool hasUnit = false;                       // the file says its unit of length
  std::map<std::string, std::size_t> others;  // other entities, which are not read: "TEXT", by its name in the file
};

// Returns the target that a drawing shows: the half section beside a horizontal axis, on either side of it.
//
// Curves are joined if their ends are within kGap; those along the axis are left out, and duplicates count once. Two
// open outlines, of outside and bore, are joined by flat faces. z is x, and the axis is at y = 0 if none is marked.
// Errors: those of TargetProfile::make(), TargetError::NoProfile, SeveralProfiles, CrossesItself.
Result<TargetProfile> targetIn(const Drawing& drawing, Progress progress = {});
inline constexpr double kDrawingGap = 1e-3;  // mm

// Returns a target as a drawing for files: z to the right, the radius up, the axis at y = 0.
Drawing drawingOf(const TargetProfile& target);

}  // namespace handwheel
