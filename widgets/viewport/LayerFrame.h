// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ClipPlane.h"

namespace handwheel {

// The parameters of one frame for the layers. Directions and lengths are in the coordinates of the model.
struct LayerFrame {
  Vec3 origin = Vec3::Zero();  // the model point at the origin of the drawing
  Vec3 offset = Vec3::Zero();  // from `origin` to the model point at the origin of the geometry
  double pixelRatio = 1.0;     // device pixels per logical pixel
  // The two parts of the map that moves an actor towards the viewer by the length of one logical pixel, without
  // changing its position on the screen: p becomes (1 - shrinkPerPixel) p + shiftPerPixel, relative to the origin of
  // the drawing. Under parallel projection, this is a shift along the view direction, and shrinkPerPixel is 0. Under
  // perspective, where a pixel is longer at larger distances, it is a scaling about the eye.
  Vec3 shiftPerPixel = Vec3::Zero();
  double shrinkPerPixel = 0.0;
  ClipPlane clip;  // clipping plane, relative to the origin of the drawing

  // Returns the same frame for geometry relative to this model point.
  LayerFrame about(const Vec3& point) const {
    LayerFrame frame = *this;
    frame.offset = point - origin;
    return frame;
  }
};

}  // namespace handwheel
