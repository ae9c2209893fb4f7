// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"

namespace handwheel {

FidelitySetting stepChordSetting();  // step.chord: ReadOptions::stepChord, as a fraction of the diagonal

}  // namespace handwheel
