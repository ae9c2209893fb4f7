// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleContext.h"
#include "mesh/holes/Patch.h"

#include <utility>

namespace handwheel {

// A point of the surface that a patch replaces, with the normal there. It is the centre of a crumb in the hole.
struct PatchGuide {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
};

// Returns the points of a faired patch through which the guides want it to pass, as the index of a point inside the
// patch and its new position. A guide counts if it is within a fifth of the hole's size of the patch, looks the same
// direction, and the guides around it agree: a stray crumb does not pull the patch. O((guides + points) log points).
std::vector<std::pair<std::uint32_t, Vec3>> guidedPoints(const HoleContext& hole, const Patch& patch,
                                                         const std::vector<PatchGuide>& guides);

}  // namespace handwheel
