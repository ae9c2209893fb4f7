// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"
#include "tools/mesh/MeshServices.h"

namespace handwheel {

// The parameters of a repair by volume.
struct VolumeRepairParameters {
  double voxel = 0.0;     // mm; 0: the usual one, or finer where walls need it
  double gaps = 0.0;      // mm, as VolumeRepairOptions has it
  double wall = 0.0;      // mm, of walls that are made of the triangles; 0: the surface encloses the volume
  bool isAgreed = false;  // that it may need more than a quarter of the memory that is left (consentRefusal())
};

// Replaces a mesh by the surface of the volume that it encloses (repairByVolume()). No face or vertex keeps its index.
MeshChange volumeRepairChange(const VolumeRepairParameters& parameters, NumberType numbers);

// The voxel that is used where this is the usual one; mm.
double voxelFor(const VolumeRepairParameters& parameters, double usual);

}  // namespace handwheel
