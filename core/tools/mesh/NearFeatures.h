// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/ContactSurface.h"
#include "haptics/SnapFeatures.h"
#include "mesh/HalfEdgeMesh.h"
#include "tools/Tool.h"

namespace handwheel {

// What of a mesh draws a tip that is at some place.
struct NearFeatures {
  static constexpr std::size_t kMostFaces = 1400;  // with three corners and three edges each these are 9,800 features

  SnapFeatures features;  // by the numbers of their vertices, half-edges (the smaller of two) and faces
  double reach = 0.0;     // mm: all that is no further from the place, in any direction, is among them
};

// Of the faces within the reach (mm) of the place, or within a half of it, a quarter and so on where those would be too
// many: that a mesh has millions of faces costs nothing. The surface is that of the mesh (touchableSurface). Nothing
// for a place or a reach that is no number, or a reach of zero. On a worker.
NearFeatures nearFeatures(const HalfEdgeMesh& mesh, const ContactSurface& surface, const Magnets& magnets,
                          const Vec3& place, double reach);

// mm, the mean length of the sides of all faces; 0 without any. O(n).
double meanSide(const HalfEdgeMesh& mesh);

}  // namespace handwheel
