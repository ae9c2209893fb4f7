// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"

namespace handwheel {

// snap.radius: the snap distance, in mean distances between neighbouring features. Small, it is hard to hit; large,
// what was held last is hard to leave.
FidelitySetting snapRadiusSetting();

// snap.features: how many features pull at once where forces are summed (SnapSum).
FidelitySetting snapFeaturesSetting();

}  // namespace handwheel
