// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HalfEdgeMesh.h"

#include <cstdint>
#include <vector>

namespace handwheel {

// Triangles as the graphics card wants them: single precision about an origin near the model, so that a model far from
// its own origin does not jitter; one vertex for each position and normal.
struct SurfaceGeometry {
  std::vector<float> positions;       // x y z …
  std::vector<float> normals;         // the same number, of unit length
  std::vector<std::int32_t> indices;  // three to a triangle
  std::vector<float> values;          // of the vertices, where the surface is coloured by values; else none

  std::size_t vertexCount() const { return positions.size() / 3; }
};

// A block is a run of so many face slots: block b holds the faces b * blockFaces … (b + 1) * blockFaces - 1. The
// setting view.block_faces, and its default.
inline constexpr Face kBlockFaces = 65536;
std::size_t blockCount(const HalfEdgeMesh& mesh, Face blockFaces = kBlockFaces);

// The live faces of one block; none of a block behind the last, as an undo leaves it to be drawn anew. Normals are
// angle-weighted over the faces around a vertex (Thürmer, Wüthrich, "Computing vertex normals from polygonal facets",
// 1998) and split where neighbouring faces differ by more than 40°. values: per vertex slot, or null.
SurfaceGeometry blockGeometry(const HalfEdgeMesh& mesh, std::size_t block, const Vec3& origin,
                              Face blockFaces = kBlockFaces, const std::vector<double>* values = nullptr);

// A stand-in of roughly this many triangles for a mesh that is too large to follow the mouse: vertices in the same cell
// of a grid become one (Rossignac, Borrel, 1993), with the mean of their values.
SurfaceGeometry coarseGeometry(const HalfEdgeMesh& mesh, const Box& bounds, const Vec3& origin, std::size_t triangles,
                               const std::vector<double>* values = nullptr);

}  // namespace handwheel
