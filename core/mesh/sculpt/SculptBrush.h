// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/sculpt/VertexGoals.h"
#include "mesh/selection/FaceSelection.h"

namespace handwheel {

// The part of a surface under a spherical brush. It is what is connected with the centre within the ball.
struct BrushArea {
  struct Held {
    HalfEdge leaving;
    // (1 - (d/r)²)², d from the centre: 1 there, and with zero slope there and at the rim. Towards vertices that stay
    // it falls to 0, with zero slope at both ends: 3 x² - 2 x³, x the distance over edges to the next of them as a
    // share of that from the centre.
    double weight;
  };
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;         // mm
  std::vector<Face> faces;     // that meet the ball
  std::vector<Held> vertices;  // in the ball, and free to move
};

// Which vertices a brush may move. Never those at a seam, since others are at the same place.
struct BrushReach {
  const FaceSelection* patch = nullptr;  // only vertices all of whose faces are in it; null: any
  bool movesBorder = false;              // also those at the border of the surface
};

// Whether a brush may move a vertex. fan: of the vertex.
bool isFreeToMove(const HalfEdgeMesh& mesh, std::span<const HalfEdge> fan, const BrushReach& reach);

// Computes the area of a brush around a centre on or near a face. O(faces under the brush).
BrushArea brushArea(const HalfEdgeMesh& mesh, Face seed, const Vec3& centre, double radius,
                    const BrushReach& reach = {});

// The functions below compute the vertex goals of one brush stroke, for moveTowards(). strength: 0…1.

// Drags vertices by the same vector, less towards the rim.
std::vector<VertexGoal> dragged(const HalfEdgeMesh& mesh, const BrushArea& area, const Vec3& way);
// Moves vertices outwards along the normal by a distance (mm). Inwards where it is negative; at a border not along it.
std::vector<VertexGoal> inflated(const HalfEdgeMesh& mesh, const BrushArea& area, double distance);
// Moves vertices towards the plane that fits the area. Away from it where strength is negative.
std::vector<VertexGoal> flattened(const HalfEdgeMesh& mesh, const BrushArea& area, double strength);
// Smooths vertices by one pass of Taubin's low-pass filter. It does not shrink what is larger than some edges (Taubin,
// "A signal processing approach to fair surface design", 1995), with the reciprocals of the edges' lengths as weights.
// At a border a vertex follows its neighbours on the border only.
std::vector<VertexGoal> smoothed(const HalfEdgeMesh& mesh, const BrushArea& area, double strength);

}  // namespace handwheel
