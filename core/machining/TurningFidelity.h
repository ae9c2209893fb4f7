// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"

namespace handwheel {

// The setting turn.spacing: distance of the samples of a turned profile, mm (TurnedProfile). A workpiece keeps the one
// that it was first cut with.
FidelitySetting turnSpacingSetting();

}  // namespace handwheel
