// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"

namespace handwheel {

// Returns the setting proximity.tolerance, the error of nearest points (ProximityQuery::setTolerance()), mm. The result
// may be that much further away than the nearest point.
FidelitySetting proximityToleranceSetting();

}  // namespace handwheel
