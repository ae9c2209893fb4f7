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
  // Number of the stroke that each pose belongs to; 0: none. The list is empty if there is no column "stroke", or if it
  // is ignored.
  std::vector<std::uint32_t> strokes;
  std::string problem;  // a sentence if the text is not a path; otherwise empty
};

// Handling of a column "stroke". It is ignored like any unknown column, or read as the numbers of strokes.
enum class StrokeColumn { Ignored, Read };

// Reads a tip path from comma-separated values. A header line names the columns t_s, x_mm, y_mm and z_mm, in any order,
// and possibly others. One line for each time follows; times must not decrease. Blank lines and lines that begin with #
// are skipped.
TipTrajectory readTipTrajectory(std::string_view text, StrokeColumn strokes = StrokeColumn::Ignored);

}  // namespace handwheel
