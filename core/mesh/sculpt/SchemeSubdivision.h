// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/openmesh/OpenMeshRefusal.h"
#include "mesh/sculpt/LoopSubdivision.h"

namespace handwheel {

// Subdivision schemes for whole meshes. All but the last are those of OpenMesh.
enum class SubdivisionScheme {
  Loop,       // approximates; C2 but for irregular vertices; a face becomes four
  Sqrt3,      // approximates; a face becomes three (Kobbelt, 2000)
  Butterfly,  // interpolates: the vertices stay; a face becomes four (Zorin, Schröder, Sweldens, 1996)
  Midpoint,   // splits edges in their middle: the surface stays, but for the rounding of the file; a face becomes four
};

// Which scheme, and how often.
struct SchemeSubdivision {
  SubdivisionScheme scheme = SubdivisionScheme::Loop;
  int times = 1;
};

struct SchemeOutcome {
  SubdivisionFailure failure = SubdivisionFailure::None;
  OpenMeshRefusal refusal = OpenMeshRefusal::None;
  bool isDone() const { return failure == SubdivisionFailure::None && refusal == OpenMeshRefusal::None; }
};

inline constexpr std::size_t kMostButterflyNeighbours = 1000;

// The number of faces that one becomes.
std::size_t facesOfOne(SubdivisionScheme scheme);

// Subdivides a whole mesh. Open edges get points, too, so a part of a mesh cannot be subdivided: its outline would part
// from its surroundings. Faces keep their number for one of their parts, and vertices theirs. An outcome that is not
// done leaves the mesh as it was. O(n log n) for the faces afterwards. Butterfly takes no vertex with more than
// kMostButterflyNeighbours.
SchemeOutcome subdivideAll(HalfEdgeMesh& mesh, const SchemeSubdivision& subdivision,
                           const SubdivisionLimits& limits = {});

}  // namespace handwheel
