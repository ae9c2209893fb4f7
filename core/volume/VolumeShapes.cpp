// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeShapes.h"

#include "volume/clay/ClayDab.h"

namespace handwheel {

SparseVolume ballOfVoxels(double radius, double voxel) {
  SparseVolume ball(Vec3::Zero(), voxel);
  ClayDab dab;
  dab.action = ClayAction::Add;
  dab.radius = radius;
  applyDab(ball, dab);
  return ball;
}

}  // namespace handwheel
