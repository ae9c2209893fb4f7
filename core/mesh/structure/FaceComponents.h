// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/PositionTriangles.h"

namespace handwheel {

// The components of a mesh, also called pieces: faces connected through shared vertex positions. A face with a repeated
// vertex connects nothing. All counts of pieces use this definition.
class FaceComponents {
 public:
  // Finds the components of a mesh. The object is invalid if cancelled.
  FaceComponents(const HalfEdgeMesh& mesh, const PositionTriangles& byPosition, Progress progress = {});
  // Finds the components of triangles over welded points.
  FaceComponents(const std::vector<Triangle>& triangles, std::size_t points, Progress progress = {});

  std::size_t count() const { return m_count; }
  // Returns the component of a live face. Components are numbered in order of their first face.
  std::uint32_t of(Face f) const { return m_of[f]; }

 private:
  void number(const std::vector<Triangle>& triangles, std::size_t points, const HalfEdgeMesh* mesh, Progress progress);

  std::vector<std::uint32_t> m_of;
  std::size_t m_count = 0;
};

}  // namespace handwheel
