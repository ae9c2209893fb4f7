// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ClipPlane.h"

namespace handwheel {

// The parameters of one frame for the layers. Directions and lengths are those of the model.
struct LayerFrame {
  Vec3 origin = Vec3::Zero();  // the model point at the origin of the drawing
  Vec3 offset = Vec3::Zero();  // from there to the model point at the origin of the geometry
  double pixelRatio = 1.0;     // device pixels to a logical pixel
  // The depth offset of an actor by a logical pixel towards the viewer, without changing its position on the screen.
  // Under parallel projection it is a shift along the view; under perspective, where a pixel is longer at larger
  // distances, a scaling towards the eye.
  Vec3 shiftPerPixel = Vec3::Zero();
  double shrinkPerPixel = 0.0;
  ClipPlane clip;  // about the origin of the drawing

  // Returns the same frame for geometry relative to this model point.
  LayerFrame about(const Vec3& point) const {
    LayerFrame frame = *this;
    frame.offset = point - origin;
    return frame;
  }
};

}  // namespace handwheel
