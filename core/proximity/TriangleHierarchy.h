// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"
#include "proximity/BoxTree.h"
#include "proximity/TriangleBoxes.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace handwheel {

// The intersection of a ray with a triangle.
struct RayHit {
  std::uint32_t triangle = kNone;
  double distance = 0.0;  // multiple of the direction's length
};

// The point of a surface nearest to a query point.
struct NearestPoint {
  std::uint32_t triangle = kNone;
  Vec3 point = Vec3::Zero();
  double squaredDistance = 0.0;
};

// The number of boxes for long, slanted triangles: one, or several (splitSliverBoxes()). Several are made if single
// boxes would overlap each other; this is slower to build, but necessary for fast queries around a vertex with
// thousands of faces.
enum class Slivers { Whole, Cut };

// A bounding volume hierarchy over triangles, for picking, nearest points and intersection tests. It keeps its own copy
// of the corner positions, so the mesh may change or be deleted while the hierarchy is used on another thread. Reading
// is thread-safe. Triangles with a coordinate that is not finite are left out; triangles without area are included, as
// segments or points. Construction is O(n log n) on all threads of the arena; queries are O(log n) on ordinary
// surfaces, and O(n) if all boxes overlap. The hierarchy uses about 60 bytes per triangle. Coordinates must be below
// 1e150, so that distances can be squared.
class TriangleHierarchy {
 public:
  TriangleHierarchy() = default;
  // The hierarchy is empty if cancelled.
  TriangleHierarchy(std::span<const Vec3> points, std::span<const Triangle> triangles, Progress progress = {},
                    Slivers slivers = Slivers::Whole);

  bool empty() const { return m_order.empty(); }
  const Box& bounds() const { return m_bounds; }

  // Returns the first triangle that the ray from origin along direction meets, from either side; distance >= 0. Of
  // triangles at the same distance, the one with the lowest number is returned. A ray through a shared edge or corner
  // hits one of the triangles. Triangles seen exactly edge-on, and those without area, are not hit. Returns nothing for
  // a direction of length 0.
  std::optional<RayHit> firstHit(const Vec3& origin, const Vec3& direction) const;

  // Returns the nearest point of the surface; nothing if the hierarchy is empty or no point is nearer than the limit.
  // Of triangles at the same distance, the one with the lowest number is returned.
  std::optional<NearestPoint> nearest(const Vec3& p, double limit = 1e300) const;

  // Returns true if a point of the surface is nearer than the distance. Equivalent to nearest(), but the search stops
  // at the first such point.
  bool isWithin(const Vec3& p, double distance) const;

  // Calls visit(triangle) for each triangle whose box meets the box (boundaries included) until it returns false.
  // Returns false if a visit did. Slivers that were cut may occur more than once, or not at all if no piece's box meets
  // the box.
  bool forEachInBox(const Box& box, const std::function<bool(std::uint32_t)>& visit) const;

  std::array<Vec3, 3> corners(std::uint32_t triangle) const;

 private:
  std::vector<Vec3> m_points;
  std::vector<Triangle> m_triangles;
  BoxFrame m_frame;
  BoxTree m_tree;
  std::vector<std::uint32_t> m_order;  // triangles in the order of the leaves
  Box m_bounds;
};

}  // namespace handwheel
