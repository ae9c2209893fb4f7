// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"

#include <vector>

namespace handwheel {

// Makes a scan fit to be touched by a point, which would slip into a seam of a micrometre: corners on open borders that
// are all but one are made one, and between borders that run side by side strips of triangles are added. What is more
// than a seam apart, such as a hole, stays open. The corners move by less than the seam; the numbers of the
// triangles that were there stay. Points that are equal must have one number (mesh/Weld.h). O(n log n). Of no use once
// cancelled.
void closeSeams(std::vector<Vec3>& points, std::vector<Triangle>& triangles, Progress progress = {});

}  // namespace handwheel
