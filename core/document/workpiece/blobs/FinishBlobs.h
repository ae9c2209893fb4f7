// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "machining/finish/SurfaceFinish.h"

namespace handwheel {

// Writes the surface finish of a profile into a container. The blobs "workpiece/finish/NNNN" hold roughness, feed and
// pass of each sample of the outside, then of each sample of a bore.
void writeFinish(const SurfaceFinish& finish, const TurnedProfile& profile, Container& container);

// Reads the surface finish; accepts any input. Lost or invalid values become unknown and are no damage, since the
// finish is not part of the shape. passes: number of passes of the part.
SurfaceFinish readFinish(const Container& container, const TurnedProfile& profile, std::size_t passes);

}  // namespace handwheel
