// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/ThreadClock.h"
#include "mesh/structure/TriangleSoup.h"
#include "proximity/TriangleIntersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/utility.h>

#include <vector>

// CGAL's methods for filling a hole, as the reference for those of Handwheel.
namespace handwheel::bench {

namespace pmp = CGAL::Polygon_mesh_processing;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

inline Surface toLibrary(const TriangleSoup& soup) {
  std::vector<Point> points;
  for (const Vec3& p : soup.points) points.emplace_back(p.x(), p.y(), p.z());
  std::vector<Triangle> triangles = soup.triangles;
  if (!pmp::is_polygon_soup_a_polygon_mesh(triangles))
    pmp::orient_polygon_soup(points, triangles);  // needed for pinched holes
  Surface surface;
  pmp::polygon_soup_to_polygon_mesh(points, triangles, surface);
  return surface;
}

struct LibraryFill {
  double milliseconds = 0.0;
  std::size_t faces = 0;
  std::vector<Vec3> positions;  // positions of the new vertices; if there are none, the centres of the new faces
  std::vector<TrianglePoints> triangles;
};

inline Vec3 toVec3(const Point& p) {
  return {p.x(), p.y(), p.z()};
}

// Returns the half-edge of the edge a-b that has no face.
inline Surface::Halfedge_index borderEdge(const Surface& surface, const Vec3& a, const Vec3& b) {
  for (const auto h : surface.halfedges()) {
    if (!surface.is_border(h)) continue;
    const Vec3 from = toVec3(surface.point(surface.source(h))), to = toVec3(surface.point(surface.target(h)));
    if ((from == a && to == b) || (from == b && to == a)) return h;
  }
  return Surface::null_halfedge();
}

// Fills the hole with the edge a-b using only CGAL, without a check for intersections or a fallback to another method.
inline LibraryFill fillByLibrary(Surface surface, const Vec3& a, const Vec3& b) {
  LibraryFill result;
  const Surface::Halfedge_index border = borderEdge(surface, a, b);
  std::vector<Surface::Face_index> faces;
  std::vector<Surface::Vertex_index> vertices;
  result.milliseconds = cpuMilliseconds([&] {
    pmp::triangulate_refine_and_fair_hole(surface, border, std::back_inserter(faces), std::back_inserter(vertices));
  });
  result.faces = faces.size();
  for (const auto v : vertices) result.positions.push_back(toVec3(surface.point(v)));
  for (const auto f : faces) {
    TrianglePoints t;
    std::size_t k = 0;
    for (const auto v : surface.vertices_around_face(surface.halfedge(f))) t[k++] = toVec3(surface.point(v));
    result.triangles.push_back(t);
    if (vertices.empty()) result.positions.push_back((t[0] + t[1] + t[2]) / 3.0);
  }
  return result;
}

struct LibraryTriangulation {
  double milliseconds = 0.0;
  std::size_t triangles = 0;  // 0: no triangulation was found
};

// Triangulates a hole with CGAL's search among the triangles of the Delaunay triangulation of the loop. It has no
// fallback to the cubic search, which takes 90 s for a loop of 2,554 edges. It creates only triangles between the
// points of the loop, which are not refined, faired or checked against the part.
inline LibraryTriangulation triangulateByLibrary(const std::vector<Vec3>& loop) {
  std::vector<Point> points;
  for (const Vec3& p : loop) points.emplace_back(p.x(), p.y(), p.z());
  std::vector<CGAL::Triple<int, int, int>> triangles;
  LibraryTriangulation result;
  result.milliseconds = cpuMilliseconds([&] {
    pmp::triangulate_hole_polyline(points, std::back_inserter(triangles),
                                   CGAL::parameters::use_delaunay_triangulation(true).do_not_use_cubic_algorithm(true));
  });
  result.triangles = triangles.size();
  return result;
}

}  // namespace handwheel::bench
