// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "exercise/Exercise.h"

#include <optional>

namespace handwheel {

// Sets the limits of a criterion from its tolerance on the drawing. Sizes can have a class of ISO 286 ("h10") around
// the nominal size, roughness a grade of ISO 1302 ("N7"), the figures of a thread its designation with a
// class of ISO 965-1 ("M20×2.5-6g"), which sets the nominal size, too, and any figure a symmetric tolerance ("±0.2").
// Error ElementMalformed {criterion, what is wrong}: the tolerance is not known for this figure and size, or the
// nominal size is missing.
Status applyDrawingTolerance(MarkingCriterion& criterion);

// Returns the nominal size of a criterion, or the middle of its limits.
std::optional<double> drawnSizeOf(const MarkingCriterion& criterion);

// Returns true if a criterion measures a figure of a thread.
bool isOfThread(const MarkingCriterion& criterion);

// Returns true if the tolerance of a criterion is the designation of a thread, and the other criterion measures the
// same thread: it has limits for all its figures.
bool sharesThreadTolerance(const MarkingCriterion& criterion, const MarkingCriterion& other);

}  // namespace handwheel
