// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"
#include "tools/mesh/MeshServices.h"

namespace handwheel {

// Replaces a mesh by the surface of the volume that it encloses (repairByVolume()). No face or vertex keeps its index.
// voxel: mm; 0: the usual one. gaps: mm, as VolumeRepairOptions has it.
MeshChange volumeRepairChange(double voxel, double gaps, NumberType numbers);

}  // namespace handwheel
