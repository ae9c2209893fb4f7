// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

namespace handwheel {

// From where the model is seen. The projection is parallel, so that lengths on the screen can be compared and the scale
// bar holds for the whole picture. A value: each document keeps its own.
struct CameraState {
  Vec3 centre = Vec3::Zero();  // the point in the middle of the view
  // Turns view axes (x right, y up, z towards the viewer) into model axes.
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  double height = 1.0;  // length seen from the bottom to the top of the view, in units of the model

  Vec3 right() const { return orientation * Vec3::UnitX(); }
  Vec3 up() const { return orientation * Vec3::UnitY(); }
  Vec3 towardsViewer() const { return orientation * Vec3::UnitZ(); }

  bool operator==(const CameraState& o) const {
    return centre == o.centre && orientation.coeffs() == o.orientation.coeffs() && height == o.height;
  }
};

}  // namespace handwheel
