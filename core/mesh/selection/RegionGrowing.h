// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/selection/FaceSelection.h"

#include <limits>
#include <optional>
#include <span>

namespace handwheel {

// Selection of faces by region growing. Faces are neighbours if they have paired half-edges: faces with a repeated
// vertex, seams and parts that only touch are not crossed. Dead seeds are ignored. O(result).

// Limits of region growing.
struct GrowthLimit {
  std::size_t faces = std::numeric_limits<std::size_t>::max();  // growing stops at this number of faces
  Progress progress = {};                                       // the functions return nothing if cancelled
};

// Selects all faces connected with the seeds.
std::optional<FaceSelection> connectedFaces(const HalfEdgeMesh& mesh, std::span<const Face> seeds,
                                            const GrowthLimit& limit = {});

// Selects the faces reached from the seeds without crossing sharp edges. At the crossed edges the normals differ by at
// most angle (radian). A face without area has no normal; it is given the normal of the face from which it was reached,
// so that a needle neither stops growing over a flat region nor carries it around a corner.
std::optional<FaceSelection> facesWithinAngle(const HalfEdgeMesh& mesh, std::span<const Face> seeds, double angle,
                                              const GrowthLimit& limit = {});

// Grows a selection by all faces that share a vertex with one of its faces.
FaceSelection grownByRing(const HalfEdgeMesh& mesh, const FaceSelection& faces);
// Shrinks a selection by the faces that share a vertex with a face outside it. Faces at the border of the mesh are not
// removed because of the border.
FaceSelection shrunkByRing(const HalfEdgeMesh& mesh, const FaceSelection& faces);

}  // namespace handwheel
