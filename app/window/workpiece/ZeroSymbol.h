// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/path/PathLayer.h"

#include <QString>

namespace handwheel {

// Returns the symbol of a zero on the axis of a lathe, with its name. Arrows show the positive directions. X points
// outward on the side of the tool, and Z away from the chuck. zero: z in the scene, mm; size: radius of the symbol's
// circle, mm. isFromBehind: true if the symbol is seen from behind, see isBehindLathe(). May be called on any thread.
PathLayer::Lines zeroSymbol(double zero, double size, const QString& name, bool isFromBehind);

}  // namespace handwheel
