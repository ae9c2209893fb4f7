// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/openmesh/OpenMeshRefusal.h"
#include "mesh/sculpt/LoopSubdivision.h"

namespace handwheel {

// Subdivision schemes for whole meshes. All except the last are those of OpenMesh.
enum class SubdivisionScheme {
  Loop,       // approximating; C2 except at irregular vertices; a face becomes four
  Sqrt3,      // approximating; a face becomes three (Kobbelt, 2000)
  Butterfly,  // interpolating: the vertices stay; a face becomes four (Zorin, Schröder, Sweldens, 1996)
  Midpoint,   // splits edges at their midpoints: the surface stays, except for rounding; a face becomes four
};

// A subdivision scheme and the number of its applications.
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

// Returns the number of faces into which a scheme divides one face.
std::size_t facesOfOne(SubdivisionScheme scheme);

// Subdivides a whole mesh. Open edges get points too, so a part of a mesh cannot be subdivided: its outline would
// separate from its surroundings. Vertices keep their numbers, and each face keeps its number for one of its parts. A
// failure or refusal leaves the mesh unchanged. O(n log n) for the number of resulting faces. A mesh with a vertex of
// more than kMostButterflyNeighbours neighbours is refused for Butterfly.
SchemeOutcome subdivideAll(HalfEdgeMesh& mesh, const SchemeSubdivision& subdivision,
                           const SubdivisionLimits& limits = {});

}  // namespace handwheel
