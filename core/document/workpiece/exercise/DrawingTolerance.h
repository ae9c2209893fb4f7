// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "exercise/Exercise.h"

namespace handwheel {

// Sets the limits of a criterion from its tolerance on the drawing. Sizes can have a class of ISO 286 ("h10") around
// the nominal size, roughness a grade of ISO 1302 ("N7"), and any figure a symmetric tolerance ("±0.2"). Error
// ElementMalformed {criterion, what is wrong}: the tolerance is not known for this figure and size, or the nominal size
// is missing.
Status applyDrawingTolerance(MarkingCriterion& criterion);

}  // namespace handwheel
