// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"
#include "tools/mesh/MeshServices.h"

namespace handwheel {

// The parameters of a repair by volume.
struct VolumeRepairParameters {
  double voxel = 0.0;     // mm; 0: the usual voxel, or a finer one if walls need it
  double gaps = 0.0;      // mm, as in VolumeRepairOptions
  double wall = 0.0;      // mm, thickness of walls made of the triangles; 0: the surface encloses the volume
  bool isAgreed = false;  // consent that it may need more than a quarter of the memory left (consentRefusal())
};

// Replaces a mesh by the surface of the volume that it encloses (repairByVolume()). No face or vertex keeps its index.
MeshChange volumeRepairChange(const VolumeRepairParameters& parameters, NumberType numbers);

// Returns the voxel that is used if the usual one is `usual`; mm.
double voxelFor(const VolumeRepairParameters& parameters, double usual);

}  // namespace handwheel
