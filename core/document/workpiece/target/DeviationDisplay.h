// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "document/workpiece/WorkpieceSnapshot.h"

#include <functional>
#include <optional>

namespace handwheel {

// Returns the colour (sRGB, 0…1) for a distance from the target. The distance is in mm, above zero where material is
// left.
using DeviationColour = std::function<std::array<float, 3>(double)>;

// Returns a workpiece as displayed parts in the colours of its deviation from the target, which it must have. There are
// at most some 200 bands along the axis, each with the colour of its largest distance, inside and outside alike;
// neighbours of one colour are one part, so a stepped colour scale is drawn faster. The cost is independent of the
// number of samples: some milliseconds.
DisplayModel deviationDisplay(const WorkpieceSnapshot& workpiece, const DeviationColour& colour);

// Returns the colour for a roughness Ra (µm; infinite: ridges of unknown height). None: the roughness is unknown, as
// that of a bar.
using FinishColour = std::function<std::array<float, 3>(std::optional<double>)>;

// Returns a workpiece in the colours of its roughness, in the same bands. Each band has the colour of its largest
// roughness, the outside and the bore apart.
DisplayModel finishDisplay(const WorkpieceSnapshot& workpiece, const FinishColour& colour);

}  // namespace handwheel
