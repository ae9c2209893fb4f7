// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"

namespace handwheel {

// Returns the setting snap.radius: snap distance, in mean distances between neighbouring features. If small, features
// are hard to hit; if large, the one held last is hard to leave.
FidelitySetting snapRadiusSetting();

// Returns the setting snap.features: number of features that act at once in SnapSum.
FidelitySetting snapFeaturesSetting();

}  // namespace handwheel
