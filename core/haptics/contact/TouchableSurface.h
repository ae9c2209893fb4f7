// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/ContactSurface.h"

namespace handwheel {

// Creates a contact surface from a mesh, with its gaps closed (closeContactGaps()). points, triangles: welded, equal
// points have the same index. faces: the ids by which an editor knows the triangles; empty: their indices. Empty if
// cancelled. O(n log n).
ContactSurface touchableSurface(std::vector<Vec3> points, std::vector<Triangle> triangles,
                                std::span<const std::uint32_t> faces, Progress progress = {});

// Returns the id of a face in such a surface, for ContactSurface::update(). A gap keeps its first closing: what an edit
// leaves of it is no wider than a gap.
constexpr std::uint32_t touchableNumber(std::uint32_t face) {
  return 2 * face;  // odd ids are those of the strips in gaps
}

}  // namespace handwheel
