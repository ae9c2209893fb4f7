// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/FlatTriangulation.h"

#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/QuietCgal.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <algorithm>

namespace handwheel {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;  // the point of the loop
using Marked = CGAL::Triangulation_face_base_with_info_2<bool, Kernel>;                 // has been visited
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, Marked>;
using Planar =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_tag>;

// Adds the loop as seen against the normal, counter-clockwise. Returns false if its projection crosses or touches
// itself.
bool insertLoop(const HoleContext& hole, const Vec3& normal, Planar& planar, Progress progress) {
  const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u), origin = hole.points.front();
  std::vector<Planar::Vertex_handle> vertices;
  for (std::uint32_t i = 0; i < hole.loopSize; ++i) {
    if (!pollProgress(i, hole.loopSize, progress.part(0.0, 0.5))) return false;
    const Vec3 p = hole.points[i] - origin;
    const Planar::Face_handle near = vertices.empty() ? Planar::Face_handle() : vertices.back()->face();
    vertices.push_back(planar.insert({p.dot(u), p.dot(v)}, near));
    vertices.back()->info() = i;
  }
  if (planar.number_of_vertices() < hole.loopSize || planar.dimension() < 2) return false;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!pollProgress(i, vertices.size(), progress.part(0.5, 1.0))) return false;
    const Planar::Vertex_handle a = vertices[i], b = vertices[(i + 1) % vertices.size()];
    planar.insert_constraint(a, b);
    // A point on the segment would have become an end of the edge.
    Planar::Face_handle face;
    int side = 0;
    if (!planar.is_edge(a, b, face, side)) return false;
  }
  return true;
}

// The triangles to the left of the loop. The patch runs against the loop, so each is reversed.
std::vector<Triangle> inside(Planar& planar) {
  for (const Planar::Face_handle face : planar.all_face_handles()) face->info() = false;
  std::vector<Planar::Face_handle> open{planar.infinite_face()};
  planar.infinite_face()->info() = true;
  while (!open.empty()) {
    const Planar::Face_handle face = open.back();
    open.pop_back();
    for (int k = 0; k < 3; ++k) {
      const Planar::Face_handle next = face->neighbor(k);
      if (face->is_constrained(k) || next->info()) continue;
      next->info() = true;
      open.push_back(next);
    }
  }
  std::vector<Triangle> triangles;
  for (const Planar::Face_handle face : planar.finite_face_handles()) {
    if (!face->info()) triangles.push_back({face->vertex(0)->info(), face->vertex(2)->info(), face->vertex(1)->info()});
  }
  return triangles;
}

}  // namespace

Vec3 vectorAreaOf(const HoleContext& hole) {
  Vec3 sum = Vec3::Zero();
  const Vec3& origin = hole.points.front();
  for (std::size_t i = 0; i < hole.loopSize; ++i)
    sum += (hole.points[i] - origin).cross(hole.points[(i + 1) % hole.loopSize] - origin);
  return sum;
}

double heightOf(const HoleContext& hole) {
  const Vec3 normal = vectorAreaOf(hole).stableNormalized();
  double low = 0.0, high = 0.0;
  for (std::size_t i = 0; i < hole.loopSize; ++i) {
    const double height = (hole.points[i] - hole.points.front()).dot(normal);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  return high - low;
}

std::optional<Patch> triangulateFlat(const HoleContext& hole, Progress progress) {
  const Vec3 area = vectorAreaOf(hole);
  const Vec3 normal = area.stableNormalized();
  if (hole.loopSize < 3 || !area.allFinite() || area.isZero(0.0)) return std::nullopt;
  const QuietCgal quiet;
  Planar planar;
  Patch patch;
  try {
    if (!insertLoop(hole, normal, planar, progress)) return std::nullopt;
    patch.triangles = inside(planar);
  } catch (const Planar::Intersection_of_constraints_exception&) {
    return std::nullopt;
  } catch (const CGAL::Failure_exception&) {
    return std::nullopt;
  }
  if (patch.triangles.size() + 2 != hole.loopSize) return std::nullopt;
  patch.loopSize = hole.loopSize;
  patch.points = hole.loop();
  patch.method = FillMethod::Flat;
  return patch;
}

}  // namespace handwheel
