// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "volume/SurfaceDensity.h"

namespace handwheel {

// The settings of this module that trade speed for accuracy. Presets follow from resources/fidelity (the test
// FidelityPresetsTest).
FidelitySetting volumeVoxelsSetting();     // volume.voxels: number along the largest extent of a part, for usualVoxel()
FidelitySetting volumeMethodSetting();     // volume.method: VoxelMethod
FidelitySetting volumeReductionSetting();  // volume.reduction: VolumeRepairOptions::within, in voxels
FidelitySetting volumePolygonsSetting();   // volume.polygons: surfaceOf() or sharpSurfaceOf()
FidelitySetting volumePiecesSetting();     // volume.pieces: VolumeSurface::pieceCells()
FidelitySetting drillErosionSetting();     // drill.erosion: DrillSetup::erosion

// Returns the chosen method.
VoxelMethod voxelMethodOf(const FidelityValues& values);
// Returns the number of cells for a value of volume.pieces.
int pieceCellsOf(double value);
// Returns the erosion for a value of drill.erosion.
double erosionOf(double value);

}  // namespace handwheel
