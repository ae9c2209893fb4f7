// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace handwheel {

struct RayHit {
  std::uint32_t triangle = kNone;
  double distance = 0.0;  // in lengths of the direction
};

struct NearestPoint {
  std::uint32_t triangle = kNone;
  Vec3 point = Vec3::Zero();
  double squaredDistance = 0.0;
};

// A bounding volume hierarchy over triangles, for picking, nearest points and intersection tests. Keeps its own copy of
// the corner positions, so the mesh may change or go while the hierarchy is used on another thread. Reading is
// thread-safe. Build O(n log n), queries O(log n) on ordinary surfaces.
class TriangleHierarchy {
 public:
  TriangleHierarchy() = default;
  TriangleHierarchy(std::span<const Vec3> points, std::span<const Triangle> triangles);

  bool empty() const;
  Box bounds() const;

  // The first triangle that the ray from origin along direction meets, from either side; distance >= 0.
  std::optional<RayHit> firstHit(const Vec3& origin, const Vec3& direction) const;

  // The nearest point of the surface; none when the hierarchy is empty or nothing is nearer than the limit.
  std::optional<NearestPoint> nearest(const Vec3& p, double limit = 1e300) const;

  // Calls visit(triangle) for each triangle whose box meets the box (boundaries included) until it returns false.
  // Returns false when a visit did.
  bool forEachInBox(const Box& box, const std::function<bool(std::uint32_t)>& visit) const;

  std::array<Vec3, 3> corners(std::uint32_t triangle) const;

 private:
  // (to be filled in)
};

}  // namespace handwheel
