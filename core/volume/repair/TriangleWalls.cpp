// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/TriangleWalls.h"

#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/Weld.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kFlatBend = 1e-6;      // rad, less leaves no notch, but faces that lie in one another
constexpr double kBendStep = 0.35;      // rad, of a chord of the rounded outside of a bend
constexpr double kOverlap = 0.05;       // rad and shares of half the thickness, of pieces that are to hang together
constexpr std::size_t kMostLeaves = 8;  // leaves that meet in an edge; each two form a bend

// Joins the prisms of triangles with a common edge. It closes the notches that they leave on the outside of a bend, and
// around vertices. The added triangles are within half of the thickness of the edge or vertex.
class BendFiller {
 public:
  BendFiller(const TriangleSoup& surface, double thickness, TriangleSoup& walls)
      : m_surface(surface),
        m_half(0.5 * thickness),
        m_walls(walls),
        m_classes(classifyPoints(surface.points)),
        m_isAtRim(m_classes.representative.size(), false),
        m_sum(m_classes.representative.size(), Vec3::Zero()) {
    for (const Triangle& t : surface.triangles) {
      Triangle& corners = m_triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) corners[k] = m_classes.classOf[t[k]];
      const Vec3 &a = point(corners[0]), &b = point(corners[1]), &c = point(corners[2]);
      m_normals.push_back((b - a).cross(c - a).stableNormalized());
      if (!m_normals.back().allFinite()) m_normals.back().setZero();
    }
  }

  void fill() {
    const EdgeTable edges(m_triangles, m_classes.representative.size());
    edges.forEachEdge([&](std::uint32_t low, std::uint32_t high, std::span<const EdgeTable::Entry> run) {
      if (run.size() == 1) m_isAtRim[low] = m_isAtRim[high] = true;
    });
    edges.forEachEdge([&](std::uint32_t, std::uint32_t, std::span<const EdgeTable::Entry> run) {
      const std::size_t count = std::min(run.size(), kMostLeaves);
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j) fillBend(run[i], run[j]);
    });
    for (const Corner& corner : m_corners) fillCorner(corner);
  }

 private:
  // The outside of a bend at one of its ends.
  struct Corner {
    std::uint32_t vertex;
    std::vector<Vec3> arc;  // directions, of length 1
  };

  const Vec3& point(std::uint32_t c) const { return m_surface.points[m_classes.representative[c]]; }
  // The corner across an edge.
  const Vec3& across(const EdgeTable::Entry& edge) const { return point(cornerOf(edge, 2)); }
  // 0: where its half-edge begins, 1: where that ends.
  std::uint32_t cornerOf(const EdgeTable::Entry& edge, std::uint32_t next) const {
    return m_triangles[edge.halfEdge / 3][(edge.halfEdge % 3 + next) % 3];
  }

  void fillBend(const EdgeTable::Entry& one, const EdgeTable::Entry& other) {
    const Vec3 &first = m_normals[one.halfEdge / 3], &second = m_normals[other.halfEdge / 3];
    if (first.isZero() || second.isZero()) return;
    const std::uint32_t from = cornerOf(one, 0), to = cornerOf(one, 1);
    // The notch is on the side that the other triangle bends away from; that of a fold flat on itself may be either.
    const double side = (across(other) - point(from)).dot(first) > 0.0 ? -1.0 : 1.0;
    const bool isTurned = cornerOf(other, 0) == from;  // it has the same direction along the edge
    const Vec3 a = side * first, b = (isTurned ? -side : side) * second, along = point(to) - point(from);
    const double bend = std::atan2(a.cross(b).norm(), a.dot(b));
    const Vec3 across = along.cross(a);  // to one side of the edge
    if (!(bend > kFlatBend)) {
      for (const Vec3& up : {a, Vec3(-a)}) addWedges(from, to, arcBetween(up, across, 0.0));
      return;
    }
    const Vec3 towards = b - b.dot(a) * a;
    const std::vector<Vec3> arc = arcBetween(a, towards.norm() > kFlatBend ? towards : across, bend);
    addWedges(from, to, arc);
    for (const std::uint32_t vertex : {from, to}) {
      // Both sides of a vertex in one sum, of which the sign is that of its first bend.
      m_sum[vertex] += (m_sum[vertex].dot(a + b) < 0.0 ? -1.0 : 1.0) * (a + b);
      m_corners.push_back({vertex, arc});
    }
  }

  // Returns directions rotated from one towards another by an angle, and slightly beyond both ends: coplanar faces
  // within the wall are no boundary, but rows of voxels could not detect that.
  static std::vector<Vec3> arcBetween(const Vec3& from, const Vec3& towards, double angle) {
    const Vec3 direction = (towards - towards.dot(from) * from).normalized();
    const double whole = angle + 2.0 * kOverlap;
    const int steps = 1 + static_cast<int>(whole / kBendStep);
    std::vector<Vec3> arc;
    for (int i = 0; i <= steps; ++i) {
      const double at = whole * i / steps - kOverlap;
      arc.push_back(std::cos(at) * from + std::sin(at) * direction);
    }
    return arc;
  }

  // A little beyond the ends of the edge, too, but for those at a rim.
  void addWedges(std::uint32_t from, std::uint32_t to, const std::vector<Vec3>& arc) {
    const Vec3 beyond = kOverlap * m_half * (point(to) - point(from)).stableNormalized();
    const Vec3 first = m_isAtRim[from] ? point(from) : Vec3(point(from) - beyond);
    const Vec3 last = m_isAtRim[to] ? point(to) : Vec3(point(to) + beyond);
    for (std::size_t i = 0; i + 1 < arc.size(); ++i) addWedge(first, last, arc[i], arc[i + 1]);
  }

  // The prism from edge to edge of which one end is an edge of the surface itself.
  void addWedge(const Vec3& from, const Vec3& to, const Vec3& a, const Vec3& b) {
    const bool isLeft = a.cross(b).dot(to - from) > 0.0;
    const Vec3 &one = isLeft ? a : b, &two = isLeft ? b : a;
    const auto first = static_cast<std::uint32_t>(m_walls.points.size());
    for (const Vec3& end : {from, to})
      for (const Vec3& p : {end, Vec3(end + m_half * one), Vec3(end + m_half * two)}) m_walls.points.push_back(p);
    m_walls.triangles.push_back({first, first + 2, first + 1});
    m_walls.triangles.push_back({first + 3, first + 4, first + 5});
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t next = (k + 1) % 3;
      m_walls.triangles.push_back({first + k, first + next, first + 3 + next});
      m_walls.triangles.push_back({first + k, first + 3 + next, first + 3 + k});
    }
  }

  // Cones from the mean direction at the vertex to the ends of its bends, on the side of each.
  void fillCorner(const Corner& corner) {
    Vec3 middle = m_sum[corner.vertex].stableNormalized();
    if (!middle.allFinite() || middle.isZero()) return;
    if (middle.dot(corner.arc.front() + corner.arc.back()) < 0.0) middle = -middle;
    const Vec3& at = point(corner.vertex);
    for (std::size_t i = 0; i + 1 < corner.arc.size(); ++i) {
      const double volume = corner.arc[i].cross(corner.arc[i + 1]).dot(middle);
      if (std::abs(volume) < kFlatBend) continue;
      const bool isLeft = volume > 0.0;
      const Vec3 &one = corner.arc[isLeft ? i : i + 1], &two = corner.arc[isLeft ? i + 1 : i];
      const auto first = static_cast<std::uint32_t>(m_walls.points.size());
      for (const Vec3& p : {at, Vec3(at + m_half * one), Vec3(at + m_half * two), Vec3(at + m_half * middle)})
        m_walls.points.push_back(p);
      for (const Triangle& t : {Triangle{0, 2, 1}, Triangle{0, 1, 3}, Triangle{0, 3, 2}, Triangle{1, 2, 3}})
        m_walls.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }

  const TriangleSoup& m_surface;
  double m_half;
  TriangleSoup& m_walls;
  PointClasses m_classes;
  std::vector<Triangle> m_triangles;  // over classes
  std::vector<Vec3> m_normals;        // zero without area
  std::vector<bool> m_isAtRim;        // per class
  std::vector<Vec3> m_sum;            // per class, of the directions of its bends
  std::vector<Corner> m_corners;
};

}  // namespace

