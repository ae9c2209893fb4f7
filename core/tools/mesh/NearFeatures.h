// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/ContactSurface.h"
#include "haptics/snap/SnapFeatures.h"
#include "mesh/structure/HalfEdgeMesh.h"
#include "tools/Tool.h"

namespace handwheel {

// The features of a mesh near a position that attract the device tip.
struct NearFeatures {
  // The largest number of faces. A tick examines at most SnapLayer::kMostItems features of each kind. This number of
  // faces stays below that limit: it has about 700 corners and 2,100 edges if the faces share them, and 4,200 of each
  // if they share none. On finer meshes the reach is smaller, and the features are collected more often as the tip
  // moves.
  static constexpr std::size_t kMostFaces = 1400;

  SnapFeatures features;  // the ids are the indices of vertices, half-edges (the smaller of two) and faces
  double reach = 0.0;     // mm; all features within this distance of the position are included
};

// Finds the features of a mesh near a position. Uses the faces within the reach (mm). If they are too many, the reach
// is halved repeatedly, so that the cost does not grow with the mesh. surface: the contact surface of the mesh. The
// result is empty if the position or the reach is not a number, or if the reach is zero. May be called on a worker
// thread.
NearFeatures nearFeatures(const HalfEdgeMesh& mesh, const ContactSurface& surface, const SnapTargets& snapTargets,
                          const Vec3& position, double reach);

// Returns the mean edge length of all faces, mm, or 0 if there are no faces. O(n).
double meanSide(const HalfEdgeMesh& mesh);

}  // namespace handwheel
