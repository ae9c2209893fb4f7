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
  Bounded,  // ours: with every option
  // OpenMesh's: a vertex goes to one beside it, so those that stay do not move. It bounds no distance and
  // looks at no other faces, so error must be none and avoidIntersections false.
  Quadric,
};

// Options of decimate().
struct DecimationOptions {
  // Stop at this number of faces, or when no more can be removed. 0: as few as the error allows.
  std::size_t faces = 0;
  // mm, above zero; how far the result may be from the original, and the original from the result. Every collapse is
  // checked: the new faces, at points about as dense as the original's vertices, and all points of the original that
  // lie nearest to them, its vertices and some on each face. Then the whole is verified (liesWithin()) and, where that
  // fails, made again with a smaller error, and with nothing changed near the failure; where that does not help,
  // nothing is removed.
  std::optional<double> error = std::nullopt;
  bool keepBorders = false;  // no vertex of an open edge is moved or removed
  // No vertex of an edge with at least this angle between its faces' normals (radian) leaves it: along it vertices may
  // be removed, and where it ends or branches they stay.
  std::optional<double> creaseAngle = std::nullopt;
  // No pair of faces meets in more than a shared vertex or edge that did not before. Existing self-intersections stay
  // as they are.
  bool avoidIntersections = false;
  DecimationMethod method = DecimationMethod::Bounded;
  // Measure the distance that is reached where no error is given, too, which takes about as long as reading the file.
  bool measureDistance = false;
};

// The report of a decimation.
struct DecimationReport {
  std::size_t facesBefore = 0;  // live
  std::size_t facesAfter = 0;
  std::size_t removedDegenerate = 0;  // faces with a repeated vertex
  // In mm, either way, as deviation() found it; none unless an error was given or it was to be measured. And whether it
  // is proven that no point is farther than the error: not where none was given, or the proof would have taken too long
  // (an error far smaller than the faces).
  std::optional<double> largestDistance;
  bool isProven = false;
  OpenMeshRefusal refusal = OpenMeshRefusal::None;  // of Quadric; then the mesh is unchanged
  bool cancelled = false;
};

// Simplifies a mesh by edge collapses, the least change of the surface first. By quadrics (Garland and Heckbert, 1997).
// The topology stays: parts, handles and holes; no face flips. The quadrics are those of the faces around an edge as
// they are, not sums over all that was there before: on scans the result is nearer to the original (Lindstrom and Turk,
// "Fast and memory efficient polygonal simplification", 1998). Vertices at seams and at positions that several vertices
// share stay. Face and vertex numbers that remain mean what they did before, though vertices move. The mesh is valid
// afterwards (validate()); if cancelled, it is unchanged. O(n log n) on ordinary surfaces. By Quadric, the quadrics are
// sums (docs/adr/0028-openmesh.md); all else holds.
DecimationReport decimate(HalfEdgeMesh& mesh, const DecimationOptions& options, Progress progress = {});

}  // namespace handwheel
