// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"
#include "machining/target/TargetProfile.h"
#include "nurbs/ProfileCurve.h"

namespace handwheel {

// Returns the half section of a sampled turned part as lines and arcs. The first sample of the part is at z = 0. The
// section is within the tolerance (mm, > 0) of the samples. A corner between two samples is the intersection of the
// surfaces beside it. A shoulder between two samples is halfway between them, unless the arc beside it determines its
// position; the same applies to a face of a bored part. The part must be in one piece. O(samples log samples). Errors:
// the errors of TargetProfile::make().
Result<TargetProfile> sectionOf(const TurnedProfile& part, double tolerance);

// Returns the half section of a solid part whose surface is a curve from the lower end to the upper end. Lines and arcs
// are fitted to the curve within the tolerance (mm).
Result<TargetProfile> sectionOf(const ProfileCurve& curve, double tolerance);

// Returns the sampled profile, at this spacing (mm), of a part that has exactly the shape of a target. The lower end of
// the part is at z = 0.
TurnedProfile sampled(const TargetProfile& target, double spacing);

}  // namespace handwheel
