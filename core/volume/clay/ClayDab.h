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
  Add,      // a ball of material
  Carve,    // takes a ball of material away
  Inflate,  // the surface grows outwards; with a strength below 0 it shrinks
  Smooth,   // each depth becomes the mean of those around it
  Flatten,  // towards the plane of the surface around, from both sides
  Move,     // material goes along with the tool
  Smudge,   // the surface is drawn out along itself: the tool takes it along and smooths it, whatever the strength's
            // sign
  Attract,  // material goes towards the middle of the tool; with a strength below 0 away from it
  Pinch,    // towards the line through the middle of the tool along its direction; below 0 away from it
  Mask,     // protects what is there, ClayMask::paint(); below 0 frees it. No volume is changed.
};

class ClayMask;
class ClayStamp;

// A touch of a clay tool.
struct ClayDab {
  ClayAction action = ClayAction::Carve;
  Vec3 centre = Vec3::Zero();  // mm
  double radius = 5.0;         // mm
  double strength = 1.0;       // -1 to 1, a share of what the action can do at most; not of balls
  double falloff = 1.0;        // 0: the same within the radius; 1: smoothly less towards it; not of balls and stamps
  // mm. Add, Carve, Mask: where the tool comes from; the ball is swept along it. Move, Smudge: where it goes, at most a
  // quarter of the radius of it counts; of Smudge what of it is across the direction.
  Vec3 way = Vec3::Zero();
  Vec3 direction = Vec3::UnitZ();  // of Pinch; of Smudge and of a stamp out of the material; of length 1
  // Add, Carve: the surface goes out or in along the direction, by the heights of the stamp. Those of 1 are
  // kStampHeight of the radius at full strength. The stamp lies in the square within the circle of the radius. Null: a
  // ball.
  std::shared_ptr<const ClayStamp> stamp = nullptr;
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitY();  // of the stamp, of length 1, across the direction

  bool isBall() const { return !stamp && (action == ClayAction::Add || action == ClayAction::Carve); }

  static constexpr double kMostVoxels = 500.0;  // of a radius
  static constexpr double kMostRadii = 4.0;     // of the way of Add and Carve
  static constexpr double kStampHeight = 0.25;
};

// Applies a dab. Returns the blocks whose content changed, in an order that depends on the arguments alone. On all
// threads of the arena; O(voxels near the surface within the radius). Nothing happens where the dab is not finite,
// its radius is not above 0 or more than kMostVoxels voxels, or a ball is swept further than kMostRadii.
//
// Add and Carve unite balls and subtract them exactly; the others leave depths that are distances again near the
// surface (to first order, as by Sethian's fast marching, 1996), so that dabs may follow one another without end.
//
// mask: what it protects is changed less by the share that it is protected by, and not at all where that is 1: the
// balls of Add and Carve lose that share of their radius and of four voxels there. Null, or in another grid: nothing
// is protected.
std::vector<VoxelIndex> applyDab(SparseVolume& volume, const ClayDab& dab, const ClayMask* mask = nullptr);

// The same dab on the other side of a plane through a point, across an axis (0 to 2).
ClayDab mirrored(const ClayDab& dab, const Vec3& point, int axis);

}  // namespace handwheel
