// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"

namespace handwheel {

// The setting plan.resolution: MotionCheckSettings::resolution, mm.
FidelitySetting planResolutionSetting();

// The setting plan.shortcuts: attempts to make a planned path shorter (RouteSettings::shortcuts).
FidelitySetting planShortcutsSetting();

// The setting verify.step: rad of a joint between the places at which a motion that could not be proven free is looked
// at (verified()).
FidelitySetting verifyStepSetting();

}  // namespace handwheel
