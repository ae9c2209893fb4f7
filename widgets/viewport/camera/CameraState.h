// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Units.h"

#include <cmath>

namespace handwheel {

// The projection of a camera. Under parallel projection, lengths on the screen can be compared, and a scale bar is
// valid for the whole picture; under perspective, near objects are larger.
enum class Projection { Parallel, Perspective };

// The vertical field of view under perspective, rad.
inline constexpr double kFieldOfView = 30.0 * kRadiansPerDegree;

// The position, orientation and projection of a camera. Each document has its own camera state.
struct CameraState {
  Vec3 centre = Vec3::Zero();  // the focus: the point in the middle of the view
  // Rotation from the axes of the view (x right, y up, z towards the viewer) to those of the model.
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  double height = 1.0;  // visible length from the bottom to the top of the view at the focus, mm
  Projection projection = Projection::Parallel;

  Vec3 right() const { return orientation * Vec3::UnitX(); }
  Vec3 up() const { return orientation * Vec3::UnitY(); }
  Vec3 towardsViewer() const { return orientation * Vec3::UnitZ(); }

  // Returns the distance of the eye from the focus under perspective. At this distance, the field of view spans
  // `height`.
  double eyeDistance() const { return height / (2.0 * std::tan(kFieldOfView / 2.0)); }
  Vec3 eye() const { return centre + eyeDistance() * towardsViewer(); }

  bool operator==(const CameraState& o) const {
    return centre == o.centre && orientation.coeffs() == o.orientation.coeffs() && height == o.height &&
           projection == o.projection;
  }
};

}  // namespace handwheel
