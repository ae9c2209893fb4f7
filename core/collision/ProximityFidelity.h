// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"

namespace handwheel {

// Returns the setting proximity.tolerance: the largest error of closest points between meshes, mm
// (ProximityQuery::setTolerance()).
FidelitySetting proximityToleranceSetting();

}  // namespace handwheel
