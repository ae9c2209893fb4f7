// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"
#include "machining/target/TargetProfile.h"
#include "nurbs/ProfileCurve.h"

namespace handwheel {

// The half section of a sampled turned part as lines and arcs. Its first sample is at z = 0. It is within the
// tolerance (mm, > 0) of the samples. Corners between two samples are where the surfaces beside them meet, and a
// shoulder between two is half way, unless the arc beside it tells; so is a face of a bored part. Material that was cut
// in two is not represented: only what lies between the axis and the samples. O(samples log samples). Errors: those of
// TargetProfile::make().
Result<TargetProfile> sectionOf(const TurnedProfile& part, double tolerance);

// The same of the piece at the free end of a part that was parted off: what is behind it is left over. It keeps its
// place, above z = 0.
Result<TargetProfile> sectionOfEndPiece(const TurnedProfile& part, double tolerance);

// The same of a curve from the lower end of a solid part to the upper. Its lines and arcs are found.
Result<TargetProfile> sectionOf(const ProfileCurve& curve, double tolerance);

// The samples of a target at this spacing (mm): a part that was turned exactly. Its lower end is at z = 0.
TurnedProfile sampled(const TargetProfile& target, double spacing);

}  // namespace handwheel
