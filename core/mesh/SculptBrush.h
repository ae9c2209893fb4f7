// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/FaceSelection.h"
#include "mesh/VertexGoals.h"

namespace handwheel {

// The part of a surface under a round brush: what hangs together with the place within the ball.
struct BrushArea {
  struct Held {
    HalfEdge leaving;
    // (1 - (d/r)²)², d from the centre: 1 there, and level there and at the rim. Towards vertices that stay it falls to
    // 0, level at both ends: 3 x² - 2 x³, x the way over edges to the next of them as a share of that from the centre.
    double weight;
  };
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;         // mm
  std::vector<Face> faces;     // that meet the ball
  std::vector<Held> vertices;  // in the ball, and free to move
};

// Which vertices a brush may move. Those at a seam never: others stand at the same place.
struct BrushReach {
  const FaceSelection* patch = nullptr;  // only vertices all of whose faces are in it; null: any
  bool movesBorder = false;              // also those at the end of the surface
};

// fan: of a vertex.
bool isFreeToMove(const HalfEdgeMesh& mesh, std::span<const HalfEdge> fan, const BrushReach& reach);

// The area around a centre on or near a face. O(faces under the brush).
BrushArea brushArea(const HalfEdgeMesh& mesh, Face seed, const Vec3& centre, double radius,
                    const BrushReach& reach = {});

// What a dab of a brush would move, for moveTowards(). strength: 0…1.

// All by the same way, less towards the rim.
std::vector<VertexGoal> dragged(const HalfEdgeMesh& mesh, const BrushArea& area, const Vec3& way);
// Outwards along the normal by a distance (mm), inwards where it is negative; at a border not along it.
std::vector<VertexGoal> inflated(const HalfEdgeMesh& mesh, const BrushArea& area, double distance);
// Towards the plane that fits the area, away from it where strength is negative.
std::vector<VertexGoal> flattened(const HalfEdgeMesh& mesh, const BrushArea& area, double strength);
// One pass of a low-pass filter that does not shrink what is larger than some edges (Taubin, "A signal processing
// approach to fair surface design", 1995), with the reciprocals of the edges' lengths as weights. At a border a vertex
// looks along that only.
std::vector<VertexGoal> smoothed(const HalfEdgeMesh& mesh, const BrushArea& area, double strength);

}  // namespace handwheel
