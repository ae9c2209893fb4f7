// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <optional>
#include <vector>

namespace handwheel {

// A sharp edge or corner of a volume in or beside a cell. A cell is between eight samples. In voxels.
struct SharpFeature {
  struct Plane {
    Vec3 foot;     // on the surface
    Vec3 inwards;  // of length 1
  };

  Vec3 point;
  std::vector<Plane> planes;  // of the surface around
  bool isConvex = true;       // material is within all of the planes, else within any

  // Where an edge of a cell, from its lower end along an axis, passes the surface by these planes: as a share of it.
  // isInside: of the lower end. None where it passes none of them.
  std::optional<double> crossing(const VoxelIndex& from, int axis, bool isInside) const;
};

// The place that is nearest to the planes of the surface around a cell, by the quadratic error (Ju et al., "Dual
// contouring of Hermite data", 2002). The planes are those of the samples within two voxels: where depths are distances
// each sample knows the nearest place of the surface, also where the mean of two samples beside an edge does not. None
// where the surface is smooth, or where depths are no distances.
std::optional<SharpFeature> featureOf(const SparseVolume& volume, const VoxelIndex& cell);

}  // namespace handwheel
