// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"
#include "machining/target/TargetProfile.h"
#include "nurbs/ProfileCurve.h"

namespace handwheel {

// Returns the half section of a sampled turned part as lines and arcs. Its first sample is at z = 0. It is within the
// tolerance (mm, > 0) of the samples. A corner between two samples is the intersection of the surfaces beside it, and a
// shoulder between two samples is halfway, unless the arc beside it determines it; so is a face of a bored part.
// Material that was cut in two is not represented: only the region between the axis and the samples. O(samples log
// samples). Errors: those of TargetProfile::make().
Result<TargetProfile> sectionOf(const TurnedProfile& part, double tolerance);

// The same for the piece at the free end of a part that was parted off: the material behind it is left out. It keeps
// its position, above z = 0.
Result<TargetProfile> sectionOfEndPiece(const TurnedProfile& part, double tolerance);

// The same for a curve from the lower end of a solid part to the upper. Its lines and arcs are found.
Result<TargetProfile> sectionOf(const ProfileCurve& curve, double tolerance);

// Returns the samples of a target at this spacing (mm): a part that was turned exactly. Its lower end is at z = 0.
TurnedProfile sampled(const TargetProfile& target, double spacing);

}  // namespace handwheel
