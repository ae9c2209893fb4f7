// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"

#include <vector>

namespace handwheel {

// Closes narrow gaps between open borders of a mesh. Gaps in a scan may be a micrometre wide, and a point proxy would
// slip into them. Nearly equal corners on open borders are merged, and strips of triangles are added between borders
// that run side by side. Wider gaps, such as holes, stay open. The corners move by less than the width of the gap; the
// existing triangles keep their indices. Equal points must have the same index (mesh/Weld.h). O(n log n). The result is
// invalid if cancelled.
void closeContactGaps(std::vector<Vec3>& points, std::vector<Triangle>& triangles, Progress progress = {});

}  // namespace handwheel
