// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/CameraNavigation.h"

#include <optional>

namespace handwheel {

// A side, edge or corner of the view cube: the direction from which it is seen, each coordinate -1, 0 or 1. The sides
// have one coordinate that is not zero, the edges two, the corners three.
using CubeRegion = Eigen::Vector3i;

// A ninth of a side that shows: its middle belongs to the side, the strips and squares around it to edges and corners.
struct CubeCell {
  CubeRegion region;
  CubeRegion side;
  std::array<Vec2, 4> outline;  // pixels
};

// The cube as it appears in a square of pixels, under parallel projection.
class ViewCubeGeometry {
 public:
  // half: half of the cube's edge.
  ViewCubeGeometry(const Eigen::Quaterniond& orientation, const Vec2& middle, double half);

  std::vector<CubeCell> cells() const;  // of the sides that show
  std::optional<CubeRegion> regionAt(const Vec2& position) const;
  Vec2 toScreen(const Vec3& p) const;  // the cube reaches from -1 to 1

 private:
  Eigen::Quaterniond m_toView;
  Vec2 m_middle;
  double m_half;
};

// Right and up on a side, as text stands on it.
std::pair<Vec3, Vec3> axesOn(const CubeRegion& side);
// The region that faces the viewer most.
CubeRegion regionFacing(const Eigen::Quaterniond& orientation);
// The next region by steps of 45° around the vertical and up; so every region can be reached.
CubeRegion steppedFrom(const CubeRegion& region, int aroundSteps, int upSteps);

}  // namespace handwheel
