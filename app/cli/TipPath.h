// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/HandPath.h"

#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

struct TipPath {
  std::vector<HandPose> poses;
  std::string problem;  // a sentence when the text is no such path; else empty
};

// The way of a tip as comma-separated values: a line with the names t_s,x_mm,y_mm,z_mm, in any order and perhaps among
// others, then a line for each time; times do not fall. Blank lines and those that begin with # are left out.
TipPath readTipPath(std::string_view text);

}  // namespace handwheel
