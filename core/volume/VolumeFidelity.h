// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "volume/SurfaceDensity.h"

namespace handwheel {

// The settings of this module that trade speed for accuracy. Their presets follow from measurements in
// resources/fidelity (see the test FidelityPresetsTest).
FidelitySetting volumeVoxelsSetting();     // volume.voxels: usualVoxel()'s number of voxels along the largest extent
FidelitySetting volumeMethodSetting();     // volume.method: VoxelMethod
FidelitySetting volumeReductionSetting();  // volume.reduction: VolumeRepairOptions::within, in voxels
FidelitySetting volumePolygonsSetting();   // volume.polygons: surfaceOf() or sharpSurfaceOf()
FidelitySetting volumePiecesSetting();     // volume.pieces: VolumeSurface::pieceCells()
FidelitySetting drillErosionSetting();     // drill.erosion: DrillSetup::erosion

// Returns the voxel method that the values select.
VoxelMethod voxelMethodOf(const FidelityValues& values);
// Returns the number of cells per piece for a value of volume.pieces.
int pieceCellsOf(double value);
// Returns the erosion (DrillSetup::erosion) for a value of drill.erosion.
double erosionOf(double value);

}  // namespace handwheel
