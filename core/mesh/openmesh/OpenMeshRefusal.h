// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// Reasons why an algorithm of OpenMesh does not accept a mesh. OpenMesh requires that the two vertices of an edge
// identify it, unlike HalfEdgeMesh.
enum class OpenMeshRefusal {
  None,
  Degenerate,  // a face with a repeated vertex
  DoubleEdge,  // two edges between the same two vertices, as on a one-sided surface
  BackToBack,  // two faces with the same three edges
  Seam,        // more than two faces meet at an edge: a subdivision scheme that moves its vertices would tear it
  Hub,         // a vertex with so many faces that time and memory, quadratic in their number, would be excessive
};

}  // namespace handwheel