TriangleSoup wallsOf(const TriangleSoup& surface, double thickness) {
  TriangleSoup walls;
  for (const Triangle& t : surface.triangles) {
    const Vec3 &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    const Vec3 normal = (b - a).cross(c - a).stableNormalized();
    if (!normal.allFinite() || normal.isZero()) continue;
    const auto front = static_cast<std::uint32_t>(walls.points.size()), back = front + 3;
    for (const double side : {0.5, -0.5})
      for (const Vec3& p : {a, b, c}) walls.points.push_back(p + side * thickness * normal);
    walls.triangles.push_back({front, front + 1, front + 2});
    walls.triangles.push_back({back, back + 2, back + 1});
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t next = (k + 1) % 3;
      walls.triangles.push_back({back + k, back + next, front + next});
      walls.triangles.push_back({back + k, front + next, front + k});
    }
  }
  BendFiller(surface, thickness, walls).fill();
  return walls;
}

WallMeasure measureForWalls(const TriangleSoup& surface) {
  WallMeasure measure;
  for (const Triangle& t : surface.triangles) {
    const Vec3 &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    const double area = 0.5 * (b - a).cross(c - a).norm();
    measure.area += area;
    if (area > 0.0) measure.edges += (b - a).norm() + (c - b).norm() + (a - c).norm();
  }
  return measure;
}

}  // namespace handwheel
