// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "volume/SparseVolume.h"

#include <memory>
#include <vector>

namespace handwheel {

// The actions of a clay tool on the material within its radius.
enum class ClayAction {
  Add,      // adds a ball of material
  Carve,    // removes a ball of material
  Inflate,  // grows the surface; with a negative strength shrinks it
  Smooth,   // replaces each depth by the mean of those around it
  Flatten,  // moves the surface towards its mean plane, from both sides
  Move,     // moves material along with the tool
  Smudge,   // drags the surface along itself and smooths it, for either sign of the strength
  Attract,  // moves material towards the centre of the tool; with a negative strength away from it
  Pinch,    // moves material towards the axis of the tool; with a negative strength away from it
  Mask,     // protects material by ClayMask::paint(), with a negative strength frees it; the volume is unchanged
};

class ClayMask;
class ClayStamp;

// A single application of a clay tool.
struct ClayDab {
  ClayAction action = ClayAction::Carve;
  Vec3 centre = Vec3::Zero();  // mm
  double radius = 5.0;         // mm
  double strength = 1.0;       // -1 to 1, fraction of the action's largest effect; not used for balls of material
  double falloff = 1.0;        // 0: uniform within the radius; 1: fades out smoothly; not used for balls and stamps
  // Displacement, mm. For Add, Carve and Mask, it is the move by which the tool arrived at the centre; the ball is
  // swept along it. For Move and Smudge, it is the move that follows, limited to a quarter of the radius; Smudge uses
  // only its component across the direction.
  Vec3 displacement = Vec3::Zero();
  Vec3 direction = Vec3::UnitZ();  // unit vector: axis of Pinch; for Smudge and stamps, it points out of the material
  // Stamp of Add and Carve: the surface is moved outwards or inwards along the direction by the heights of the stamp. A
  // height of 1 is kStampHeight times the radius at full strength. The stamp fills the square inscribed in the circle
  // of the radius. Null: a ball.
  std::shared_ptr<const ClayStamp> stamp = nullptr;
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitY();  // axes of the stamp, unit vectors across the direction

  bool isBall() const { return !stamp && (action == ClayAction::Add || action == ClayAction::Carve); }

  static constexpr double kMostVoxels = 500.0;  // largest radius, in voxels
  static constexpr double kMostRadii = 4.0;     // largest displacement of Add and Carve, in radii
  static constexpr double kStampHeight = 0.25;
};

// Applies a dab. Returns the blocks that changed, in an order that depends only on the arguments. Runs on all threads
// of the arena; O(voxels near the surface within the radius). Nothing happens if the dab is not finite, if its radius
// is not above 0 or more than kMostVoxels voxels, or if a ball is swept further than kMostRadii.
//
// Add and Carve unite and subtract balls exactly. After the other actions, the depths near the surface are restored to
// distances (of first order, by fast marching, Sethian 1996), so that any number of dabs may follow one another.
//
// mask: the change is reduced by the protected fraction; where the fraction is 1, nothing changes. For Add
// and Carve, the radius of the ball is reduced by this fraction of the sum of radius and four voxels. Null, or a mask
// in another grid: nothing is protected.
std::vector<VoxelIndex> applyDab(SparseVolume& volume, const ClayDab& dab, const ClayMask* mask = nullptr);

// Returns the dab mirrored at the plane through a point and perpendicular to an axis (0 to 2).
ClayDab mirrored(const ClayDab& dab, const Vec3& point, int axis);

}  // namespace handwheel
