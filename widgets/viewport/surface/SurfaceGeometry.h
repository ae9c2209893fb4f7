// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

#include <cstdint>
#include <vector>

namespace handwheel {

// An indexed triangle mesh for the graphics card. Positions have single precision and are relative to an origin near
// the model, so that a model far from its own origin does not jitter. There is one vertex for each combination of a
// position and a normal.
struct SurfaceGeometry {
  std::vector<float> positions;       // x y z …
  std::vector<float> normals;         // one for each position, unit length
  std::vector<std::int32_t> indices;  // three per triangle
  std::vector<float> values;          // values of the vertices if the surface is coloured by values; else empty

  std::size_t vertexCount() const { return positions.size() / 3; }
};

// The default number of face slots in a block of the mesh. Block b has the faces b * blockFaces … (b + 1) * blockFaces
// - 1. The setting view.block_faces replaces this number.
inline constexpr Face kBlockFaces = 65536;
// Returns the number of blocks of a mesh.
std::size_t blockCount(const HalfEdgeMesh& mesh, Face blockFaces = kBlockFaces);
// Returns the blocks that look different after an edit: those of the touched faces, and of the faces around their
// corners, as these share normals with them.
std::vector<std::size_t> blocksAround(const HalfEdgeMesh& before, const HalfEdgeMesh& after,
                                      const std::vector<Face>& touched, Face blockFaces);

// Builds the geometry of the live faces of one block. The geometry is empty for a block beyond the last one, which an
// undo may leave to be redrawn. Normals are angle-weighted over the faces around a vertex (Thürmer, Wüthrich,
// "Computing vertex normals from polygonal facets", 1998) and split where neighbouring faces differ by more than 40°.
// values: one for each vertex slot; null: none.
SurfaceGeometry blockGeometry(const HalfEdgeMesh& mesh, std::size_t block, const Vec3& origin,
                              Face blockFaces = kBlockFaces, const std::vector<double>* values = nullptr);

// Simplifies a mesh to roughly this many triangles by vertex clustering. The result stands in for a mesh that is too
// large to be drawn while the camera moves. Vertices in the same cell of a grid are merged (Rossignac, Borrel, 1993),
// and get the mean of their values.
SurfaceGeometry coarseGeometry(const HalfEdgeMesh& mesh, const Box& bounds, const Vec3& origin, std::size_t triangles,
                               const std::vector<double>* values = nullptr);

}  // namespace handwheel
