// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "mesh/repair/Repair.h"

namespace handwheel {

// The settings of this module that trade speed for accuracy. Their presets follow from resources/fidelity (verified by
// FidelityPresetsTest).
FidelitySetting nearWeldSetting();         // mesh.near_weld, for RepairOptions::nearWeld
FidelitySetting fillMethodSetting();       // mesh.fill_method, for FillOptions::method
FidelitySetting fillContinuitySetting();   // mesh.fill_continuity, for FillOptions::continuity
FidelitySetting patchDensitySetting();     // mesh.patch_density, for FillOptions::density
FidelitySetting pieceEdgesSetting();       // mesh.piece_edges, for FillOptions::pieceEdges
FidelitySetting decimationErrorSetting();  // mesh.decimation_error, for DecimationOptions::error; share of the diagonal
FidelitySetting undoGranularitySetting();  // document.undo_granularity, for MeshDelta::between()

// Returns the chosen fill method: Ear, Minimal, Refined, Fair, Area, Dihedral or Crease.
FillMethod fillMethodOf(const FidelityValues& values);
void setMethod(FidelityValues& values, FillMethod method);
Continuity fillContinuityOf(const FidelityValues& values);

// Copies the chosen values into the options of a fill or a repair. Other options are unchanged.
void apply(const FidelityValues& values, FillOptions& options);
void apply(const FidelityValues& values, RepairOptions& options);

}  // namespace handwheel
