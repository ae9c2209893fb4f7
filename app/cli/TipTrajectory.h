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
  // Number of the stroke that each pose belongs to; 0: the hand only moves. Empty if there is no such column, or it is
  // not read.
  std::vector<std::uint32_t> strokes;
  std::string problem;  // a sentence if the text is not such a path; otherwise empty
};

// Handling of a column "stroke": it numbers strokes, or is ignored as any unknown column.
enum class StrokeColumn { Ignored, Read };

// Reads a tip path from comma-separated values. A header line has the column names t_s,x_mm,y_mm,z_mm, in any order
// and perhaps among others; one line for each time follows, and times do not decrease. Blank lines and those that begin
// with # are skipped.
TipTrajectory readTipTrajectory(std::string_view text, StrokeColumn strokes = StrokeColumn::Ignored);

}  // namespace handwheel
