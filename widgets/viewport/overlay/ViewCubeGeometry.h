// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/camera/CameraNavigation.h"

#include <optional>

namespace handwheel {

// A side, edge or corner of the view cube, as its outward direction. Each coordinate is -1, 0 or 1. Sides have one
// coordinate that is not zero, edges two, corners three.
using CubeRegion = Eigen::Vector3i;

// One of the nine cells of a visible side. The middle cell belongs to the side, the strips and squares around it to
// edges and corners.
struct CubeCell {
  CubeRegion region;
  CubeRegion side;
  std::array<Vec2, 4> outline;  // corners of the cell, pixels
};

// The view cube projected to the screen, under parallel projection.
class ViewCubeGeometry {
 public:
  // half: half the length of the cube's edge, pixels.
  ViewCubeGeometry(const Eigen::Quaterniond& orientation, const Vec2& middle, double half);

  std::vector<CubeCell> cells() const;  // cells of the visible sides
  std::optional<CubeRegion> regionAt(const Vec2& position) const;
  Vec2 toScreen(const Vec3& p) const;  // projects a point of the cube, which extends from -1 to 1

 private:
  Eigen::Quaterniond m_toView;
  Vec2 m_middle;
  double m_half;
};

// Returns the right and up directions of the text on a side.
std::pair<Vec3, Vec3> axesOn(const CubeRegion& side);
// Returns the region that faces the viewer most.
CubeRegion regionFacing(const Eigen::Quaterniond& orientation);
// Returns the region that is reached by steps of 45° around the vertical and upwards. Every region can be reached by
// some steps.
CubeRegion steppedFrom(const CubeRegion& region, int aroundSteps, int upSteps);

}  // namespace handwheel
