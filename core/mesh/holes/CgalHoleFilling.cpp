// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/CgalHoleFilling.h"

#include "mesh/structure/QuietCgal.h"

#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/refine.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <type_traits>

// CGAL's filling of holes starts at the cell that comes first among those at an edge, and of two triangulations that
// weigh the same it takes the one that it meets first. By default that order is the one of the addresses of the cells,
// which differs from run to run. Here it is that of the numbers of their corners, so that the same hole gets the same
// patch. For triangulate_hole_polyline() alone, whose triangulation has this type.
namespace handwheel {

struct HoleTriangulation {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Structure = CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>,
                                                         CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
  using Cell = CGAL::Delaunay_triangulation_cell_base_3<
      Kernel, CGAL::Triangulation_cell_base_3<Kernel, CGAL::Triangulation_ds_cell_base_3<Structure>>>;

  // No two cells have the same corners.
  static std::array<int, 4> cornersOf(const Cell& cell) {
    std::array<int, 4> corners{};
    for (int k = 0; k < 4; ++k) corners[k] = cell.vertex(k) == nullptr ? -2 : cell.vertex(k)->info();
    std::sort(corners.begin(), corners.end());
    return corners;
  }
};

}  // namespace handwheel

namespace CGAL {

template <>
struct Time_stamper_impl<handwheel::HoleTriangulation::Cell> : No_time_stamp<handwheel::HoleTriangulation::Cell> {
  using Cell = handwheel::HoleTriangulation::Cell;
  static bool less(const Cell* a, const Cell* b) {
    if (!a || !b) return !a && b;
    return handwheel::HoleTriangulation::cornersOf(*a) < handwheel::HoleTriangulation::cornersOf(*b);
  }
};

}  // namespace CGAL

static_assert(std::is_same_v<handwheel::HoleTriangulation::Structure::Cell, handwheel::HoleTriangulation::Cell>);

namespace handwheel {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

// Ends a call of the library when it is thrown in what the library calls back.
struct Cancelled : std::exception {};

// Counts the steps of the library, so that it shows progress and can be cancelled.
class LibraryWork {
 public:
  explicit LibraryWork(Progress progress) : m_progress(progress) {}

  // A step is worth about a quarter of a microsecond.
  void count(std::size_t steps) {
    m_steps += steps;
    if (m_steps - m_seen < kSteps) return;
    if (m_progress.cancelled()) throw Cancelled();
    m_progress.spend((m_steps - m_seen) / 4);
    // The total is unknown: the fraction grows and never reaches 1.
    m_progress.set(static_cast<double>(m_steps) / static_cast<double>(m_steps + kHalfway));
    m_seen = m_steps;
  }

 private:
  static constexpr std::size_t kSteps = 4096, kHalfway = 10'000'000;
  Progress m_progress;
  std::size_t m_steps = 0;
  std::size_t m_seen = 0;  // value of m_steps at the last report
};

constexpr std::size_t kEdgeSteps = 32;  // steps for an edge that the triangulation examines
constexpr std::size_t kFaceSteps = 2;   // steps for a face that is added to a surface

// For the library's triangulation, which calls it back in its loops.
struct WatchingVisitor : pmp::Hole_filling::Default_visitor {
  LibraryWork* work;
  void quadratic_step() const { work->count(kEdgeSteps); }
  void cubic_step() const { work->count(kEdgeSteps); }
};

// The points of a surface, for a function of the library that calls nothing back but reads points all the time.
struct WatchedPoints {
  using Map = Surface::Property_map<Surface::Vertex_index, Point>;
  using key_type = Surface::Vertex_index;
  using value_type = Point;
  using reference = const Point&;
  using category = boost::lvalue_property_map_tag;

  friend const Point& get(const WatchedPoints& points, Surface::Vertex_index v) {
    points.work->count(1);
    return points.map[v];
  }
  friend void put(const WatchedPoints& points, Surface::Vertex_index v, const Point& p) { points.map[v] = p; }

