// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/CameraNavigation.h"
#include "viewport/Lighting.h"

#include <QPainter>

namespace handwheel {

// The cursor of a haptic device: where it touches the model, where the hand has pushed it, and what it is pushed back
// with. Lengths in mm, forces in N.
struct DeviceCursor {
  Vec3 tip = Vec3::Zero();          // where the hand is: it may be below the surface
  Vec3 proxy = Vec3::Zero();        // where the tip is held by the surface; at the tip in free space
  Vec3 force = Vec3::Zero();        // as it is felt in the scene
  double limit = 1.0;               // N: of the device, > 0
  std::optional<Vec3> shadow = {};  // on the surface below it, as the light falls
  bool isHidden = false;            // something lies before the proxy

  bool operator==(const DeviceCursor&) const = default;
};

// Which way the light falls that casts the shadow: from above the viewer, so that on the screen the shadow lies below
// the cursor by as much as the cursor is before the surface, and meets it where it touches. Of length 1.
Vec3 shadowDirection(const CameraState& camera);

// Where it appears in the view, in logical pixels. What is beside or behind the eye is absent.
struct CursorLook {
  std::optional<Vec2> proxy, tip, shadow, arrow;  // arrow: its point, beginning at the proxy; none for no force
  double radius = 0.0;                            // of the proxy: larger the nearer it is to the viewer
  double shadowRadius = 0.0;
  double load = 0.0;     // share of the limit, 0…1
  bool isApart = false;  // the tip is seen beside the proxy
};
CursorLook lookOf(const DeviceCursor& cursor, const CameraNavigation& view);

void paintCursor(QPainter& painter, const DeviceCursor& cursor, const CameraNavigation& view,
                 const SceneColours& colours);

}  // namespace handwheel
