// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

#include <cstdint>
#include <vector>

namespace handwheel {

// An indexed triangle mesh for the graphics card. Single precision, relative to an origin near the model, so that a
// model far from its own origin does not jitter; one vertex for each position and normal.
struct SurfaceGeometry {
  std::vector<float> positions;       // x y z …
  std::vector<float> normals;         // the same number, unit length
  std::vector<std::int32_t> indices;  // three per triangle
  std::vector<float> values;          // values of the vertices if the surface is coloured by values; else empty

  std::size_t vertexCount() const { return positions.size() / 3; }
};

// The default number of face slots in a block of the mesh. Block b has the faces b * blockFaces … (b + 1) * blockFaces
// - 1. The setting view.block_faces.
inline constexpr Face kBlockFaces = 65536;
// Returns the number of blocks of a mesh.
std::size_t blockCount(const HalfEdgeMesh& mesh, Face blockFaces = kBlockFaces);
// Returns the blocks whose picture an edit changes: those of the touched faces, and of the faces around their corners,
// as these share normals with them.
std::vector<std::size_t> blocksAround(const HalfEdgeMesh& before, const HalfEdgeMesh& after,
                                      const std::vector<Face>& touched, Face blockFaces);

// Builds the geometry of the live faces of one block. Empty for a block behind the last, which an undo may leave to be
// redrawn. Normals are angle-weighted over the faces around a vertex (Thürmer, Wüthrich, "Computing vertex normals from
// polygonal facets", 1998) and split where neighbouring faces differ by more than 40°. values: per vertex slot, or
// null.
SurfaceGeometry blockGeometry(const HalfEdgeMesh& mesh, std::size_t block, const Vec3& origin,
                              Face blockFaces = kBlockFaces, const std::vector<double>* values = nullptr);

// Simplifies a mesh to roughly this many triangles by vertex clustering. For a mesh that is too large to be drawn while
// the camera moves: vertices in the same cell of a grid are merged (Rossignac, Borrel, 1993), with the mean of their
// values.
SurfaceGeometry coarseGeometry(const HalfEdgeMesh& mesh, const Box& bounds, const Vec3& origin, std::size_t triangles,
                               const std::vector<double>* values = nullptr);

}  // namespace handwheel
