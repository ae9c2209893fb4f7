// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"

namespace handwheel {

// Returns the setting plan.resolution: MotionCheckSettings::resolution, mm.
FidelitySetting planResolutionSetting();

// Returns the setting plan.shortcuts: number of attempts to shorten a planned path (RouteSettings::shortcuts).
FidelitySetting planShortcutsSetting();

// Returns the setting verify.step: rad of a joint between the samples of a motion that could not be proven free
// (verified()).
FidelitySetting verifyStepSetting();

}  // namespace handwheel
