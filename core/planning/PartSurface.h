// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"
#include "planning/SurfaceTrack.h"
#include "proximity/TriangleBoxes.h"

#include <optional>
#include <vector>

namespace handwheel {

// Settings for finding and following the edges of a part.
struct EdgeSettings {
  double sharpness = 0.5235987755982988;  // rad: an edge has faces that bend by at least this angle, or is a rim
  double corner = 0.7853981633974483;     // rad: a curve ends at a larger turn of its edges
};

// The surface of a part, prepared for curves on it. Such curves are its edges and its sections with planes. Immutable;
// any thread.
class PartSurface {
 public:
  // Triangles that have no area or are not finite are left out. O(n log n).
  explicit PartSurface(const TriangleSoup& soup, const EdgeSettings& settings = {});

  bool hasEdges() const { return !m_sharp.empty(); }

  // Returns the surface point nearest to a position, and the normal of its triangle; a zero normal if there is no
  // surface. O(log n) on ordinary surfaces.
  TrackPoint pointNear(const Vec3& position) const;
  // Returns the curve of edges through the edge nearest to a position. Empty if no edge is within `farthest` (mm).
  // O(edges).
  SurfaceTrack edgeNear(const Vec3& position, double farthest) const;
  // Returns the section with a plane: the curve that comes nearest to a position, which need not be in the plane.
  // normal: of unit length. O(s log s) for s triangles that the plane cuts, and their surroundings.
  SurfaceTrack sectionNear(const Vec3& onPlane, const Vec3& normal, const Vec3& position) const;

 private:
  struct Edge {
    std::uint32_t a, b;
    Vec3 normal;  // between the normals of its faces
  };
  struct Chain {
    std::vector<std::uint32_t> edges;
    std::vector<std::uint32_t> vertices;  // one more than edges
    bool isClosed = false;
  };
  Chain chainThrough(std::uint32_t edge) const;
  void buildTree();
  std::vector<std::uint32_t> trianglesNear(const Vec3& onPlane, const Vec3& normal) const;
  struct Section;  // the segments in which a plane cuts the triangles
  Section sectionOf(const Vec3& onPlane, const Vec3& normal, const Vec3& position) const;
  std::optional<std::uint32_t> next(std::uint32_t edge, std::uint32_t vertex) const;

  EdgeSettings m_settings;
  std::vector<Vec3> m_points;
  std::vector<Triangle> m_triangles;
  std::vector<Vec3> m_normals;  // normals of the triangles
  BoxFrame m_frame;
  BoxTree m_tree;                      // tree of the triangles
  std::vector<std::uint32_t> m_order;  // triangles in the order of its leaves
  std::vector<Edge> m_sharp;
  std::vector<std::uint32_t> m_firstOfVertex;  // first index in m_sharpOfVertex; one more than points
  std::vector<std::uint32_t> m_sharpOfVertex;
};

}  // namespace handwheel
