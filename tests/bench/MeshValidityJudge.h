// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <vector>

// Judges the validity of a repaired file against its input. The judgement shares no code with Handwheel. Vertices at
// equal positions are merged and edges are counted to check the topology. Intersections and distances are computed by
// CGAL with exact predicates.
namespace handwheel::bench {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using JudgePoint = Kernel::Point_3;
using JudgeTriangle = std::array<std::size_t, 3>;

// A mesh of all triangles with non-zero area. Equal positions are one vertex, and every vertex is used.
struct JudgedMesh {
  std::vector<JudgePoint> points;
  std::vector<JudgeTriangle> triangles;

  JudgedMesh(const std::vector<std::array<double, 3>>& positions, const std::vector<JudgeTriangle>& all) {
    std::map<std::array<double, 3>, std::size_t> number;
    for (const JudgeTriangle& t : all) {
      std::array<JudgePoint, 3> p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = {positions[t[k]][0], positions[t[k]][1], positions[t[k]][2]};
      if (CGAL::collinear(p[0], p[1], p[2])) continue;
      JudgeTriangle triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::array<double, 3> position{p[k].x() + 0.0, p[k].y() + 0.0,
                                             p[k].z() + 0.0};  // turns negative zero into zero
        const auto [at, isNew] = number.try_emplace(position, points.size());
        if (isNew) points.push_back(p[k]);
        triangle[k] = at->second;
      }
      triangles.push_back(triangle);
    }
  }

  Kernel::Triangle_3 triangle(std::size_t i) const {
    return {points[triangles[i][0]], points[triangles[i][1]], points[triangles[i][2]]};
  }
  CGAL::Bbox_3 box() const { return CGAL::bbox_3(points.begin(), points.end()); }
  double diagonal() const {
    const CGAL::Bbox_3 b = box();
    return std::hypot(b.xmax() - b.xmin(), b.ymax() - b.ymin(), b.zmax() - b.zmin());
  }
};

struct JudgedEdges {
  std::size_t open = 0, surplus = 0, turned = 0;
  bool areSound() const { return open + surplus + turned == 0; }
};

inline JudgedEdges judgeEdges(const JudgedMesh& mesh) {
  std::map<std::pair<std::size_t, std::size_t>, std::array<int, 2>> uses;
  for (const JudgeTriangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++uses[std::minmax(t[k], t[(k + 1) % 3])][t[k] < t[(k + 1) % 3]];
  JudgedEdges edges;
  for (const auto& [edge, n] : uses) {
    edges.open += n[0] + n[1] == 1;
    edges.surplus += n[0] + n[1] > 2;
    edges.turned += n[0] > 1 || n[1] > 1;
  }
  return edges;
}

// Returns true if two triangles intersect elsewhere than at their common corners and edges.
inline bool judgeMeet(const JudgedMesh& mesh, std::size_t i, std::size_t j) {
  JudgeTriangle s = mesh.triangles[i], t = mesh.triangles[j];
  std::size_t shared = 0;  // number of common corners, which are moved to the front of both triangles
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = std::find(t.begin() + static_cast<std::ptrdiff_t>(shared), t.end(), s[k]);
    if (at == t.end()) continue;
    std::iter_swap(at, t.begin() + static_cast<std::ptrdiff_t>(shared));
    std::swap(s[k], s[shared++]);
  }
  const auto& p = mesh.points;
  if (shared == 3) return true;
  if (shared == 2)  // true if the triangles are folded onto each other
    return CGAL::coplanar(p[s[0]], p[s[1]], p[s[2]], p[t[2]]) &&
           CGAL::coplanar_orientation(p[s[0]], p[s[1]], p[s[2]], p[t[2]]) == CGAL::POSITIVE;
  if (shared == 1)
    return CGAL::do_intersect(Kernel::Segment_3(p[s[1]], p[s[2]]), mesh.triangle(j)) ||
           CGAL::do_intersect(Kernel::Segment_3(p[t[1]], p[t[2]]), mesh.triangle(i));
  return CGAL::do_intersect(mesh.triangle(i), mesh.triangle(j));
}

inline std::size_t judgeCrossings(const JudgedMesh& mesh) {
  struct Box : CGAL::Box_intersection_d::Box_d<double, 3> {
    Box(const CGAL::Bbox_3& box, std::size_t which) : CGAL::Box_intersection_d::Box_d<double, 3>(box), index(which) {}
    std::size_t index;
  };
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) boxes.emplace_back(mesh.triangle(i).bbox(), i);
  std::size_t crossings = 0;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                [&](const Box& a, const Box& b) { crossings += judgeMeet(mesh, a.index, b.index); });
  return crossings;
}

// Returns the index of the part of each vertex; parts are connected through vertices.
inline std::vector<std::size_t> judgeParts(const JudgedMesh& mesh) {
  std::vector<std::size_t> parent(mesh.points.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const JudgeTriangle& t : mesh.triangles) {
    parent[root(t[0])] = root(t[1]);
    parent[root(t[1])] = root(t[2]);
  }
  for (std::size_t v = 0; v < parent.size(); ++v) parent[v] = root(v);
  return parent;
}

struct JudgedChange {
  double farthest = 0.0;      // largest distance of old vertices from the new surface, as a fraction of the diagonal
  double growth = 0.0;        // largest growth of the box on any side, as a fraction of the diagonal
  std::size_t lostParts = 0;  // number of parts with more than half of their vertices a thousandth of the diagonal away
};

inline JudgedChange judgeChange(const JudgedMesh& before, const JudgedMesh& after) {
  constexpr std::size_t kMostVertices = 20'000;
  constexpr double kAway = 1e-3;
  std::vector<Kernel::Triangle_3> surface;
  for (std::size_t i = 0; i < after.triangles.size(); ++i) surface.push_back(after.triangle(i));
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, std::vector<Kernel::Triangle_3>::iterator>;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(surface.begin(), surface.end());
  tree.accelerate_distance_queries();
  const double diagonal = before.diagonal();
  std::map<std::size_t, std::vector<std::size_t>> parts;
  const std::vector<std::size_t> partOf = judgeParts(before);
  for (std::size_t v = 0; v < partOf.size(); ++v) parts[partOf[v]].push_back(v);
  std::mt19937 random(1);
  JudgedChange change;
  for (auto& [root, vertices] : parts) {
    std::shuffle(vertices.begin(), vertices.end(), random);
    const double share = static_cast<double>(vertices.size()) / static_cast<double>(partOf.size());
    vertices.resize(std::min(vertices.size(), 5 + static_cast<std::size_t>(share * kMostVertices)));
    std::size_t away = 0;
    for (const std::size_t v : vertices) {
      const double distance = std::sqrt(tree.squared_distance(before.points[v])) / diagonal;
      change.farthest = std::max(change.farthest, distance);
      away += distance > kAway;
    }
    change.lostParts += 2 * away > vertices.size();
  }
  const CGAL::Bbox_3 was = before.box(), is = after.box();
  for (int axis = 0; axis < 3; ++axis)
    change.growth =
        std::max({change.growth, (was.min(axis) - is.min(axis)) / diagonal, (is.max(axis) - was.max(axis)) / diagonal});
  return change;
}

}  // namespace handwheel::bench
