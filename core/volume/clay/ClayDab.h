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
  Move,     // moves material with the tool
  Smudge,   // drags the surface along itself and smooths it, for either sign of the strength
  Attract,  // moves material towards the centre of the tool; with a negative strength away from it
  Pinch,    // moves material towards the axis of the tool; with a negative strength away from it
  Mask,     // protects material, ClayMask::paint(); with a negative strength frees it. The volume is unchanged.
};

class ClayMask;
class ClayStamp;

// A single application of a clay tool.
struct ClayDab {
  ClayAction action = ClayAction::Carve;
  Vec3 centre = Vec3::Zero();  // mm
  double radius = 5.0;         // mm
  double strength = 1.0;       // -1 to 1, fraction of the action's largest effect; not used for balls
  double falloff = 1.0;        // 0: uniform within the radius; 1: fades out smoothly; not used for balls and stamps
  // mm. Add, Carve, Mask: the displacement by which the tool arrived at the centre; the ball is swept along it. Move,
  // Smudge: the displacement that follows, limited to a quarter of the radius; Smudge uses its component across the
  // direction.
  Vec3 displacement = Vec3::Zero();
  Vec3 direction = Vec3::UnitZ();  // unit vector: axis of Pinch; for Smudge and stamps out of the material
  // Add, Carve: the surface is moved outwards or inwards along the direction by the heights of the stamp. A height of 1
  // is kStampHeight times the radius at full strength. The stamp lies in the square inscribed in the circle of the
  // radius. Null: a ball.
  std::shared_ptr<const ClayStamp> stamp = nullptr;
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitY();  // axes of the stamp, unit vectors across the direction

  bool isBall() const { return !stamp && (action == ClayAction::Add || action == ClayAction::Carve); }

  static constexpr double kMostVoxels = 500.0;  // limit of the radius
  static constexpr double kMostRadii = 4.0;     // limit of the displacement of Add and Carve, in radii
  static constexpr double kStampHeight = 0.25;
};

// Applies a dab. Returns the blocks whose content changed, in an order that depends on the arguments alone. On all
// threads of the arena; O(voxels near the surface within the radius). Nothing happens if the dab is not finite, its
// radius is not above 0 or more than kMostVoxels voxels, or a ball is swept further than kMostRadii.
//
// Add and Carve unite and subtract balls exactly; after the other actions the depths near the surface are distances
// again (of first order, by Sethian's fast marching, 1996), so that any number of dabs may follow one another.
//
// mask: the change is reduced by the protected fraction, to nothing where it is 1: there the balls of Add and Carve
// lose that fraction of their radius and of four voxels. Null, or in another grid: nothing is protected.
std::vector<VoxelIndex> applyDab(SparseVolume& volume, const ClayDab& dab, const ClayMask* mask = nullptr);

// Returns the dab mirrored at the plane through a point that is perpendicular to an axis (0 to 2).
ClayDab mirrored(const ClayDab& dab, const Vec3& point, int axis);

}  // namespace handwheel
