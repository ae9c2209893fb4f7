// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"
#include "volume/VolumeShapes.h"

#include <vector>

namespace handwheel {

// A synthetic skull for exercises of drilling, defined by formulas. It is not taken from a patient. It consists of a
// vault between two ellipsoids, the outer and the inner table, with a face, orbits, a nasal opening and the great
// foramen. It has no lower jaw and no teeth; the bone between the tables is solid. The origin is the centre of the
// vault. Coordinates are those of a patient, as in ImageGrid: x to the left, y to the back, z upwards, so the face
// looks along -y. Lengths are in mm.
//
// The vault is 180 mm long and 144 mm wide, and its tables are 6.5 mm apart on the axes. Adult skulls have these sizes
// to a few millimetres.
struct Skull {
  static inline const Vec3 kOuter{72.0, 90.0, 66.0};  // half axes of the outer table
  static constexpr double kThickness = 6.5;           // thickness of the vault along its axes
  static inline const Vec3 kInner = kOuter - Vec3::Constant(kThickness);

  // Returns the depth below the surface, negative outside. It is exact to first order near the surface.
  static double depthAt(const Vec3& p);
};

// Returns the skull as a volume. voxel: size of a voxel, mm. Runs on all threads of the arena; O(area / voxel²).
SparseVolume skullOfVoxels(double voxel);
// Returns the skull of the exercises, with voxels of kSkullVoxel. The first call makes it, which takes half a second.
const SparseVolume& shippedSkull();
inline constexpr double kSkullVoxel = 0.5;  // mm

// Returns the brain of the skull: overlapping balls, a few millimetres inside the inner table.
std::vector<SolidBall> skullBrain();

// The entry and the direction of a burr hole. The hole crosses the vault in front of the ear and beside the midline,
// where surgeons drill for a drain.
struct SkullSite {
  Vec3 entry;      // position on the outer table
  Vec3 direction;  // unit vector, inwards
};
SkullSite skullSite();

}  // namespace handwheel
