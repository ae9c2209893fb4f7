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
  double volume = 0.0;      // mm³, negative if inside out; meaningless if the component is open
  bool debris = false;      // true if far smaller than the largest component, like a stray flake of a scan
  std::vector<Face> faces;  // faces of the component; empty unless it is debris
};

// The defects of a mesh with their locations. Self-intersections are searched separately (findSelfIntersections),
// because that search takes longer than all other checks together.
struct Defects {
  std::vector<BoundaryLoop> loops;
  std::vector<std::pair<Vertex, Vertex>> nonManifoldEdges;  // end points; one entry for each pair of positions
  std::vector<Vertex> nonManifoldVertices;                  // one vertex for each non-manifold position
  // Edges of non-orientable surfaces whose two faces cannot be oriented consistently.
  std::vector<std::pair<Vertex, Vertex>> nonOrientableEdges;
  // The smallest set of faces of each part that must be reversed so that neighbours agree. It is empty for meshes made
  // by relink().
  std::vector<Face> inconsistentFaces;
  std::vector<std::vector<Face>> insideOut;             // the faces of each body that is inside out
  std::vector<Face> degenerateFaces;                    // faces of zero area
  std::vector<Face> duplicateFaces;                     // faces with the same three positions as an earlier face
  std::vector<std::pair<Vertex, Vertex>> nearVertices;  // result of stitchablePairs()
  std::vector<Component> components;                    // largest area first
  std::size_t nestedBodies = 0;                         // result of findShellFaults()
  Box box;                                              // bounding box of all live faces

  // Returns the state of the mesh. selfIntersectingPairs: the number of intersecting pairs of faces, absent if unknown.
  MeshState state(std::optional<std::size_t> selfIntersectingPairs) const;
};

// Finds the connected components of the mesh, largest area first. Returns an empty list if cancelled.
std::vector<Component> findComponents(const HalfEdgeMesh& mesh, Progress progress = {});

std::size_t countDebris(std::span<const Component> components);

// Finds only the inconsistent faces (Defects::inconsistentFaces). Returns an empty list if cancelled.
std::vector<Face> findInconsistentFaces(const HalfEdgeMesh& mesh, Progress progress = {});

// Finds the defects of a mesh. nearWeld has the meaning of RepairOptions::nearWeld (the setting mesh.near_weld). The
// result is incomplete if cancelled.
Defects findDefects(const HalfEdgeMesh& mesh, double nearWeld = tolerance::kNearWeld, Progress progress = {});

// A mesh with its defects. A worker computes it, so that the window does not block.
struct InspectedMesh {
  HalfEdgeMesh mesh;
  std::shared_ptr<const Defects> defects;
};
InspectedMesh inspected(HalfEdgeMesh mesh, double nearWeld = tolerance::kNearWeld, Progress progress = {});

// Finds the pairs of faces that intersect in more than a shared vertex or edge. Returns nothing if cancelled.
std::optional<std::vector<std::pair<Face, Face>>> findSelfIntersections(const HalfEdgeMesh& mesh,
                                                                        Progress progress = {});

}  // namespace handwheel
