// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"

namespace handwheel {

// Returns the setting ik.tolerance. It sets NumericalIkSettings::tolerance, for lengths in metres and angles in rad.
FidelitySetting ikToleranceSetting();

}  // namespace handwheel
