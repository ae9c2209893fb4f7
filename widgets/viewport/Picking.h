// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proximity/TriangleHierarchy.h"
#include "viewport/CameraNavigation.h"
#include "viewport/ClipPlane.h"

#include <memory>

namespace handwheel {

// A mesh's faces, searchable. Immutable once built; built on a worker, read on the window thread.
class PickIndex {
 public:
  explicit PickIndex(const HalfEdgeMesh& mesh);

  struct Hit {
    Face face;
    double distance;  // in lengths of the direction
  };
  std::optional<Hit> firstHit(const Vec3& origin, const Vec3& direction) const;
  // Of unit length, of the face nearest to p; zero where there is none or it has no area.
  Vec3 normalNear(const Vec3& p) const;
  const Box& bounds() const { return m_hierarchy.bounds(); }

 private:
  std::vector<Face> m_faceOf;  // of each triangle in the hierarchy
  TriangleHierarchy m_hierarchy;
};

// A rigid part where it stands.
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

struct SurfaceHit {
  Face face = kNone;               // of the mesh
  const PickPart* part = nullptr;  // or this
  Vec3 point = Vec3::Zero();
  double distance = 0.0;  // from the ray's origin, mm
};

// The first surface along the ray that is not clipped away. The direction is of unit length.
std::optional<SurfaceHit> firstSurface(const Pickable& pickable, const Vec3& origin, const Vec3& direction);

// The same as a pick; no loops.
Pick pickAlong(const Pickable& pickable, const Vec3& origin, const Vec3& direction);

// A loop nearer to the cursor than this wins over the face below it; logical pixels.
inline constexpr double kLoopPickRadius = 8.0;

// What appears at the cursor: the nearest loop that the surface does not hide, else the first surface.
Pick pickAt(const Pickable& pickable, const CameraNavigation& view, const Vec2& cursor);

}  // namespace handwheel
