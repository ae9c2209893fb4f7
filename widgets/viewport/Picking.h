// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ClipPlane.h"
#include "viewport/ViewLayer.h"

namespace handwheel {

// All pickable objects: the visible layers, without the parts that the plane clips.
struct Pickable {
  std::vector<const ViewLayer*> layers = {};
  ClipPlane clip = {};

  Box bounds() const;
};

// Returns the first element along the ray that is not clipped. The direction has unit length.
Pick pickAlong(const Pickable& pickable, const Vec3& origin, const Vec3& direction);

// Picks the element at the cursor. It is the nearest of those within some pixels that no surface hides, else the first
// along the ray.
Pick pickAt(const Pickable& pickable, const CameraNavigation& view, const Vec2& cursor);

}  // namespace handwheel
