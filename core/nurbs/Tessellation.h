// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "mesh/structure/TriangleSoup.h"
#include "nurbs/ProfileCurve.h"
#include "nurbs/TessellationOptions.h"

namespace handwheel {

// Tessellates a turned part into a closed triangle mesh that faces outwards. The part lies between the profile, the
// flat ends through its first and last point, and the axis, or within a closed profile; neighbouring triangles share
// vertices. If the profile is curved, half of the tolerance is for the profile and half for the circles around the
// axis. Vertices between the ends of a chord of the profile may then be off the surface by half of the tolerance.
// O(triangles). Errors: ValueOutOfRange {"chord tolerance", value, least for this part, largest}, FileTooLarge if no
// tolerance is coarse enough, ElementMalformed {profile}, Cancelled.
Result<TriangleSoup> tessellate(const ProfileCurve& profile, const TessellationOptions& options,
                                Progress progress = {});

}  // namespace handwheel
