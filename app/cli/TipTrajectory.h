// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/PoseTrajectory.h"

#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// A path of the device tip over time.
struct TipTrajectory {
  std::vector<HandPose> poses;
  std::string problem;  // a sentence when the text is not such a path; else empty
};

// Reads a tip path from comma-separated values. A header line has the column names t_s,x_mm,y_mm,z_mm, in any order
// and perhaps among others; one line for each time follows, and times do not decrease. Blank lines and those that begin
// with # are skipped.
TipTrajectory readTipTrajectory(std::string_view text);

}  // namespace handwheel
