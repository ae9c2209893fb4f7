// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"

namespace handwheel {

// The setting proximity.tolerance: mm that what is found near may be further away than what is nearest
// (ProximityQuery::setTolerance()).
FidelitySetting proximityToleranceSetting();

}  // namespace handwheel
