// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/PositionTriangles.h"

namespace handwheel {

// The components of a mesh: faces connected through shared vertex positions.
class FaceComponents {
 public:
  // The result is invalid if cancelled.
  FaceComponents(const HalfEdgeMesh& mesh, const PositionTriangles& byPosition, Progress progress = {});

  std::size_t count() const { return m_count; }
  // The component of a live face, in order of the first face.
  std::uint32_t of(Face f) const { return m_of[f]; }

 private:
  std::vector<std::uint32_t> m_of;
  std::size_t m_count = 0;
};

}  // namespace handwheel
