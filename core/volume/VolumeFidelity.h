// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "volume/SurfaceDensity.h"

namespace handwheel {

// The settings of this module that trade speed for accuracy. Presets follow from resources/fidelity (the test
// FidelityPresetsTest).
FidelitySetting volumeVoxelsSetting();     // volume.voxels: along the largest extent of a part, of usualVoxel()
FidelitySetting volumeMethodSetting();     // volume.method: VoxelMethod
FidelitySetting volumeReductionSetting();  // volume.reduction: VolumeRepairOptions::within, in voxels
FidelitySetting volumePolygonsSetting();   // volume.polygons: surfaceOf() or sharpSurfaceOf()
FidelitySetting volumePiecesSetting();     // volume.pieces: VolumeSurface::pieceCells()
FidelitySetting drillErosionSetting();     // drill.erosion: DrillSetup::erosion

// The chosen method.
VoxelMethod voxelMethodOf(const FidelityValues& values);
// The cells that a value of volume.pieces stands for.
int pieceCellsOf(double value);
// The erosion that a value of drill.erosion stands for.
double erosionOf(double value);

}  // namespace handwheel
