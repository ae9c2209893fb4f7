// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ViewLayer.h"

#include <span>

namespace handwheel {

// Adds a pick hit for each segment of a polyline near the cursor. The segment is within kHolePickRadius, and the hit is
// its point nearest to the cursor on the screen. closed: the last point is connected to the first.
void findNearLine(std::span<const Vec3> points, bool closed, std::uint64_t element, const CameraNavigation& view,
                  const Vec2& cursor, std::vector<LayerHit>& found);

}  // namespace handwheel
