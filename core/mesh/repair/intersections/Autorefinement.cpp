// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/Autorefinement.h"

#include "mesh/structure/BitRange.h"
#include "mesh/structure/DisjointSets.h"
#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/PositionKey.h"
#include "mesh/structure/QuietCgal.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/intersections.h>
#include <algorithm>
#include <cmath>
#include <new>
#include <optional>
#include <set>

namespace handwheel {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point2 = Kernel::Point_2;
using Point3 = Kernel::Point_3;
using Triangle3 = Kernel::Triangle_3;
struct Index {
  std::uint32_t value = kNone;  // kNone: made by the triangulation where two constraints cross
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Triangulation = CGAL::Constrained_triangulation_plus_2<CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>, CGAL::Exact_intersections_tag>>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;  // smaller index first

Point3 exact(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

// The points and segments in a triangle, as numbers of exact points.
struct Marks {
  std::vector<std::uint32_t> points;
  std::vector<Edge> segments;
};

// The projection of a triangle's plane along the axis that shows it largest, and its inverse, both exact.
class Projection {
 public:
  explicit Projection(const Triangle3& t) : m_plane(t.supporting_plane()) {
    // Compared exactly, so that triangles in one plane are seen along the same axis.
    const Kernel::FT n[3] = {CGAL::abs(m_plane.a()), CGAL::abs(m_plane.b()), CGAL::abs(m_plane.c())};
    m_axis = static_cast<int>(std::max_element(n, n + 3) - n);
    m_faces = CGAL::sign(normal(m_axis)) == CGAL::POSITIVE;
  }

  bool facesAxis() const { return m_faces; }
  Point2 flat(const Point3& p) const { return {p[(m_axis + 1) % 3], p[(m_axis + 2) % 3]}; }
  Point3 lifted(const Point2& p) const {
    const int u = (m_axis + 1) % 3, v = (m_axis + 2) % 3;
    Kernel::FT c[3];
    c[u] = p.x();
    c[v] = p.y();
    c[m_axis] = -(normal(u) * p.x() + normal(v) * p.y() + m_plane.d()) / normal(m_axis);
    return {c[0], c[1], c[2]};
  }

 private:
  Kernel::FT normal(int axis) const { return axis == 0 ? m_plane.a() : axis == 1 ? m_plane.b() : m_plane.c(); }

  Kernel::Plane_3 m_plane;
  int m_axis = 0;
  bool m_faces = true;
};

using Corners = std::array<Triangulation::Vertex_handle, 3>;

// The triangles of a triangulation. Where more than three points lie on one circle, every choice of diagonals is
// Delaunay, and the library's depends on addresses. Here they start from the first of these points, so that triangles
// that overlap in one plane have equal pieces. Sorted by points.
class Cells {
 public:
  explicit Cells(const Triangulation& t) : m_triangulation(t) {
    for (const auto f : t.finite_face_handles()) m_numberOf.emplace(f, static_cast<std::uint32_t>(m_numberOf.size()));
  }

  std::vector<Corners> triangles() const {
    std::vector<Corners> result;
    for (const Outline& next : outlines()) {
      const Vertex first = std::min_element(next.begin(), next.end(), [](const auto& a, const auto& b) {
                             return a.first->point() < b.first->point();
                           })->first;
      for (Vertex a = next.at(first), b = next.at(a); b != first; a = b, b = next.at(b))
        result.push_back({first, a, b});
    }
    std::sort(result.begin(), result.end(), [](const Corners& a, const Corners& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                          [](Vertex p, Vertex q) { return p->point() < q->point(); });
    });
    return result;
  }

 private:
  using Vertex = Triangulation::Vertex_handle;
  using Outline = std::map<Vertex, Vertex>;  // from each corner to the next

  std::vector<Outline> outlines() const {
    DisjointSets cells(m_numberOf.size());
    for (const auto& [f, number] : m_numberOf) {
      for (int k = 0; k < 3; ++k) {
        if (isWithinCell(f, k)) cells.join(number, m_numberOf.at(f->neighbor(k)));
      }
    }
    std::vector<Outline> found(m_numberOf.size());
    for (const auto f : m_triangulation.finite_face_handles()) {
      const std::uint32_t cell = cells.root(m_numberOf.at(f));
      for (int k = 0; k < 3; ++k) {
        const auto other = m_numberOf.find(f->neighbor(k));
        if (other != m_numberOf.end() && cells.root(other->second) == cell) continue;
        found[cell][f->vertex(Triangulation::ccw(k))] = f->vertex(Triangulation::cw(k));
      }
    }
    std::erase_if(found, [](const Outline& outline) { return outline.empty(); });
    return found;
  }

  bool isWithinCell(Triangulation::Face_handle f, int k) const {
    if (f->is_constrained(k) || !m_numberOf.contains(f->neighbor(k))) return false;
    const Vertex opposite = m_triangulation.mirror_vertex(f, k);
    return CGAL::side_of_oriented_circle(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point(),
                                         opposite->point()) == CGAL::ON_ORIENTED_BOUNDARY;
  }

  const Triangulation& m_triangulation;
  std::map<Triangulation::Face_handle, std::uint32_t> m_numberOf;
};

// Steps of WorkBudget that it takes to intersect two triangles, or to put a point into a triangulation, with
// coordinates that have so many bits; the time goes with the square of the bits. Uniting three cylinders, 4900 pairs in
// planes with 53 bits, takes 3.3 million steps and 1.1 s.
constexpr double kExactSteps = 10.0;
constexpr double kExactBits = 64.0;
// Factor of the bits if points are snapped to planes, as quotients of products of three numbers: three boxes, 96
// triangles with 53 bits, take 0.2 s then.
constexpr double kPlaneDigits = 2.0;

// Returns the number of bits of the coordinates of these triangles as integers of one scale.
int bitsOf(const TriangleSoup& soup, std::span<const TrianglePair> pairs) {
  BitRange range;
  for (const TrianglePair& pair : pairs) {
    for (const std::uint32_t t : {pair.first, pair.second}) {
      for (const std::uint32_t corner : soup.triangles[t]) {
        for (const double x : soup.points[corner]) range.extend(x);
      }
    }
  }
  return range.bits();
}

class Cutter {
 public:
  Cutter(const TriangleSoup& soup, const SharedPlanes& planes, NumberType numbers, std::size_t mostCuts,
         Progress progress)
      : m_soup(soup), m_planes(planes), m_numbers(numbers), m_mostCuts(mostCuts), m_progress(progress) {
    for (const auto& [v, of] : planes.planesOf) m_snapped.emplace(v, nearestInPlanes(of, soup.points[v]));
  }

