// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"
#include "proximity/TriangleHierarchy.h"

#include <optional>

namespace handwheel {

// A search structure over the faces of a mesh, for picking. Immutable once built; built on a worker, read on the window
// thread.
class PickIndex {
 public:
  explicit PickIndex(const HalfEdgeMesh& mesh);

  struct Hit {
    Face face;
    double distance;  // in lengths of the direction
  };
  std::optional<Hit> firstHit(const Vec3& origin, const Vec3& direction) const;
  // The unit normal of the face nearest to p; zero when there is none or it has no area.
  Vec3 normalNear(const Vec3& p) const;
  const Box& bounds() const { return m_hierarchy.bounds(); }

 private:
  std::vector<Face> m_faceOf;  // of each triangle in the hierarchy
  TriangleHierarchy m_hierarchy;
};

}  // namespace handwheel
