// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"

namespace handwheel {

// Returns the setting snap.radius: the snap distance. Its unit is the mean distance between neighbouring features. With
// a small radius, features are hard to hit; with a large radius, the held feature is hard to leave.
FidelitySetting snapRadiusSetting();

// Returns the setting snap.features: the number of features that act at once in SnapSum.
FidelitySetting snapFeaturesSetting();

}  // namespace handwheel
