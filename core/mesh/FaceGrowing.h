// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/FaceSelection.h"

#include <limits>
#include <optional>
#include <span>

namespace handwheel {

// Selections that grow over the surface. Faces are neighbours where their half-edges are paired: a face without extent,
// a seam and another part that only touches stay outside. Dead seeds count for nothing. O(result).

// Where growing ends early.
struct GrowthLimit {
  std::size_t faces = std::numeric_limits<std::size_t>::max();  // this many are enough
  Progress progress = {};                                       // cancelled: no result
};

// All that hangs together with the seeds.
std::optional<FaceSelection> connectedFaces(const HalfEdgeMesh& mesh, std::span<const Face> seeds,
                                            const GrowthLimit& limit = {});

// What can be reached from the seeds over edges at which the normals differ by at most this angle (radian). A face
// without area has no normal; it takes part with that of the face from which it was reached, so that a needle neither
// stops growing over a flat place nor carries it around a corner.
std::optional<FaceSelection> facesWithinAngle(const HalfEdgeMesh& mesh, std::span<const Face> seeds, double angle,
                                              const GrowthLimit& limit = {});

// With all faces that share a vertex with one of them.
FaceSelection grownByRing(const HalfEdgeMesh& mesh, const FaceSelection& faces);
// Without those that share a vertex with a face that is not in it. The border of the mesh takes nothing away.
FaceSelection shrunkByRing(const HalfEdgeMesh& mesh, const FaceSelection& faces);

}  // namespace handwheel
