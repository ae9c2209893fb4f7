// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proximity/TriangleHierarchy.h"
#include "viewport/CameraNavigation.h"

#include <memory>

namespace handwheel {

// The model's faces, searchable. Immutable once built; built on a worker, read on the window thread.
class PickIndex {
 public:
  explicit PickIndex(const HalfEdgeMesh& mesh);

  struct Hit {
    Face face;
    Vec3 point;
  };
  std::optional<Hit> firstHit(const Vec3& origin, const Vec3& direction) const;
  const Box& bounds() const { return m_bounds; }

 private:
  std::vector<Face> m_faceOf;  // of each triangle in the hierarchy
  TriangleHierarchy m_hierarchy;
  Box m_bounds;
};

// A loop nearer to the cursor than this wins over the face below it; logical pixels.
inline constexpr double kLoopPickRadius = 8.0;

// What appears at the cursor: the nearest loop that the surface does not hide, else the first face.
Pick pickAt(const PickIndex& index, const std::vector<LoopMark>& loops, const CameraNavigation& view,
            const Vec2& cursor);

}  // namespace handwheel
