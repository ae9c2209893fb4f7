// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "MeshShapes.h"
#include "volume/SurfaceToVolume.h"
#include "volume/clay/ClayDab.h"

#include <cmath>

namespace handwheel::test {

inline double ballVolume(double radius) {
  return 4.0 / 3.0 * M_PI * radius * radius * radius;
}

// Returns the volume of a cube and all points within a distance (Steiner's formula).
inline double roundedCubeVolume(double side, double distance) {
  return side * side * side + 6.0 * side * side * distance + 3.0 * M_PI * side * distance * distance +
         ballVolume(distance);
}

// Returns the union of a volume and a ball.
inline SparseVolume withBall(SparseVolume volume, const Vec3& centre, double radius) {
  ClayDab dab;
  dab.action = ClayAction::Add;
  dab.centre = centre;
  dab.radius = radius;
  applyDab(volume, dab);
  return volume;
}

// Returns a box in a grid whose voxel (0, 0, 0) is at the origin.
inline SparseVolume boxOfVoxels(const Vec3& size, const Vec3& corner, double voxel) {
  return volumeOfSurface(box(corner, size), voxel, {}, Vec3(Vec3::Zero()))->volume;
}

}  // namespace handwheel::test
