// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/openmesh/OpenMeshRefusal.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <optional>

namespace handwheel {

// The methods of mesh decimation.
enum class DecimationMethod {
  Bounded,  // Handwheel's own method, with every option
  // OpenMesh's method: a vertex collapses into a neighbour, so remaining vertices do not move. It bounds no distance
  // and considers no other faces, so error must be empty and avoidIntersections false.
  Quadric,
};

// Options of decimate().
struct DecimationOptions {
  // Target number of faces; decimation also stops if no more can be removed. 0: as few as the error allows.
  std::size_t faces = 0;
  // The largest allowed distance between the result and the original in both directions, mm; above zero. Every collapse
  // is checked at points of the new faces, mostly on their edges, and at those sample points of the original (its
  // vertices and some on each face) that are nearest to the new faces. The final result is verified (proveWithin()).
  // Where that fails, vertices are inserted between the surfaces, unless a number of faces or creases are requested. If
  // that does not help, the result is made again without changes near the failure, and then with a smaller error, too;
  // at last, nothing is removed.
  std::optional<double> error = std::nullopt;
  bool keepBorders = false;  // vertices of open edges are neither moved nor removed
  // Smallest angle between the normals at an edge (radian) that makes it a crease. Vertices stay on their crease: they
  // may be removed along the crease, except where it ends or branches.
  std::optional<double> creaseAngle = std::nullopt;
  // Forbids new pairs of faces that meet in more than a shared vertex or edge. Existing self-intersections stay.
  bool avoidIntersections = false;
  DecimationMethod method = DecimationMethod::Bounded;
  // Requests that the resulting distance is measured even without an error limit. This takes about as long as reading
  // the file.
  bool measureDistance = false;
};

// The report of a decimation.
struct DecimationReport {
  std::size_t facesBefore = 0;  // live faces
  std::size_t facesAfter = 0;
  std::size_t removedDegenerate = 0;  // faces with a repeated vertex
  // Upper bound of the distance in both directions (largestDistance()), mm; absent unless an error limit or
  // measureDistance was set, or if there is no surface. With an error limit it is no larger than that.
  std::optional<double> largestDistance;
  OpenMeshRefusal refusal = OpenMeshRefusal::None;  // refusal of Quadric, which leaves the mesh unchanged
  bool cancelled = false;
};

// Simplifies a mesh by edge collapses, the least change of the surface first. Changes are measured by quadrics (Garland
// and Heckbert, 1997). The topology (parts, handles and holes) stays, and no face flips. The quadrics are those of the
// current faces around an edge, not accumulated over former ones: on scans the result is nearer to the original
// (Lindstrom and Turk, "Fast and memory efficient polygonal simplification", 1998). Vertices at seams and at positions
// that several vertices share stay. Remaining faces and vertices keep their numbers, though vertices move; inserted
// ones get new numbers. The mesh is valid afterwards (validate()); if cancelled, it is unchanged. O(n log n) on
// ordinary surfaces. With DecimationMethod::Quadric, the quadrics are accumulated (docs/adr/0028-openmesh.md);
// everything else applies too.
DecimationReport decimate(HalfEdgeMesh& mesh, const DecimationOptions& options, Progress progress = {});

}  // namespace handwheel
