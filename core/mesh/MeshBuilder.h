// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "mesh/HalfEdgeMesh.h"

namespace handwheel {

// What building the half-edge mesh had to decide. Numbers are those of the built mesh.
struct BuildReport {
  std::size_t weldedPoints = 0;       // points of the file that shared an exact position with an earlier one
  std::vector<Face> turnedFaces;      // turned over so that neighbours agree
  std::vector<Vertex> splitVertices;  // vertices made because one position had several fans of faces
  std::size_t nonManifoldEdges = 0;   // edges with more than two faces in the file
  std::size_t unpairedHalfEdges = 0;  // half-edges left as Open::Seam
};

struct BuiltMesh {
  HalfEdgeMesh mesh;
  BuildReport report;
};

// Welds exactly equal positions, turns faces so that neighbours agree (fewest turned in each part), pairs the faces at
// edges with more than two by the solid wedge between them, and gives every fan of faces a vertex of its own. Face i of
// the mesh is triangle i of the soup: none is dropped, none is added. Once cancelled, an empty one.
BuiltMesh buildMesh(const TriangleSoup& soup, Progress progress = {});

// Does the same in place for a mesh whose faces changed: pairs everything anew by position. Face and vertex numbers
// stay; where a position has more fans than vertices, vertices are added. Once cancelled, the mesh is as it was.
BuildReport relink(HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