  // Without pieces once cancelled.
  Autorefinement run(std::span<const TrianglePair> pairs) {
    Autorefinement cuts;
    cuts.points = m_soup.points;
    const int bits = bitsOf(m_soup, pairs);
    if (bits > tolerance::kCutBits) return cuts;
    const double digits = bits * (m_planes.isEmpty() ? 1.0 : kPlaneDigits);
    m_exactSteps = static_cast<std::size_t>(kExactSteps * std::max(1.0, std::pow(digits / kExactBits, 2)));
    std::vector<TrianglePair> all(pairs.begin(), pairs.end());
    all.insert(all.end(), m_planes.pairs.begin(), m_planes.pairs.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (m_progress.cancelled()) return cuts;
      m_progress.part(0.0, 0.5).set(static_cast<double>(i) / static_cast<double>(all.size()));
      mark(all[i]);
      m_progress.spend(m_exactSteps);
    }
    markMoved();
    for (auto& [t, marks] : m_marks) {
      std::sort(marks.segments.begin(), marks.segments.end());
      marks.segments.erase(std::unique(marks.segments.begin(), marks.segments.end()), marks.segments.end());
      if (marks.segments.size() > m_mostCuts) return cuts;
    }
    spreadOverEdges();
    keepCorners();
    std::size_t done = 0;
    for (const auto& [t, marks] : m_marks) {
      m_progress.part(0.5, 1.0).set(static_cast<double>(done++) / static_cast<double>(m_marks.size()));
      cuts.piecesOf[t] = piecesOf(t, marks, cuts.points);
      if (!m_progress.cancelled()) continue;
      cuts.piecesOf.clear();
      break;
    }
    return cuts;
  }

 private:
  Triangle3 triangle(std::uint32_t t) const {
    const Triangle& c = m_soup.triangles[t];
    return {exactPoint(c[0]), exactPoint(c[1]), exactPoint(c[2])};
  }

  // Returns the exact position of a point of the soup, snapped to its planes if it has any.
  Point3 exactPoint(std::uint32_t v) const {
    const auto snapped = m_snapped.find(v);
    return snapped == m_snapped.end() ? exact(m_soup.points[v]) : snapped->second;
  }

