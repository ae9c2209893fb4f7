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
  double sharpness = 0.5235987755982988;  // rad: least angle between the faces of an edge; rims are edges, too
  double corner = 0.7853981633974483;     // rad: a curve ends where its edges turn by more than this angle
};

// The surface of a part, prepared for finding edges and plane sections. It is immutable and may be used on any thread.
class PartSurface {
 public:
  // Prepares a surface. Triangles that have no area or are not finite are omitted. O(n log n).
  explicit PartSurface(const TriangleSoup& soup, const EdgeSettings& settings = {});

  bool hasEdges() const { return !m_sharp.empty(); }

  // Returns the surface point nearest to a position, with the normal of its triangle. The normal is zero if the surface
  // is empty. O(log n) on ordinary surfaces.
  TrackPoint pointNear(const Vec3& position) const;
  // Returns the curve of edges that contains the edge nearest to a position. The curve is empty if no edge is within
  // `farthest` (mm). O(edges).
  SurfaceTrack edgeNear(const Vec3& position, double farthest) const;
  // Returns the curve of a plane section that comes nearest to a position, which need not be in the plane. onPlane: a
  // point of the plane. normal: its normal, of unit length. O(s log s) for s triangles near the plane.
  SurfaceTrack sectionNear(const Vec3& onPlane, const Vec3& normal, const Vec3& position) const;

 private:
  struct Edge {
    std::uint32_t a, b;
    Vec3 normal;  // mean of the normals of its faces
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
  std::vector<std::uint32_t> m_order;  // indices of the triangles in the order of the leaves of m_tree
  std::vector<Edge> m_sharp;
  std::vector<std::uint32_t> m_firstOfVertex;  // first index in m_sharpOfVertex; one more than points
  std::vector<std::uint32_t> m_sharpOfVertex;
};

}  // namespace handwheel
