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
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <filesystem>
#include <map>
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
  std::vector<Triangle> triangles = soup.triangles;
  if (!pmp::is_polygon_soup_a_polygon_mesh(triangles)) pmp::orient_polygon_soup(points, triangles);  // pinched holes
  Surface surface;
  pmp::polygon_soup_to_polygon_mesh(points, triangles, surface);
  return surface;
}

struct LibraryFill {
  double milliseconds = 0.0;
  std::size_t faces = 0;
  std::vector<Vec3> places;  // new vertices; where there are none, the middles of the faces
};

Vec3 toVec3(const Point& p) {
  return {p.x(), p.y(), p.z()};
}

// The side of the edge a-b that has no face.
Surface::Halfedge_index borderEdge(const Surface& surface, const Vec3& a, const Vec3& b) {
  for (const auto h : surface.halfedges()) {
    if (!surface.is_border(h)) continue;
    const Vec3 from = toVec3(surface.point(surface.source(h))), to = toVec3(surface.point(surface.target(h)));
    if ((from == a && to == b) || (from == b && to == a)) return h;
  }
  return Surface::null_halfedge();
}

// The library alone: no check for intersections, no other method to fall back to. The hole is the one with the edge
// a-b.
LibraryFill fillByLibrary(Surface surface, const Vec3& a, const Vec3& b) {
  LibraryFill result;
  const Surface::Halfedge_index border = borderEdge(surface, a, b);
  std::vector<Surface::Face_index> faces;
  std::vector<Surface::Vertex_index> vertices;
  result.milliseconds = cpuMilliseconds([&] {
    pmp::triangulate_refine_and_fair_hole(surface, border, std::back_inserter(faces), std::back_inserter(vertices));
  });
  result.faces = faces.size();
  for (const auto v : vertices) result.places.push_back(toVec3(surface.point(v)));
  for (const auto f : faces) {
    if (!vertices.empty()) break;
    Vec3 sum = Vec3::Zero();
    for (const auto v : surface.vertices_around_face(surface.halfedge(f))) sum += toVec3(surface.point(v));
    result.places.push_back(sum / 3.0);
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
  const std::vector<Vec3> rim = loopPoints(mesh, loop);
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
    const LibraryFill library = fillByLibrary(surface, rim[0], rim[1]);
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

// Of at least so large a share of the values none is larger.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size()))) - 1];
}

double rms(const std::vector<Vec3>& points, const TriangleHierarchy& truth) {
  double squares = 0.0;
  for (const Vec3& p : points) squares += truth.nearest(p)->squaredDistance;
  return std::sqrt(squares / static_cast<double>(points.size()));
}

double diameter(const std::vector<Vec3>& points) {
  double squared = 0.0;
  for (const Vec3& a : points) {
    for (const Vec3& b : points) squared = std::max(squared, (a - b).squaredNorm());
  }
  return std::sqrt(squared);
}

std::vector<Vec3> placesOf(const Patch& patch) {
  std::vector<Vec3> places(patch.points.begin() + static_cast<std::ptrdiff_t>(patch.loopSize), patch.points.end());
  for (const Triangle& t : patch.triangles) {
    if (patch.points.size() > patch.loopSize) break;
    places.push_back((patch.points[t[0]] + patch.points[t[1]] + patch.points[t[2]]) / 3.0);
  }
  return places;
}

// What the balls are cut out of, closed.
struct Whole {
  const char* name;
  const char* file;  // in the folder HANDWHEEL_DATA; none: made
  bool hasBars;      // else CGAL's figures are the bar: of a thin blade with sharp edges they are far beyond them
};
constexpr Whole kWholes[] = {{"bumpy sphere", nullptr, true},
                             {"nefertiti", "scans/common-3d-test-models/nefertiti.obj", true},
                             {"turbine blade", "scans/pyvista-vtk-data/turbineblade.ply", false}};

// Empty without the file; then the benchmark says so.
TriangleSoup soupOf(const Whole& whole, benchmark::State& state) {
  if (!whole.file) return test::bumpySphere(6);
  const char* folder = std::getenv("HANDWHEEL_DATA");
  if (!folder) return state.SkipWithError("HANDWHEEL_DATA is not set"), TriangleSoup();
  const std::string path = std::string(folder) + "/" + whole.file;
  if (!std::filesystem::exists(path)) return state.SkipWithError((path + " is missing").c_str()), TriangleSoup();
  return buildMesh(readMeshFile(path, {}).value().soup).mesh.compact().soup;
}

// RMS distances of patches from what was there, in diameters of their hole, of us and of CGAL.
struct Accuracy {
  std::vector<double> ours, theirs;
  double edges = 0.0;     // of all holes
  std::size_t holes = 0;  // one or more to a ball
  std::size_t unfilled = 0;
  std::size_t bare = 0;  // filled by us without a new vertex: a finer patch would cross the part
};

// Cuts a ball out and fills the holes that it leaves, each by itself.
void cutAndFill(const TriangleSoup& whole, const TriangleHierarchy& truth, const Vec3& centre, double radius,
                Accuracy& accuracy) {
  const HalfEdgeMesh mesh = buildMesh(test::withHole(whole, centre, radius)).mesh;
  const HoleFiller filler(mesh);
  const Surface surface = toLibrary(mesh.compact().soup);
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh)) {
    const std::vector<Vec3> rim = loopPoints(mesh, loop);
    ++accuracy.holes;
    accuracy.edges += static_cast<double>(rim.size());
    const FillAttempt attempt = filler.propose(loop, {});
    if (attempt.failure != FillFailure::None) {
      ++accuracy.unfilled;
      continue;
    }
    if (attempt.patch.points.size() == attempt.patch.loopSize) ++accuracy.bare;
    accuracy.ours.push_back(rms(placesOf(attempt.patch), truth) / diameter(rim));
    accuracy.theirs.push_back(rms(fillByLibrary(surface, rim[0], rim[1]).places, truth) / diameter(rim));
  }
}