  // Returns the point of all these planes that is nearest to p.
  Point3 nearestInPlanes(const std::vector<std::uint32_t>& planes, const Vec3& p) const {
    const Point3 from = exact(p);
    std::vector<Kernel::Plane_3> all;
    for (const std::uint32_t i : planes) {
      const SharedPlanes::Plane& plane = m_planes.planes[i];
      all.emplace_back(plane.normal.x(), plane.normal.y(), plane.normal.z(), -plane.offset);
    }
    if (all.size() == 1) return all[0].projection(from);
    const auto line = CGAL::intersection(all[0], all[1]);
    const auto* along = line ? boost::get<Kernel::Line_3>(&*line) : nullptr;
    if (!along) return from;
    if (all.size() == 2) return along->projection(from);
    const auto corner = CGAL::intersection(*along, all[2]);
    const auto* at = corner ? boost::get<Point3>(&*corner) : nullptr;
    return at ? *at : from;
  }

  // Unites points of the soup that are snapped to the same position, for every triangle.
  void markMoved() {
    std::map<Point3, std::uint32_t> firstAt;
    std::set<std::uint32_t> merged;
    for (const auto& [v, p] : m_snapped) {
      const auto [first, isNew] = firstAt.emplace(p, v);
      if (!isNew) merged.insert({first->second, v});
    }
    if (merged.empty()) return;
    for (std::uint32_t t = 0; t < m_soup.triangles.size(); ++t) {
      const Triangle& c = m_soup.triangles[t];
      const bool isMoved = std::any_of(c.begin(), c.end(), [&](std::uint32_t v) { return merged.contains(v); });
      if (isMoved && !hasRepeatedVertex(c)) m_marks[t];
    }
  }

  std::uint32_t numberOf(const Point3& p) {
    const auto [at, isNew] = m_numberOf.emplace(p, static_cast<std::uint32_t>(m_points.size()));
    if (isNew) m_points.push_back(p);
    return at->second;
  }

  void mark(const TrianglePair& pair) {
    const auto common = CGAL::intersection(triangle(pair.first), triangle(pair.second));
    if (!common) return;
    std::vector<std::uint32_t> corners;
    if (const auto* p = boost::get<Point3>(&*common)) {
      corners = {numberOf(*p)};
    } else if (const auto* s = boost::get<Kernel::Segment_3>(&*common)) {
      corners = {numberOf(s->source()), numberOf(s->target())};
    } else if (const auto* t = boost::get<Triangle3>(&*common)) {
      corners = {numberOf((*t)[0]), numberOf((*t)[1]), numberOf((*t)[2])};
    } else {
      for (const Point3& corner : boost::get<std::vector<Point3>>(*common)) corners.push_back(numberOf(corner));
    }
    for (std::uint32_t t : {pair.first, pair.second}) {
      Marks& marks = m_marks[t];
      marks.points.insert(marks.points.end(), corners.begin(), corners.end());
      if (corners.size() < 2) continue;
      const std::size_t sides = corners.size() == 2 ? 1 : corners.size();
      for (std::size_t i = 0; i < sides; ++i)
        marks.segments.push_back(std::minmax(corners[i], corners[(i + 1) % corners.size()]));
    }
  }

  // A point on an edge is on it for every triangle there.
  void spreadOverEdges() {
    std::map<Edge, std::vector<std::uint32_t>> onEdge;
    for (const auto& [t, marks] : m_marks) {
      const Triangle& c = m_soup.triangles[t];
      for (int k = 0; k < 3; ++k) {
        const Point3 a = exactPoint(c[k]), b = exactPoint(c[(k + 1) % 3]);
        for (std::uint32_t i : marks.points) {
          const Point3& p = m_points[i];
          if (CGAL::are_strictly_ordered_along_line(a, p, b)) onEdge[std::minmax(c[k], c[(k + 1) % 3])].push_back(i);
        }
      }
    }
    if (onEdge.empty()) return;
    for (std::uint32_t t = 0; t < m_soup.triangles.size(); ++t) {
      const Triangle& c = m_soup.triangles[t];
      if (hasRepeatedVertex(c)) continue;
      for (int k = 0; k < 3; ++k) {
        const auto at = onEdge.find(std::minmax(c[k], c[(k + 1) % 3]));
        if (at == onEdge.end()) continue;
        Marks& marks = m_marks[t];
        marks.points.insert(marks.points.end(), at->second.begin(), at->second.end());
      }
    }
  }

  // A crossing in a corner is the corner, regardless of its rounding.
  void keepCorners() {
    for (const auto& [t, marks] : m_marks) {
      for (std::uint32_t corner : m_soup.triangles[t]) {
        const bool isNew = m_indexOf.emplace(numberOf(exactPoint(corner)), corner).second;
        if (isNew && m_planes.reach > 0.0) m_near.emplace(m_soup.points[corner].x(), corner);
      }
    }
  }

