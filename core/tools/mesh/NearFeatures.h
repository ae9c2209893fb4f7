// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/ContactSurface.h"
#include "haptics/snap/SnapFeatures.h"
#include "mesh/structure/HalfEdgeMesh.h"
#include "tools/Tool.h"

namespace handwheel {

// Features of a mesh near a position that attract the device tip.
struct NearFeatures {
  // Largest number of faces. A tick gets through their features of each kind, of which it looks at
  // SnapLayer::kMostItems at most: with common corners and edges some 700 and 2,100, without any 4,200 of either. On
  // finer meshes the reach shrinks, and the features are collected more often as the tip moves.
  static constexpr std::size_t kMostFaces = 1400;

  SnapFeatures features;  // Ids: the indices of vertices, half-edges (the smaller of two) and faces
  double reach = 0.0;     // mm; all features within this distance of the position are included
};

// Finds the features of a mesh near a position. Takes the faces within the reach (mm), or within a half of it, a
// quarter and so on if those would be too many, so that the cost does not grow with the mesh. surface: that of the mesh
// (touchableSurface). Returns nothing for a position or a reach that is not a number, or a reach of zero. Runs on a
// worker thread.
NearFeatures nearFeatures(const HalfEdgeMesh& mesh, const ContactSurface& surface, const SnapTargets& snapTargets,
                          const Vec3& position, double reach);

// Returns the mean edge length of all faces, mm; 0 without any. O(n).
double meanSide(const HalfEdgeMesh& mesh);

}  // namespace handwheel
