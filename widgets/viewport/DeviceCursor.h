// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/Lighting.h"
#include "viewport/camera/CameraNavigation.h"

#include <QPainter>

namespace handwheel {

// The cursor of a haptic device: contact point, tip and force. The tip may be inside the model, while the proxy stays
// on its surface. Lengths are in mm, forces in N.
struct DeviceCursor {
  Vec3 tip = Vec3::Zero();          // position of the device, which may be below the surface
  Vec3 proxy = Vec3::Zero();        // the tip on the surface; equal to the tip in free space
  Vec3 force = Vec3::Zero();        // in the scene
  double limit = 1.0;               // N: largest force of the device, > 0
  std::optional<Vec3> shadow = {};  // point of the surface in shadowDirection() from the proxy
  bool isHidden = false;            // the proxy is hidden by the model

  bool operator==(const DeviceCursor&) const = default;
};

// Returns the direction of the light that casts the cursor's shadow. It comes from above the viewer, so that on the
// screen the shadow lies below the cursor by as much as the cursor is in front of the surface, and meets it on contact.
// The result has unit length.
Vec3 shadowDirection(const CameraState& camera);

// The cursor projected to the view, in logical pixels. Points beside or behind the eye have no value.
struct CursorLook {
  std::optional<Vec2> proxy, tip, shadow, arrow;  // arrow: the head of the force arrow, which starts at the proxy
  double radius = 0.0;                            // radius of the proxy, which increases towards the viewer
  double shadowRadius = 0.0;
  double load = 0.0;     // force divided by the limit, 0…1
  bool isApart = false;  // the tip is visibly apart from the proxy
};
// Projects a cursor to the view.
CursorLook lookOf(const DeviceCursor& cursor, const CameraNavigation& view);

// Draws the cursor over the view.
void paintCursor(QPainter& painter, const DeviceCursor& cursor, const CameraNavigation& view,
                 const SceneColours& colours);

}  // namespace handwheel