// Balls of some percent of the diagonal, cut out at 25 places.
void accuracy(benchmark::State& state) {
  struct Bar {
    double median, p90;  // %; what CGAL comes to on nefertiti
  };
  static const std::map<std::int64_t, Bar> kBars{{1, {0.6, 2.2}}, {2, {0.55, 3.0}}, {4, {1.1, 3.2}}, {8, {1.4, 5.2}}};
  const Whole& whole = kWholes[state.range(0)];
  const TriangleSoup soup = soupOf(whole, state);
  if (soup.triangles.empty()) return;
  const TriangleHierarchy truth(soup.points, soup.triangles);
  const double radius = 0.01 * static_cast<double>(state.range(1)) * truth.bounds().diagonal().norm();
  Accuracy found;
  for (auto _ : state) {
    std::mt19937 random(1);
    found = {};
    for (int seed = 0; seed < 25; ++seed)
      cutAndFill(soup, truth, soup.points[random() % soup.points.size()], radius, found);
  }
  state.SetLabel(whole.name);
  state.counters["edges"] = found.edges / static_cast<double>(found.holes);
  state.counters["holes"] = static_cast<double>(found.holes);
  state.counters["unfilled"] = static_cast<double>(found.unfilled);
  state.counters["bare"] = static_cast<double>(found.bare);
  state.counters["median%"] = 100.0 * quantile(found.ours, 0.5);
  state.counters["cgalMedian%"] = 100.0 * quantile(found.theirs, 0.5);
  state.counters["p90%"] = 100.0 * quantile(found.ours, 0.9);
  state.counters["cgalP90%"] = 100.0 * quantile(found.theirs, 0.9);
  const std::string balls = std::string(whole.name) + ", balls of " + std::to_string(state.range(1)) + " %, RMS: ";
  if (whole.hasBars) {
    const Bar& bar = kBars.at(state.range(1));
    bars.atMost(balls + "median, % of the hole", bar.median, 100.0 * quantile(found.ours, 0.5));
    bars.atMost(balls + "p90, % of the hole", bar.p90, 100.0 * quantile(found.ours, 0.9));
  }
  bars.atMost(balls + "median, to CGAL's", 1.15, quantile(found.ours, 0.5) / quantile(found.theirs, 0.5));
  bars.atMost(balls + "p90, to CGAL's", 1.15, quantile(found.ours, 0.9) / quantile(found.theirs, 0.9));
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
BENCHMARK(accuracy)
    ->ArgsProduct({{0, 1, 2}, {1, 2, 4, 8}})  // kWholes; % of the diagonal
    ->ArgNames({"on", "percent"})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK(longLoops)->Unit(benchmark::kMillisecond)->Iterations(2);

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
