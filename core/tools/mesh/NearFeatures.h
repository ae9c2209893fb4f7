// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/ContactSurface.h"
#include "haptics/snap/SnapFeatures.h"
#include "mesh/structure/HalfEdgeMesh.h"
#include "tools/Tool.h"

namespace handwheel {

// Features of a mesh near a place that attract the device tip.
struct NearFeatures {
  // So many that a tick gets through the features of each kind, of which it looks at SnapLayer::kMostItems at most:
  // with common corners and edges some 700 and 2,100, without any 4,200 of either. On finer meshes the reach shrinks,
  // and the features are collected more often as the tip moves.
  static constexpr std::size_t kMostFaces = 1400;

  SnapFeatures features;  // by the numbers of their vertices, half-edges (the smaller of two) and faces
  double reach = 0.0;     // mm: all features within this distance of the place are among them
};

// Finds the features of a mesh near a place. Of the faces within the reach (mm), or within a half of it, a quarter and
// so on if those would be too many: that a mesh has millions of faces costs nothing. The surface is that of the mesh
// (touchableSurface). Nothing for a place or a reach that is not a number, or a reach of zero. On a worker.
NearFeatures nearFeatures(const HalfEdgeMesh& mesh, const ContactSurface& surface, const SnapTargets& snapTargets,
                          const Vec3& place, double reach);

// The mean edge length of all faces, mm; 0 without any. O(n).
double meanSide(const HalfEdgeMesh& mesh);

}  // namespace handwheel
