// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proximity/TriangleHierarchy.h"
#include "viewport/ClipPlane.h"
#include "viewport/camera/CameraNavigation.h"

#include <memory>

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

// A rigid part with its pose.
struct PickPart {
  std::string name;
  Pose pose;
  std::shared_ptr<const PickIndex> index;
};

// All that can be picked.
struct Pickable {
  const PickIndex* mesh = nullptr;  // null: none, or not searchable yet
  std::span<const PickPart> parts = {};
  std::span<const LoopMark> loops = {};
  ClipPlane clip = {};

  Box bounds() const;  // of mesh and parts
};

// The intersection of a ray with a surface.
struct SurfaceHit {
  Face face = kNone;               // of the mesh
  const PickPart* part = nullptr;  // or this
  Vec3 point = Vec3::Zero();
  double distance = 0.0;  // from the ray's origin, mm
};

// The first surface along the ray that is not clipped away. The direction is of unit length.
std::optional<SurfaceHit> firstSurface(const Pickable& pickable, const Vec3& origin, const Vec3& direction);

// The same as a pick, without loops.
Pick pickAlong(const Pickable& pickable, const Vec3& origin, const Vec3& direction);

// Picks the object at the cursor. That is the nearest loop within kHolePickRadius that the surface does not hide, else
// the first surface.
Pick pickAt(const Pickable& pickable, const CameraNavigation& view, const Vec2& cursor);

}  // namespace handwheel
