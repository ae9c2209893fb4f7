// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ClipPlane.h"
#include "viewport/ViewLayer.h"

namespace handwheel {

// The pickable layers: the visible ones, without the regions that the plane clips.
struct Pickable {
  std::vector<const ViewLayer*> layers = {};
  ClipPlane clip = {};

  Box bounds() const;
};

// Returns the first element along a ray that is not clipped. The direction must have unit length.
Pick pickAlong(const Pickable& pickable, const Vec3& origin, const Vec3& direction);

// Picks the element at the cursor. The result is the nearest element within some pixels that no surface hides, or else
// the first along the ray.
Pick pickAt(const Pickable& pickable, const CameraNavigation& view, const Vec2& cursor);

}  // namespace handwheel