  Map map;
  LibraryWork* work;
};

Point toPoint(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

struct Corners {
  int a, b, c;
  Corners(int i, int j, int k) : a(i), b(j), c(k) {}
};

std::vector<Corners> triangulate(const HoleContext& hole, bool cubic, LibraryWork& work) {
  std::vector<Point> points, apexes;
  // Moved near the origin: the weights are computed in floating point.
  const Vec3 origin = hole.points.front();
  for (const Vec3& p : hole.loop()) points.push_back(toPoint(p - origin));
  for (const Vec3& p : hole.apexes) apexes.push_back(toPoint(p - origin));
  std::vector<Corners> triangles;
  WatchingVisitor visitor{{}, &work};
  pmp::triangulate_hole_polyline(points, apexes, std::back_inserter(triangles),
                                 CGAL::parameters::use_delaunay_triangulation(!cubic)
                                     .do_not_use_cubic_algorithm(!cubic)
                                     .visitor(visitor)
                                     .use_2d_constrained_delaunay_triangulation(false));
  return triangles;
}

std::vector<Corners> triangulate(const HoleContext& hole, Progress progress) {
  if (hole.loopSize > tolerance::kLibraryFillEdges) return {};
  const QuietCgal quiet;
  std::vector<Corners> triangles;
  try {
    LibraryWork work(progress);
    triangles = triangulate(hole, false, work);
    if (triangles.empty() && hole.loopSize <= tolerance::kCubicFillEdges) triangles = triangulate(hole, true, work);
  } catch (const std::bad_alloc&) {
    throw;  // no other method helps against lack of memory
  } catch (const std::exception&) {
    triangles.clear();
  }
  return triangles;
}

// Estimates the number of triangles after refinement from the areas and the edge lengths at the corners.
double expectedTriangles(const HoleContext& hole, const Patch& patch, double density) {
  double n = 0.0;
  for (const Triangle& t : patch.triangles) {
    const Vec3 u = patch.points[t[1]] - patch.points[t[0]];
    const Vec3 v = patch.points[t[2]] - patch.points[t[0]];
    const double edge = (hole.edgeLength[t[0]] + hole.edgeLength[t[1]] + hole.edgeLength[t[2]]) / 3.0;
    n += 0.5 * u.cross(v).norm() / (0.43 * edge * edge);  // 0.43: area of the equilateral triangle of side 1
  }
  return n * (density / tolerance::kPatchDensity) * (density / tolerance::kPatchDensity);
}

// The density, or less: a hole in a dense scan, or one beside a tiny edge, must not take minutes or fill the memory.
// The number of triangles goes with the square of the density, and a patch has twice as many as new vertices.
double affordableDensity(const HoleContext& hole, const Patch& patch, double density) {
  const double vertices = std::min<double>(tolerance::kPatchVertices,
                                           tolerance::kPatchVerticesPerEdge * static_cast<double>(hole.loopSize));
  const double expected = expectedTriangles(hole, patch, density);
  return expected > 2.0 * vertices ? density * std::sqrt(2.0 * vertices / expected) : density;
}

// True when a vertex has so many faces that the library would take minutes to build it.
bool hasHugeFan(const HoleContext& hole) {
  std::vector<int> faces(hole.points.size(), 0);
  for (const Triangle& t : hole.ring) {
    for (std::uint32_t v : t) ++faces[v];
  }
  return std::any_of(faces.begin(), faces.end(), [](int n) { return n > tolerance::kLibraryFanFaces; });
}

constexpr double kRefinePart = 0.5;  // share of the progress if the patch is bent afterwards

struct Assembled {
  Surface surface;
  std::vector<Surface::Face_index> patchFaces;
};

// True when the faces at some vertex form more than one fan.
bool hasSeveralFans(const Surface& surface) {
  std::vector<bool> isSeen(surface.number_of_vertices(), false);
  for (const auto h : surface.halfedges()) {
    if (!surface.is_border(h)) continue;
    const std::size_t v = surface.target(h);
    if (isSeen[v]) return true;
    isSeen[v] = true;
  }
  return false;
}

// The ring and the patch as one surface; none when they are no manifold. Vertices keep their numbers: 0…n-1 are the
// loop's.
std::optional<Assembled> assemble(const HoleContext& hole, const Patch& patch, const Vec3& origin, LibraryWork& work) {
  Assembled result;
  for (const Vec3& p : hole.points) result.surface.add_vertex(toPoint(p - origin));
  for (const auto* list : {&hole.ring, &patch.triangles}) {
    for (const Triangle& t : *list) {
      using Vertex = Surface::Vertex_index;
      work.count(kFaceSteps);
      const auto f = CGAL::Euler::add_face(std::array{Vertex(t[0]), Vertex(t[1]), Vertex(t[2])}, result.surface);
      if (f == Surface::null_face()) return std::nullopt;
      if (list == &patch.triangles) result.patchFaces.push_back(f);
    }
  }
  if (hasSeveralFans(result.surface)) return std::nullopt;
  return result;
}

std::optional<Patch> toPatch(const HoleContext& hole, const Surface& surface,
                             const std::vector<Surface::Face_index>& faces, const Vec3& origin) {
  Patch patch;
  patch.loopSize = hole.loopSize;
  patch.points = hole.loop();
  std::vector<std::uint32_t> number(surface.number_of_vertices(), kNone);
  for (const auto f : faces) {
    Triangle t{};
    int k = 0;
    for (const auto v : CGAL::vertices_around_face(surface.halfedge(f), surface)) {
      const std::size_t i = v;
      if (i < hole.loopSize) {
        t[k++] = static_cast<std::uint32_t>(i);
        continue;
      }
      if (i < hole.points.size()) return std::nullopt;  // a vertex of the ring: not our patch any more
      if (number[i] == kNone) {
        number[i] = static_cast<std::uint32_t>(patch.points.size());
        const Point& p = surface.point(v);
        patch.points.push_back(Vec3(p.x(), p.y(), p.z()) + origin);
      }
      t[k++] = number[i];
    }
    patch.triangles.push_back(t);
  }
  return patch;
}

// Bends the patch so that it continues the ring; its triangles stay.
bool bend(const HoleContext& hole, Patch& patch, Continuity continuity, Progress progress) {
  const std::size_t n = hole.loopSize, known = hole.points.size();
  std::vector<Vec3> points = hole.points;
  points.insert(points.end(), patch.points.begin() + static_cast<std::ptrdiff_t>(n), patch.points.end());
  std::vector<Triangle> triangles = hole.ring;
  for (Triangle t : patch.triangles) {
    for (std::uint32_t& v : t) v = v < n ? v : static_cast<std::uint32_t>(v - n + known);
    triangles.push_back(t);
  }
  std::vector<bool> isFree(points.size(), false);
  std::fill(isFree.begin() + static_cast<std::ptrdiff_t>(known), isFree.end(), true);
  if (!fair(points, triangles, isFree, continuity, progress)) return false;
  std::copy(points.begin() + static_cast<std::ptrdiff_t>(known), points.end(),
            patch.points.begin() + static_cast<std::ptrdiff_t>(n));
  return true;
}

}  // namespace

std::optional<Patch> triangulateMinimal(const HoleContext& hole, Progress progress) {
  const std::vector<Corners> triangles = triangulate(hole, progress);
  if (triangles.empty()) return std::nullopt;
  Patch patch;
  patch.loopSize = hole.loopSize;
  patch.points = hole.loop();
  patch.method = FillMethod::Minimal;
  const int n = static_cast<int>(hole.loopSize);
  bool alongLoop = false;  // the library's triangles run as the loop does; ours must run against it
  for (const Corners& t : triangles) {
    for (const auto& [i, j] : {std::pair{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}) alongLoop |= j == (i + 1) % n;
    patch.triangles.push_back(
        {static_cast<std::uint32_t>(t.a), static_cast<std::uint32_t>(t.b), static_cast<std::uint32_t>(t.c)});
  }
  if (alongLoop) {
    for (Triangle& t : patch.triangles) std::swap(t[1], t[2]);
  }
  return patch;
}

std::optional<Patch> refinePatch(const HoleContext& hole, const Patch& start, std::optional<Continuity> bent,
                                 double density, Progress progress) {
  if (hasHugeFan(hole)) return std::nullopt;
  const QuietCgal quiet;
  const Vec3 origin = hole.points.front();
  try {
    LibraryWork work(bent ? progress.part(0.0, kRefinePart) : progress);
    std::optional<Assembled> assembled = assemble(hole, start, origin, work);
    if (!assembled) return std::nullopt;
    Surface& surface = assembled->surface;
    std::vector<Surface::Face_index> faces = assembled->patchFaces;
    std::vector<Surface::Face_index> newFaces;
    std::vector<Surface::Vertex_index> newVertices;
    pmp::refine(surface, faces, std::back_inserter(newFaces), std::back_inserter(newVertices),
                CGAL::parameters::density_control_factor(affordableDensity(hole, start, density))
                    .vertex_point_map(WatchedPoints{surface.points(), &work}));
    faces.insert(faces.end(), newFaces.begin(), newFaces.end());
    std::optional<Patch> patch = toPatch(hole, surface, faces, origin);
    if (!patch || (bent && !bend(hole, *patch, *bent, progress.part(kRefinePart, 1.0)))) return std::nullopt;
    patch->method = bent ? FillMethod::Fair : FillMethod::Refined;
    patch->bridges = start.bridges;
    return patch;
  } catch (const std::bad_alloc&) {
    throw;  // no other method helps against lack of memory
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace handwheel
