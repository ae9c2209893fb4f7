// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/ContactSurface.h"

namespace handwheel {

// Creates a contact surface from a mesh, with its gaps closed (closeContactGaps()). points, triangles: the mesh, in
// which equal points must have the same index. faces: the ids by which an editor identifies the triangles; empty: the
// ids are the indices. The result is empty if cancelled. O(n log n).
ContactSurface touchableSurface(std::vector<Vec3> points, std::vector<Triangle> triangles,
                                std::span<const std::uint32_t> faces, Progress progress = {});

// Returns the id of a face in the surface that touchableSurface() returns, for ContactSurface::update(). The triangles
// that close a gap are not updated: the gap that an edit leaves is no wider than the original one.
constexpr std::uint32_t touchableNumber(std::uint32_t face) {
  return 2 * face;  // odd ids are those of the strips in gaps
}

}  // namespace handwheel
