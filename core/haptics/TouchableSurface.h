// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/ContactSurface.h"

namespace handwheel {

// A surface that is fit to be touched by a point: its seams are closed. points, triangles: welded, equal points have
// one number. faces: by which numbers the triangles are known to who edits them; empty: their places. Empty once
// cancelled. O(n log n).
ContactSurface touchableSurface(std::vector<Vec3> points, std::vector<Triangle> triangles,
                                std::span<const std::uint32_t> faces, Progress progress = {});

// The number of a face in such a surface, for ContactSurface::update(). A seam stays as it was closed at first: what an
// edit leaves of it is no wider than a seam.
constexpr std::uint32_t touchableNumber(std::uint32_t face) {
  return 2 * face;  // the odd ones are those of the strips in seams
}

}  // namespace handwheel
