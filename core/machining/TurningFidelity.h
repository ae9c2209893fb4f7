// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"

namespace handwheel {

// The setting turn.spacing: distance of the samples of a turned profile, mm (TurnedProfile). A workpiece keeps the
// spacing that it was first cut with.
FidelitySetting turnSpacingSetting();

// The setting turn.method: how a nose cuts (TurningPass::method). Its choices are in the order of TurningMethod.
FidelitySetting turnMethodSetting();

// The setting turn.resolution: distance of the control points that are moved, mm (TurningPass::resolution).
FidelitySetting turnResolutionSetting();

// The setting turn.step: length of a step of the lathe's simulation, ms. Levers and wheels take effect with the next.
FidelitySetting turnStepSetting();

}  // namespace handwheel
