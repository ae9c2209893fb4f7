// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// Scales meshes of extreme size to an ordinary one and back.
//
// Squares of areas, which many steps compare, vanish or overflow for sizes beyond about 1e±75. The factor is a power of
// two, which changes no digit, so the same comes out at every size. Meshes of ordinary size are not scaled.
class WorkingScale {
 public:
  explicit WorkingScale(const HalfEdgeMesh& mesh);
  explicit WorkingScale(const Box& box);

  bool isNeeded() const { return m_exponent != 0; }
  void apply(HalfEdgeMesh& mesh);
  // Takes a mesh back. Vertices that were not moved since apply() have exactly the positions that they had.
  void undo(HalfEdgeMesh& mesh) const;

  double toWork(double length) const;
  double fromWork(double value, int dimension = 1) const;  // dimension: 1 of a length, 2 of an area, 3 of a volume
  Vec3 toWork(const Vec3& p) const;
  Vec3 fromWork(const Vec3& p) const;

 private:
  int m_exponent = 0;          // at work, coordinates are 2^m_exponent times as large
  std::vector<Vec3> m_before;  // positions, by vertex
};

}  // namespace handwheel
