// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "bench/Bars.h"
#include "document/formats/MeshFormat.h"
#include "mesh/Cleaning.h"
#include "mesh/DuplicateFaces.h"
#include "mesh/HoleFilling.h"
#include "mesh/MeshBuilder.h"
#include "mesh/Stitching.h"
#include "proximity/TriangleHierarchy.h"
#include "support/MeshShapes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include <filesystem>
#include <random>

using namespace handwheel;

namespace {

bench::Bars bars;

namespace pmp = CGAL::Polygon_mesh_processing;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

Surface toLibrary(const TriangleSoup& soup) {
  std::vector<Point> points;
  for (const Vec3& p : soup.points) points.emplace_back(p.x(), p.y(), p.z());
  Surface surface;
  pmp::polygon_soup_to_polygon_mesh(points, soup.triangles, surface);
  return surface;
}

struct LibraryFill {
  double milliseconds = 0.0;
  std::size_t faces = 0;
  std::vector<Vec3> points;  // new ones
};

// The library alone: no check for intersections, no other method to fall back to.
LibraryFill fillByLibrary(Surface surface) {
  LibraryFill result;
  std::vector<Surface::Halfedge_index> borders;
  pmp::extract_boundary_cycles(surface, std::back_inserter(borders));
  std::vector<Surface::Face_index> faces;
  std::vector<Surface::Vertex_index> vertices;
  result.milliseconds = cpuMilliseconds([&] {
    pmp::triangulate_refine_and_fair_hole(surface, borders.front(), std::back_inserter(faces),
                                          std::back_inserter(vertices));
  });
  result.faces = faces.size();
  for (const auto v : vertices) {
    const Point& p = surface.point(v);
    result.points.emplace_back(p.x(), p.y(), p.z());
  }
  return result;
}

// A fair patch with its check for intersections against the part, whose hierarchy is there already.
void fillHole(benchmark::State& state) {
  const double radius = 0.01 * static_cast<double>(state.range(0));
  TriangleSoup soup = test::withHole(test::icosphere(5), Vec3(1, 1, 1).normalized(), radius);
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  soup = mesh.compact().soup;  // without the points inside the hole
  const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
  const HoleFiller filler(mesh);
  const Surface surface = toLibrary(soup);
  double ours = 0.0, theirs = 0.0;
  std::size_t newFaces = 0, theirFaces = 0;
  for (auto _ : state) {
    const double milliseconds = cpuMilliseconds([&] {
      const FillAttempt attempt = filler.propose(loop, {});
      newFaces = attempt.patch.triangles.size();
      if (attempt.patch.method != FillMethod::Fair) state.SkipWithError("not filled fairly");
    });
    state.SetIterationTime(1e-3 * milliseconds);
    ours += milliseconds;
    const LibraryFill library = fillByLibrary(surface);
    theirs += library.milliseconds;
    theirFaces = library.faces;
  }
  const auto edges = static_cast<double>(loop.halfEdges.size());
  state.counters["edges"] = edges;
  state.counters["newFaces"] = static_cast<double>(newFaces);
  state.counters["cgalFaces"] = static_cast<double>(theirFaces);
  state.counters["cgalMs"] = theirs / static_cast<double>(state.iterations());
  state.counters["ratio"] = ours / theirs;
  if (edges <= 100.0) {
    bars.atMost("fair fill of " + std::to_string(loop.halfEdges.size()) + " edges with its check, to CGAL's without",
                1.5, ours / theirs);
  }
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? std::nan("") : values[values.size() / 2];
}

double rms(const std::vector<Vec3>& points, const TriangleHierarchy& truth) {
  double squares = 0.0;
  for (const Vec3& p : points) squares += (truth.nearest(p)->point - p).squaredNorm();
  return points.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(points.size()));
}

// Balls cut out of a bumpy sphere at 25 places: how far the new vertices are from what was there, beside CGAL's.
void accuracy(benchmark::State& state) {
  const TriangleSoup whole = test::bumpySphere(6);
  const TriangleHierarchy truth(whole.points, whole.triangles);
  const double radius = 0.01 * static_cast<double>(state.range(0)) * truth.bounds().diagonal().norm();
  std::vector<double> ours, theirs;
  for (auto _ : state) {
    std::mt19937 random(1);
    ours.clear();
    theirs.clear();
    for (int seed = 0; seed < 25; ++seed) {
      const Vec3 centre = whole.points[random() % whole.points.size()];
      const HalfEdgeMesh mesh = buildMesh(test::withHole(whole, centre, radius)).mesh;
      const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
      if (loops.size() != 1) continue;
      const double size = loops[0].box.diagonal().norm();
      const FillAttempt attempt = HoleFiller(mesh).propose(loops[0], {});
      const auto firstNew = attempt.patch.points.begin() + static_cast<std::ptrdiff_t>(attempt.patch.loopSize);
      ours.push_back(rms({firstNew, attempt.patch.points.end()}, truth) / size);
      theirs.push_back(rms(fillByLibrary(toLibrary(mesh.compact().soup)).points, truth) / size);
    }
  }
  state.counters["percent"] = 100.0 * median(ours);
  state.counters["cgalPercent"] = 100.0 * median(theirs);
  bars.atMost("median RMS of patches, balls of " + std::to_string(state.range(0)) + " % of the diagonal, to CGAL's",
              1.15, median(ours) / median(theirs));
}

// Four cuts of 2,554 edges each, ragged, in a scan of a package; CGAL needs 90 s for one of them.
void longLoops(benchmark::State& state) {
  const std::string path = "/usr/share/opencascade/data/stl/head.stl";
  if (!std::filesystem::exists(path)) return state.SkipWithError("head.stl of the package occt-misc is not installed");
  HalfEdgeMesh mesh = buildMesh(readMeshFile(path, {}).value().soup).mesh;
  removeDegenerateFaces(mesh);
  removeDuplicateFaces(mesh);
  removeFlaps(mesh);
  stitchBorders(mesh, std::vector<bool>(mesh.vertexSlots(), false));
  removeDegenerateFaces(mesh);
  const HoleFiller filler(mesh);
  std::vector<BoundaryLoop> cuts;
  for (BoundaryLoop& loop : findBoundaryLoops(mesh)) {
    if (loop.halfEdges.size() > 2000) cuts.push_back(std::move(loop));
  }
  double slowest = 0.0;
  for (auto _ : state) {
    for (const BoundaryLoop& loop : cuts) {
      FillAttempt attempt;
      const double milliseconds = cpuMilliseconds([&] { attempt = filler.propose(loop, {}); });
      if (attempt.failure != FillFailure::None) state.SkipWithError("not filled");
      slowest = std::max(slowest, milliseconds);
    }
  }
  state.counters["loops"] = static_cast<double>(cuts.size());
  bars.atMost("fill of a loop of 2,554 edges, slowest of four, ms of CPU", 100.0, slowest);
}

}  // namespace

BENCHMARK(fillHole)->Arg(20)->Arg(55)->Arg(80)->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(accuracy)->Arg(1)->Arg(2)->Arg(4)->Arg(8)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(longLoops)->Unit(benchmark::kMillisecond)->Iterations(2);

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
