// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "document/workpiece/WorkpieceSnapshot.h"

#include <functional>
#include <optional>

namespace handwheel {

// A function that returns the colour (sRGB, 0…1) for a distance from the target, mm. The distance is above zero where
// material is left.
using DeviationColour = std::function<std::array<float, 3>(double)>;

// Returns a workpiece as displayed parts in the colours of its deviation from the target, which it must have. There are
// at most some 200 bands along the axis, each with the colour of its largest distance, inside and outside alike.
// Neighbouring bands of one colour form one part, so a stepped colour scale is drawn faster. The call takes some
// milliseconds, whatever the number of samples.
DisplayModel deviationDisplay(const WorkpieceSnapshot& workpiece, const DeviationColour& colour);

// A function that returns the colour for a roughness Ra (µm; infinite: ridges of unknown height; none: unknown
// roughness, as of a bar).
using FinishColour = std::function<std::array<float, 3>(std::optional<double>)>;

// Returns a workpiece in the colours of its roughness, in the bands of deviationDisplay(). Each band has the colour of
// its largest roughness, separately for the outside and the bore.
DisplayModel finishDisplay(const WorkpieceSnapshot& workpiece, const FinishColour& colour);

}  // namespace handwheel
