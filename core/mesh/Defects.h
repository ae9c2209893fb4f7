// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Tolerance.h"
#include "mesh/BoundaryLoops.h"
#include "mesh/HalfEdgeMesh.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace handwheel {

struct Component {
  std::size_t faceCount = 0;
  double area = 0.0;        // mm²
  bool debris = false;      // far smaller than the largest: a stray flake of the scan
  std::vector<Face> faces;  // of debris only
};

// Everything that is wrong with a mesh, each with its place. Self-intersections are looked for apart
// (findSelfIntersections), because they take longer than the rest together.
struct Defects {
  std::vector<BoundaryLoop> loops;
  std::vector<std::pair<Vertex, Vertex>> nonManifoldEdges;  // end points; one entry per edge, by position
  std::vector<Vertex> nonManifoldVertices;                  // one of the vertices at each such position
  // At which the two faces disagree, however faces are turned: the surface has one side only.
  std::vector<std::pair<Vertex, Vertex>> oneSidedEdges;
  std::vector<Face> degenerateFaces;                    // zero area
  std::vector<Face> duplicateFaces;                     // same three positions as an earlier face
  std::vector<std::pair<Vertex, Vertex>> nearVertices;  // on open borders, apart but within the near weld
  std::vector<Component> components;                    // largest area first
  Box box;                                              // of all live faces
};

// The parts of the mesh, largest area first. Once cancelled, none.
std::vector<Component> findComponents(const HalfEdgeMesh& mesh, Progress progress = {});

// nearWeld: the setting mesh.near_weld, as in RepairOptions. Incomplete once cancelled.
Defects findDefects(const HalfEdgeMesh& mesh, double nearWeld = tolerance::kNearWeld, Progress progress = {});

// A version of a mesh with what is wrong with it. A worker makes it, so that the window need not look.
struct InspectedMesh {
  HalfEdgeMesh mesh;
  std::shared_ptr<const Defects> defects;
};
InspectedMesh inspected(HalfEdgeMesh mesh, double nearWeld = tolerance::kNearWeld, Progress progress = {});

// Pairs of faces that meet in more than a shared vertex or edge. Empty optional when cancelled.
std::optional<std::vector<std::pair<Face, Face>>> findSelfIntersections(const HalfEdgeMesh& mesh,
                                                                        Progress progress = {});

}  // namespace handwheel
