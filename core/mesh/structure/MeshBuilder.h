// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <span>

namespace handwheel {

// The decisions made in building a half-edge mesh. Numbers are those of the built mesh.
struct BuildReport {
  std::size_t weldedPoints = 0;       // points of the file that shared an exact position with an earlier one
  std::vector<Face> reversedFaces;    // faces that were reversed so that neighbours agree
  std::vector<Vertex> splitVertices;  // vertices made because one position had several fans of faces
  std::size_t nonManifoldEdges = 0;   // edges with more than two faces in the file
  std::size_t unpairedHalfEdges = 0;  // half-edges left as Open::Seam
};

// A mesh with its build report.
struct BuiltMesh {
  HalfEdgeMesh mesh;
  BuildReport report;
};

// Builds a half-edge mesh from a triangle soup. Welds exactly equal positions, reverses faces so that neighbours agree
// (the fewest in each part), pairs the faces at edges with more than two by the solid wedge between them, and gives
// every fan of faces a vertex of its own. Face i of the mesh is triangle i of the soup: no triangle is dropped or
// added. The mesh is empty if cancelled.
BuiltMesh buildMesh(const TriangleSoup& soup, Progress progress = {});

// Rebuilds the connectivity of a mesh in place after its faces changed. Like buildMesh(), it pairs all edges anew by
// position. Face and vertex numbers stay; if a position has more fans than vertices, vertices are added. If cancelled,
// the mesh is unchanged.
BuildReport relink(HalfEdgeMesh& mesh, Progress progress = {});

// Reverses single faces regardless of their neighbours and pairs all edges anew. Unlike relink(), it does not restore
// consistent orientation: an edge at which neighbours disagree becomes a seam. If cancelled, the mesh is unchanged.
void reverseFaces(HalfEdgeMesh& mesh, std::span<const Face> faces, Progress progress = {});

}  // namespace handwheel
