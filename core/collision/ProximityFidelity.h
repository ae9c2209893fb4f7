// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"

namespace handwheel {

// The setting proximity.tolerance, the error allowed to nearest points (ProximityQuery::setTolerance()). In mm: that
// much further away than the nearest may be what is found.
FidelitySetting proximityToleranceSetting();

}  // namespace handwheel
