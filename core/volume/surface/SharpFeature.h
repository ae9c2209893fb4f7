// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <optional>
#include <vector>

namespace handwheel {

// A sharp edge or corner of a volume in or beside a cell. A cell lies between eight samples. In voxels.
struct SharpFeature {
  struct Plane {
    Vec3 foot;     // point on the surface
    Vec3 inwards;  // unit vector
  };

  Vec3 point;
  std::vector<Plane> planes;  // planes of the surface around the cell
  bool isConvex = true;       // true: the intersection of the half-spaces is material; false: their union

  // Returns the crossing of these planes with the edge of a cell, from its lower end along an axis, from 0 to 1.
  // isInside: true if the lower end is inside. None if the edge crosses no plane.
  std::optional<double> crossing(const VoxelIndex& from, int axis, bool isInside) const;
};

// Returns the point with the least quadratic error from the planes of the surface around a cell (Ju et al., "Dual
// contouring of Hermite data", 2002). The planes are those of the samples within two voxels: if depths are distances,
// each sample determines the nearest point of the surface, also near an edge, where an interpolation does not. None if
// the surface is smooth, or if depths are not distances.
std::optional<SharpFeature> featureOf(const SparseVolume& volume, const VoxelIndex& cell);

}  // namespace handwheel
