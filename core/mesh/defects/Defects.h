// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Tolerance.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/defects/MeshState.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace handwheel {

// A connected component of a mesh.
struct Component {
  std::size_t faceCount = 0;
  double area = 0.0;        // mm²
  double volume = 0.0;      // mm³, negative where inside out; means nothing while the component is open
  bool debris = false;      // far smaller than the largest: a stray flake of the scan
  std::vector<Face> faces;  // of debris only
};

// The defects of a mesh with their places. Self-intersections are searched separately (findSelfIntersections), because
// that takes longer than the rest together.
struct Defects {
  std::vector<BoundaryLoop> loops;
  std::vector<std::pair<Vertex, Vertex>> nonManifoldEdges;  // end points; one entry per edge, by position
  std::vector<Vertex> nonManifoldVertices;                  // one of the vertices at each such position
  // Edges whose two faces cannot be oriented consistently: the surface is non-orientable.
  std::vector<std::pair<Vertex, Vertex>> nonOrientableEdges;
  // The fewest faces of each part to reverse so that neighbours agree. None as long as relink() makes the mesh.
  std::vector<Face> inconsistentFaces;
  std::vector<std::vector<Face>> insideOut;             // the faces of each body that is inside out
  std::vector<Face> degenerateFaces;                    // zero area
  std::vector<Face> duplicateFaces;                     // same three positions as an earlier face
  std::vector<std::pair<Vertex, Vertex>> nearVertices;  // as stitchablePairs()
  std::vector<Component> components;                    // largest area first
  std::size_t nestedBodies = 0;                         // as findShellFaults()
  Box box;                                              // of all live faces

  // selfIntersectingPairs: absent when not known.
  MeshState state(std::optional<std::size_t> selfIntersectingPairs) const;
};

// Finds the connected components of the mesh, largest area first. Empty if cancelled.
std::vector<Component> findComponents(const HalfEdgeMesh& mesh, Progress progress = {});

std::size_t countDebris(std::span<const Component> components);

// Finds the inconsistent faces alone, as in Defects. Empty if cancelled.
std::vector<Face> findInconsistentFaces(const HalfEdgeMesh& mesh, Progress progress = {});

// Finds the defects of a mesh. nearWeld: the setting mesh.near_weld, as in RepairOptions. Incomplete if cancelled.
Defects findDefects(const HalfEdgeMesh& mesh, double nearWeld = tolerance::kNearWeld, Progress progress = {});

// A mesh with its defects. Computed by a worker, so that the window need not do so.
struct InspectedMesh {
  HalfEdgeMesh mesh;
  std::shared_ptr<const Defects> defects;
};
InspectedMesh inspected(HalfEdgeMesh mesh, double nearWeld = tolerance::kNearWeld, Progress progress = {});

// Finds the pairs of faces that intersect in more than a shared vertex or edge. Empty optional when cancelled.
std::optional<std::vector<std::pair<Face, Face>>> findSelfIntersections(const HalfEdgeMesh& mesh,
                                                                        Progress progress = {});

}  // namespace handwheel
