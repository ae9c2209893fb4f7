// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"
#include "tools/mesh/MeshServices.h"

namespace handwheel {

// The parameters of a repair by volume.
struct VolumeRepairParameters {
  double voxel = 0.0;  // voxel size, mm; 0: the usual size, or a smaller one if thin walls require it
  double gaps = 0.0;   // size of the gaps, mm, as in VolumeRepairOptions
  double wall = 0.0;   // thickness of walls made of the triangles, mm; 0: the surface encloses the volume
  bool isAgreed =
      false;  // the user agrees that the repair may need more than a quarter of the available memory (consentRefusal())
};

// Replaces a mesh by the surface of the volume that it encloses (repairByVolume()). No face or vertex keeps its index.
MeshChange volumeRepairChange(const VolumeRepairParameters& parameters, NumberType numbers);

// Returns the voxel size (mm) that is used if the usual size is `usual`.
double voxelFor(const VolumeRepairParameters& parameters, double usual);

}  // namespace handwheel