  std::vector<Triangle> piecesOf(std::uint32_t t, const Marks& marks, std::vector<Vec3>& points) {
    const Triangle3 whole = triangle(t);
    if (whole.is_degenerate()) return {m_soup.triangles[t]};
    const Projection plane(whole);
    Triangulation pieces;
    std::map<std::uint32_t, Triangulation::Vertex_handle> vertexOf;
    const auto put = [&](std::uint32_t point) {
      const auto [at, isNew] = vertexOf.try_emplace(point);
      if (!isNew) return at->second;
      at->second = pieces.insert(plane.flat(m_points[point]));
      at->second->info().value = indexOf(point, points);
      return at->second;
    };
    std::array<Triangulation::Vertex_handle, 3> corner;
    for (int k = 0; k < 3; ++k) corner[k] = put(numberOf(whole[k]));
    for (std::uint32_t p : marks.points) put(p);
    m_progress.spend(m_exactSteps * marks.points.size());
    for (int k = 0; k < 3; ++k) pieces.insert_constraint(corner[k], corner[(k + 1) % 3]);
    for (const auto& [a, b] : marks.segments) {
      if (m_progress.cancelled()) return {};
      const std::size_t before = pieces.number_of_vertices();
      pieces.insert_constraint(put(a), put(b));
      m_progress.spend(m_exactSteps * (1 + pieces.number_of_vertices() - before));
    }

    std::vector<Triangle> result;
    for (const Corners& corners : Cells(pieces).triangles()) {
      Triangle piece{};
      for (int k = 0; k < 3; ++k) {
        std::uint32_t& index = corners[k]->info().value;
        // Two other triangles cross this one there: all three have the point.
        if (index == kNone) index = indexOf(numberOf(plane.lifted(corners[k]->point())), points);
        piece[k] = index;
      }
      if (!plane.facesAxis()) std::swap(piece[1], piece[2]);
      if (!hasRepeatedVertex(piece)) result.push_back(piece);
    }
    return result;
  }

  // Returns the index of a point in the result. Added points that are rounded to the same position become one.
  std::uint32_t indexOf(std::uint32_t point, std::vector<Vec3>& points) {
    const auto [at, isNew] = m_indexOf.emplace(point, 0u);
    if (!isNew) return at->second;
    const Point3& p = m_points[point];
    const Vec3 position =
        rounded(Vec3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())), m_numbers);
    if (const auto near = nearTo(position, points)) return at->second = *near;
    const auto [same, isNewPosition] =
        m_indexAt.emplace(positionKey(position), static_cast<std::uint32_t>(points.size()));
    if (isNewPosition) {
      points.push_back(position);
      if (m_planes.reach > 0.0) m_near.emplace(position.x(), same->second);
    }
    return at->second = same->second;
  }

  // Finds an added point within reach. If corners are rounded, lines that should meet in one point, such as edges and
  // the diagonal of a wall, meet in several.
  std::optional<std::uint32_t> nearTo(const Vec3& position, const std::vector<Vec3>& points) const {
    const double reach = m_planes.reach;
    const auto end = m_near.upper_bound(position.x() + reach);
    for (auto at = m_near.lower_bound(position.x() - reach); at != end; ++at)
      if ((points[at->second] - position).cwiseAbs().maxCoeff() <= reach) return at->second;
    return std::nullopt;
  }

  const TriangleSoup& m_soup;
  const SharedPlanes& m_planes;
  NumberType m_numbers;
  std::size_t m_mostCuts;
  Progress m_progress;
  std::size_t m_exactSteps = 0;               // steps of WorkBudget for each point
  std::map<std::uint32_t, Point3> m_snapped;  // by point of the soup, of those in planes
  std::vector<Point3> m_points;
  std::map<Point3, std::uint32_t> m_numberOf;
  std::map<std::uint32_t, Marks> m_marks;            // by triangle
  std::map<std::uint32_t, std::uint32_t> m_indexOf;  // by number
  std::map<PointKey, std::uint32_t> m_indexAt;       // index of each added point
  std::multimap<double, std::uint32_t> m_near;       // all points of the result by x, where planes are shared
};

}  // namespace

Autorefinement autorefine(const TriangleSoup& soup, std::span<const TrianglePair> pairs, NumberType numbers,
                          Progress progress, const SharedPlanes& planes, std::size_t mostCuts) {
  const QuietCgal quiet;
  try {
    return Cutter(soup, planes, numbers, mostCuts, progress).run(pairs);
  } catch (const std::bad_alloc&) {
    throw;                           // no other method helps against lack of memory
  } catch (const std::exception&) {  // a precondition of the library
    return {soup.points, {}};
  }
}

}  // namespace handwheel
