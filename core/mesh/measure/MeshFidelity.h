// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "mesh/repair/Repair.h"

namespace handwheel {

// The settings of this module that trade speed for accuracy. Presets follow from resources/fidelity (the test
// FidelityPresetsTest).
FidelitySetting nearWeldSetting();         // mesh.near_weld: RepairOptions::nearWeld
FidelitySetting fillMethodSetting();       // mesh.fill_method: FillOptions::method
FidelitySetting fillContinuitySetting();   // mesh.fill_continuity: FillOptions::continuity
FidelitySetting patchDensitySetting();     // mesh.patch_density: FillOptions::density
FidelitySetting pieceEdgesSetting();       // mesh.piece_edges: FillOptions::pieceEdges
FidelitySetting decimationErrorSetting();  // mesh.decimation_error: DecimationOptions::error, in diagonals
FidelitySetting undoGranularitySetting();  // document.undo_granularity: MeshDelta::between()

// The chosen fill method: one of Ear, Minimal, Refined, Fair, Area, Dihedral, Crease.
FillMethod fillMethodOf(const FidelityValues& values);
Continuity fillContinuityOf(const FidelityValues& values);

// Copies the chosen values into the options of a fill or a repair. Other options stay.
void apply(const FidelityValues& values, FillOptions& options);
void apply(const FidelityValues& values, RepairOptions& options);

}  // namespace handwheel
