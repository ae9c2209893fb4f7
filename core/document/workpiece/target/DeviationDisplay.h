// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "document/workpiece/WorkpieceSnapshot.h"

#include <functional>
#include <optional>

namespace handwheel {

// The colour (sRGB, 0…1) for a distance from the target. The distance is in mm, above zero where material is left.
using DeviationColour = std::function<std::array<float, 3>(double)>;

// A workpiece as displayed parts in the colours of its deviation from the target, which it must have. At most some 200
// bands along the axis, each with the colour of its largest distance, inside and outside alike; neighbours of one
// colour are one part, so a colour in steps is shown sooner. It costs the same whatever the number of samples: some
// milliseconds.
DisplayModel deviationDisplay(const WorkpieceSnapshot& workpiece, const DeviationColour& colour);

// The colour for a roughness Ra (µm; infinite: ridges of unknown height); none: it is not known, as of a bar.
using FinishColour = std::function<std::array<float, 3>(std::optional<double>)>;

// A workpiece in the colours of its roughness, in the same bands; each has that of its roughest place, the outside and
// the bore apart.
DisplayModel finishDisplay(const WorkpieceSnapshot& workpiece, const FinishColour& colour);

}  // namespace handwheel
