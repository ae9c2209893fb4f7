// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "document/workpiece/WorkpieceSnapshot.h"

#include <functional>

namespace handwheel {

// The colour (sRGB, 0…1) for a distance from the target (mm, above zero where material is left).
using DeviationColour = std::function<std::array<float, 3>(double)>;

// A workpiece as displayed parts in the colours of its deviation from the target, which it must have. At most some 200
// bands along the axis, each with the colour of its largest distance, inside and outside alike. It costs the same
// whatever the number of samples: some milliseconds.
DisplayModel deviationDisplay(const WorkpieceSnapshot& workpiece, const DeviationColour& colour);

}  // namespace handwheel
