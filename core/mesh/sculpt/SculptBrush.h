// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/sculpt/VertexGoals.h"
#include "mesh/selection/FaceSelection.h"

namespace handwheel {

// The part of a surface under a spherical brush. It is connected with the centre inside the ball.
struct BrushArea {
  struct Held {
    HalfEdge leaving;
    // Weight (1 - (d/r)²)² for the distance d from the centre: 1 at the centre, with zero slope at the centre and at
    // the rim. If some vertices stay, it is multiplied by 3 x² - 2 x³, where x is the distance along edges from the
    // vertex to the nearest of them, divided by the same distance from the vertex at the centre, and at most 1; so it
    // falls to 0 towards them, with zero slope at both ends.
    double weight;
  };
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;         // mm
  std::vector<Face> faces;     // faces that meet the ball
  std::vector<Held> vertices;  // movable vertices in the ball
};

// The restriction on the vertices that a brush may move. Vertices at a seam never move, since others share their
// position.
struct BrushReach {
  const FaceSelection* patch = nullptr;  // only vertices whose faces are all in the patch move; null: no restriction
  bool movesBorder = false;              // vertices at the border of the surface move too
};

// Returns true if a brush may move a vertex. fan: the fan of the vertex.
bool isFreeToMove(const HalfEdgeMesh& mesh, std::span<const HalfEdge> fan, const BrushReach& reach);

// Computes the area of a brush around a centre on or near a face. O(faces under the brush).
BrushArea brushArea(const HalfEdgeMesh& mesh, Face seed, const Vec3& centre, double radius,
                    const BrushReach& reach = {});

// The functions below compute the vertex goals of one brush stroke, for moveTowards(). A strength is at most 1; it is
// negative only where stated.

// Drags vertices by the same vector, less towards the rim.
std::vector<VertexGoal> dragged(const HalfEdgeMesh& mesh, const BrushArea& area, const Vec3& displacement);
// Moves vertices outwards along the normal by a distance (mm). Negative distances move inwards. Vertices at a border do
// not move along the border.
std::vector<VertexGoal> inflated(const HalfEdgeMesh& mesh, const BrushArea& area, double distance);
// Moves vertices towards the plane that fits the area, or away from it if strength is negative.
std::vector<VertexGoal> flattened(const HalfEdgeMesh& mesh, const BrushArea& area, double strength);
// Smooths vertices by one pass of Taubin's low-pass filter. The filter does not shrink features larger than a few edges
// (Taubin, "A signal processing approach to fair surface design", 1995). Its weights are the reciprocals of the edges'
// lengths. At a border a vertex follows its neighbours on the border only.
std::vector<VertexGoal> smoothed(const HalfEdgeMesh& mesh, const BrushArea& area, double strength);

}  // namespace handwheel
