// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <optional>
#include <vector>

namespace handwheel {

// A sharp edge or corner of a volume in or beside a cell. A cell lies between eight samples. All lengths are in voxels.
struct SharpFeature {
  struct Plane {
    Vec3 foot;     // point on the surface
    Vec3 inwards;  // unit vector
  };

  Vec3 point;
  std::vector<Plane> planes;  // planes of the surface around the cell
  bool isConvex = true;       // true: the material is the intersection of the half-spaces; false: their union

  // Returns the crossing of the planes with an edge of a cell, as a fraction of the edge from its lower end `from`.
  // isInside: true if the lower end is inside. Returns nothing if the edge crosses no plane.
  std::optional<double> crossing(const VoxelIndex& from, int axis, bool isInside) const;
};

// Returns the point with the least quadratic error from the planes of the surface around a cell (Ju et al., "Dual
// contouring of Hermite data", 2002). The planes are derived from the samples within two voxels: if depths are
// distances, each sample determines the nearest point of the surface, even near an edge, where interpolation fails.
// Returns nothing if the surface is smooth, or if depths are not distances.
std::optional<SharpFeature> featureOf(const SparseVolume& volume, const VoxelIndex& cell);

}  // namespace handwheel
