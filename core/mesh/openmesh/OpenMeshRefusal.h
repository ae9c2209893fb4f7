// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// Reasons why an algorithm of OpenMesh does not take a mesh. Its edges have two vertices of their own, as ours need
// not.
enum class OpenMeshRefusal {
  None,
  Degenerate,  // a face with a repeated vertex
  DoubleEdge,  // two edges between the same two vertices, as on a surface with one side only
  BackToBack,  // two faces with the same three edges
  Seam,        // more than two faces meet at an edge: a scheme that moves its vertices would tear it
  Hub,         // a vertex with so many faces that time and memory would go with the square of them
};

}  // namespace handwheel
