// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/PositionTriangles.h"

namespace handwheel {

// The parts of a mesh: faces that hang together through shared vertex positions.
class FaceComponents {
 public:
  // Of no use once cancelled.
  FaceComponents(const HalfEdgeMesh& mesh, const PositionTriangles& byPosition, Progress progress = {});

  std::size_t count() const { return m_count; }
  // The part of a live face, in order of the first face.
  std::uint32_t of(Face f) const { return m_of[f]; }

 private:
  std::vector<std::uint32_t> m_of;
  std::size_t m_count = 0;
};

}  // namespace handwheel
