// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/CgalHoleFilling.h"

#include "base/Tolerance.h"
#include "mesh/structure/QuietCgal.h"

#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
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

// For the library's triangulation, which calls it back in its loops.
struct WatchingVisitor : pmp::Hole_filling::Default_visitor {
  LibraryWork* work;
  void quadratic_step() const { work->count(kEdgeSteps); }
  void cubic_step() const { work->count(kEdgeSteps); }
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

}  // namespace handwheel
