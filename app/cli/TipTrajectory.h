// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/PoseTrajectory.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// A path of the device tip over time.
struct TipTrajectory {
  std::vector<HandPose> poses;
  // Of each pose, the number of the stroke that it belongs to; 0: the hand only moves. Empty without such a column, or
  // where it is not read.
  std::vector<std::uint32_t> strokes;
  std::string problem;  // a sentence when the text is not such a path; else empty
};

// Whether a column "stroke" numbers strokes, or is one of those that do not matter.
enum class StrokeColumn { Ignored, Read };

// Reads a tip path from comma-separated values. A header line has the column names t_s,x_mm,y_mm,z_mm, in any order
// and perhaps among others; one line for each time follows, and times do not decrease. Blank lines and those that begin
// with # are skipped.
TipTrajectory readTipTrajectory(std::string_view text, StrokeColumn strokes = StrokeColumn::Ignored);

}  // namespace handwheel
