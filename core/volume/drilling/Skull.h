// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"
#include "volume/VolumeShapes.h"

#include <vector>

namespace handwheel {

// A synthetic skull for exercises of drilling, defined by formulas. It is not taken from a patient: a vault between two
// ellipsoids, the outer and the inner table, with a face, orbits, a nasal opening and the great foramen. It has no
// lower jaw and teeth; the bone between the tables is solid. The origin is the centre of the vault, x to its side, y to
// the face, z up; mm.
//
// The vault is 180 long and 144 wide, and its tables are 6.5 apart on the axes, as those of adults are to a few
// millimetres.
struct Skull {
  static inline const Vec3 kOuter{72.0, 90.0, 66.0};  // half axes of the outer table
  static constexpr double kThickness = 6.5;           // thickness of the vault along its axes
  static inline const Vec3 kInner = kOuter - Vec3::Constant(kThickness);

  // Returns the depth below the surface, negative outside; exact to first order beside the surface.
  static double depthAt(const Vec3& p);
};

// On all threads of the arena; O(area / voxel²).
SparseVolume skullOfVoxels(double voxel);
// Returns the skull of the exercises, with voxels of kSkullVoxel. Made by the first call, which takes half a second.
const SparseVolume& shippedSkull();
inline constexpr double kSkullVoxel = 0.5;  // mm

// Returns the brain of that skull: overlapping balls, a few millimetres inside the inner table.
std::vector<SolidBall> skullBrain();

// The entry and the direction of a burr hole: across the vault in front of the ear and beside the midline, where
// surgeons drill for a drain.
struct SkullSite {
  Vec3 entry;      // on the outer table
  Vec3 direction;  // unit vector, inwards
};
SkullSite skullSite();

}  // namespace handwheel
