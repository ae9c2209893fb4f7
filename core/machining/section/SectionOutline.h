// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/refit/Refit.h"
#include "machining/section/TurnedSection.h"
#include "machining/target/TargetProfile.h"

namespace handwheel {

// Returns the half section of one piece of a part as lines and arcs. They are moved by `base` (mm) along z. Segments of
// several passes on one line or circle are one. Runs of short segments, which are the marks of a hand, are joined to
// lines and arcs within `tolerance` (mm, > 0). Within a fifth of it, specks are left out and lines that are nearly one
// are joined; all others are exact. The piece must have no hollows. Errors: the errors
// of TargetProfile::make().
Result<TargetProfile> outlineOf(const TurnedSection& piece, double tolerance, double base);

// Returns the rational curves of degree 2 of one piece of a part, joined in the same manner. Errors: those of
// ProfileCurve.
Result<TurnedCurves> curvesOf(const TurnedSection& piece, double tolerance, double base);

}  // namespace handwheel
