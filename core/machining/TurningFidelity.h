// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"

namespace handwheel {

// Returns the setting turn.spacing, the distance of the samples of a turned profile, mm (TurnedProfile). A workpiece
// keeps the spacing of its first cut.
FidelitySetting turnSpacingSetting();

// Returns the setting turn.method, the method by which a nose cuts (TurningPass::method). Its choices are in the order
// of TurningMethod.
FidelitySetting turnMethodSetting();

// Returns the setting turn.resolution, the distance of the control points that are moved, mm (TurningPass::resolution).
FidelitySetting turnResolutionSetting();

// Returns the setting turn.step, the length of a step of the lathe's simulation, ms. Levers and wheels take effect with
// the next step.
FidelitySetting turnStepSetting();

}  // namespace handwheel
