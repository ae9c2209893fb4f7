// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ViewLayer.h"

#include <span>

namespace handwheel {

// Adds a hit for each segment of a polyline within kHolePickRadius of the cursor. The hit is the point of the segment
// nearest to the cursor on the screen. closed: true if the last point is connected to the first.
void findNearLine(std::span<const Vec3> points, bool closed, std::uint64_t element, const CameraNavigation& view,
                  const Vec2& cursor, std::vector<LayerHit>& found);

}  // namespace handwheel
