// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "bench/Bars.h"
#include "bench/LibraryHoles.h"
#include "document/formats/MeshFormat.h"
#include "mesh/boundary/BoundaryNeedles.h"
#include "mesh/boundary/BoundaryVertices.h"
#include "mesh/boundary/Stitching.h"
#include "mesh/defects/DuplicateFaces.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/repair/Cleaning.h"
#include "mesh/structure/MeshBuilder.h"
#include "proximity/TriangleHierarchy.h"
#include "support/CreasedShapes.h"
#include "support/MeshShapes.h"

#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>

using namespace handwheel;
using bench::fillByLibrary;
using bench::LibraryFill;
using bench::ratioTo;
using bench::toLibrary;

namespace {

bench::Bars bars;

// A fair patch with its check for intersections against the part, whose hierarchy is there already.
void fillHole(benchmark::State& state) {
  const double radius = 0.01 * static_cast<double>(state.range(0));
  TriangleSoup soup = test::withHole(test::icosphere(5), Vec3(1, 1, 1).normalized(), radius);
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  soup = mesh.compact().soup;  // without the points inside the hole
  const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
  const std::vector<Vec3> rim = loopPoints(mesh, loop);
  const HoleFiller filler(mesh);
  const bench::Surface surface = toLibrary(soup);
  double ours = 0.0, theirs = 0.0;
  std::size_t newFaces = 0, theirFaces = 0;
  bool isFair = true;
  for (auto _ : state) {
    const double milliseconds = cpuMilliseconds([&] {
      const FillAttempt attempt = filler.propose(loop, {});
      newFaces = attempt.patch.triangles.size();
      isFair = isFair && attempt.failure == FillFailure::None && attempt.patch.method == FillMethod::Fair;
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
  const std::string what =
      "fair fill of " + std::to_string(loop.halfEdges.size()) + " edges with its check, to CGAL's without";
  if (!isFair || theirFaces == 0) return bars.failed(state, what, isFair ? "not filled by CGAL" : "not filled fairly");
  if (edges <= 100.0) bars.atMost(what, 1.5, ours / theirs);
}

// Returns the value that at least this share of the values does not exceed.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size()))) - 1];
}

constexpr double kOpen = std::numeric_limits<double>::infinity();  // distance of a hole that stays open

double rms(const std::vector<Vec3>& points, const TriangleHierarchy& truth) {
  if (points.empty()) return kOpen;
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

std::vector<Vec3> pointsOf(const Patch& patch) {
  std::vector<Vec3> points(patch.points.begin() + static_cast<std::ptrdiff_t>(patch.loopSize), patch.points.end());
  for (const Triangle& t : patch.triangles) {
    if (patch.points.size() > patch.loopSize) break;
    points.push_back((patch.points[t[0]] + patch.points[t[1]] + patch.points[t[2]]) / 3.0);
  }
  return points;
}

// The closed part that the balls are cut out of.
struct Whole {
  const char* name;
  const char* file;  // in the folder HANDWHEEL_DATA; none: made
  bool hasBars;      // else CGAL's figures are the bar: of a thin blade with sharp edges they are far beyond them
};
constexpr Whole kWholes[] = {{"bumpy sphere", nullptr, true},
                             {"nefertiti", "scans/common-3d-test-models/nefertiti.obj", true},
                             {"turbine blade", "scans/pyvista-vtk-data/turbineblade.ply", false}};

// Empty without the file; then the bar says so.
TriangleSoup soupOf(const Whole& whole, benchmark::State& state, const std::string& what) {
  if (!whole.file) return test::bumpySphere(6);
  const char* folder = std::getenv("HANDWHEEL_DATA");
  if (!folder) return bars.missing(state, what, "HANDWHEEL_DATA is not set"), TriangleSoup();
  const std::string path = std::string(folder) + "/" + whole.file;
  if (!std::filesystem::exists(path)) return bars.missing(state, what, path + " is missing"), TriangleSoup();
  const Result<MeshFile> read = readMeshFile(path, {});
  if (!read) return bars.failed(state, what, path + " is refused"), TriangleSoup();
  return buildMesh(read->soup).mesh.compact().soup;
}

// RMS distances of patches from what was there, in diameters of their hole, of us and of CGAL. What stays open is
// infinitely far off.
struct Accuracy {
  std::vector<double> ours, theirs;
  double edges = 0.0;     // number of edges of all holes
  std::size_t holes = 0;  // one or more to a ball
  std::size_t unfilled = 0;
  std::size_t bare = 0;  // filled by us without a new vertex: a finer patch would cross the part
};

// Cuts a ball out and fills the holes that it leaves, each by itself.
void cutAndFill(const TriangleSoup& whole, const TriangleHierarchy& truth, const Vec3& centre, double radius,
                Accuracy& accuracy) {
  const HalfEdgeMesh mesh = buildMesh(test::withHole(whole, centre, radius)).mesh;
  const HoleFiller filler(mesh);
  const bench::Surface surface = toLibrary(mesh.compact().soup);
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh)) {
    const std::vector<Vec3> rim = loopPoints(mesh, loop);
    ++accuracy.holes;
    accuracy.edges += static_cast<double>(rim.size());
    const FillAttempt attempt = filler.propose(loop, {});
    const bool isOpen = attempt.failure != FillFailure::None;
    if (isOpen) {
      ++accuracy.unfilled;
      std::printf("  left open: hole %zu of %zu edges at (%g, %g, %g)\n", accuracy.holes, rim.size(), rim[0].x(),
                  rim[0].y(), rim[0].z());
    } else if (attempt.patch.points.size() == attempt.patch.loopSize) {
      ++accuracy.bare;
    }
    accuracy.ours.push_back(isOpen ? kOpen : rms(pointsOf(attempt.patch), truth) / diameter(rim));
    accuracy.theirs.push_back(rms(fillByLibrary(surface, rim[0], rim[1]).positions, truth) / diameter(rim));
  }
}

// At 25 positions the ratio of the medians of holes of 16 edges is 1.24, at 100 it is 0.97, and at 250 it is 0.96.
constexpr int kPositions = 100;

// Cuts out balls of some percent of the diagonal at many positions.
void accuracy(benchmark::State& state) {
  struct Bar {
    double median, p90;  // %; what CGAL comes to on nefertiti
  };
  static const std::map<std::int64_t, Bar> kBars{{1, {0.6, 2.2}}, {2, {0.55, 3.0}}, {4, {1.1, 3.2}}, {8, {1.4, 5.2}}};
  const Whole& whole = kWholes[state.range(0)];
  const std::string balls = std::string(whole.name) + ", balls of " + std::to_string(state.range(1)) + " %, RMS: ";
  const TriangleSoup soup = soupOf(whole, state, balls + "median and p90");
  if (soup.triangles.empty()) return;
  const TriangleHierarchy truth(soup.points, soup.triangles);
  const double radius = 0.01 * static_cast<double>(state.range(1)) * truth.bounds().diagonal().norm();
  Accuracy found;
  for (auto _ : state) {
    std::mt19937 random(1);
    found = {};
    for (int seed = 0; seed < kPositions; ++seed)
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
  if (whole.hasBars) {
    const Bar& bar = kBars.at(state.range(1));
    bars.atMost(balls + "median, % of the hole", bar.median, 100.0 * quantile(found.ours, 0.5));
    bars.atMost(balls + "p90, % of the hole", bar.p90, 100.0 * quantile(found.ours, 0.9));
  }
  bars.atMost(balls + "median, to CGAL's", 1.15, ratioTo(quantile(found.ours, 0.5), quantile(found.theirs, 0.5)));
  bars.atMost(balls + "p90, to CGAL's", 1.15, ratioTo(quantile(found.ours, 0.9), quantile(found.theirs, 0.9)));
}

// The root of the mean square distance of the triangles from the surface, by area, at the middles of 16 parts of each.
double rmsByArea(const std::vector<TrianglePoints>& triangles, double (*distance)(const Vec3&)) {
  constexpr int kCuts = 4;
  double squares = 0.0, area = 0.0;
  for (const TrianglePoints& t : triangles) {
    const Vec3 u = (t[1] - t[0]) / kCuts, v = (t[2] - t[0]) / kCuts;
    const double part = u.cross(v).norm();
    for (int i = 0; i < kCuts; ++i) {
      for (int j = 0; j < kCuts - i; ++j) {
        for (const double third : {1.0 / 3.0, 2.0 / 3.0}) {
          if (third > 0.5 && i + j + 1 == kCuts) continue;
          const double d = distance(t[0] + (i + third) * u + (j + third) * v);
          squares += part * d * d;
          area += part;
        }
      }
    }
  }
  return std::sqrt(squares / area);
}

std::vector<TrianglePoints> trianglesOf(const Patch& patch) {
  std::vector<TrianglePoints> triangles;
  for (const Triangle& t : patch.triangles)
    triangles.push_back({patch.points[t[0]], patch.points[t[1]], patch.points[t[2]]});
  return triangles;
}

// A part with sharp edges, its exact surface, and positions on and beside an edge.
struct Creased {
  const char* name;
  TriangleSoup soup;
  double (*distance)(const Vec3&);
  Vec3 (*position)(std::mt19937& random);
};

double unit(std::mt19937& random) {
  return random() / 4294967296.0;
}

Creased creased(std::int64_t which) {
  if (which == 0) {
    return {"cube", test::roughCube(24, 7), test::distanceToCube, [](std::mt19937& random) {
              const double x = random() % 2 ? 1.0 : -1.0;
              return Vec3(x + 0.2 * (unit(random) - 0.5), 1.0 + 0.2 * (unit(random) - 0.5), unit(random) - 0.5);
            }};
  }
  return {"cylinder", test::roughCylinder(120, 7), test::distanceToCylinder, [](std::mt19937& random) {
            const double turn = 2.0 * M_PI * unit(random), r = 1.0 + 0.2 * (unit(random) - 0.5);
            return Vec3(r * std::cos(turn), r * std::sin(turn), 1.0 + 0.2 * (unit(random) - 0.5));
          }};
}

// Cuts out balls across a sharp edge at 25 positions. Each hole is filled with ridges, without, and by CGAL, and each
// patch is compared with the exact part. Holes that stay open count as infinitely far off.
void ridges(benchmark::State& state) {
  const Creased part = creased(state.range(0));
  const double radius = 0.01 * static_cast<double>(state.range(1));
  std::vector<double> withCreases, fair, library;
  std::size_t open = 0, noRidge = 0, fairOpen = 0, libraryOpen = 0;
  for (auto _ : state) {
    std::mt19937 random(1);
    for (int seed = 0; seed < 25; ++seed) {
      const HalfEdgeMesh mesh = buildMesh(test::withHole(part.soup, part.position(random), radius)).mesh;
      const HoleFiller filler(mesh);
      const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
      const std::vector<Vec3> rim = loopPoints(mesh, loop);
      const double size = diameter(rim);
      const auto errorOf = [&](const FillAttempt& attempt) {
        return attempt.failure == FillFailure::None ? rmsByArea(trianglesOf(attempt.patch), part.distance) / size
                                                    : kOpen;
      };
      FillOptions options;
      fair.push_back(errorOf(filler.propose(loop, options)));
      options.method = FillMethod::Crease;
      const FillAttempt attempt = filler.propose(loop, options);
      withCreases.push_back(errorOf(attempt));
      noRidge += attempt.failure == FillFailure::None && attempt.patch.method != FillMethod::Crease;
      const LibraryFill theirs = fillByLibrary(toLibrary(mesh.compact().soup), rim[0], rim[1]);
      library.push_back(theirs.faces > 0 ? rmsByArea(theirs.triangles, part.distance) / size : kOpen);
      open += withCreases.back() == kOpen;
      fairOpen += fair.back() == kOpen;
      libraryOpen += library.back() == kOpen;
    }
  }
  state.SetLabel(part.name);
  for (const auto& [counter, count] :
       {std::pair{"open", open}, {"noRidge", noRidge}, {"fairOpen", fairOpen}, {"cgalOpen", libraryOpen}}) {
    state.counters[counter] = static_cast<double>(count);
  }
  const double ours = quantile(withCreases, 0.9), plain = quantile(fair, 0.9), theirs = quantile(library, 0.9);
  state.counters["median%"] = 100.0 * quantile(withCreases, 0.5);
  state.counters["p90%"] = 100.0 * ours;
  state.counters["fairP90%"] = 100.0 * plain;
  state.counters["cgalP90%"] = 100.0 * theirs;
  const std::string what = std::string(part.name) + ", balls of " + std::to_string(radius).substr(0, 4) +
                           " across its edge, ridge, RMS: p90, to ";
  bars.atMost(what + "fair", 0.5, ratioTo(ours, plain));
  bars.atMost(what + "CGAL's fair", 0.5, ratioTo(ours, theirs));
}

// Four cuts of 2,554 edges each, ragged, in a scan of a package.
void longLoops(benchmark::State& state) {
  const std::string path = "/usr/share/opencascade/data/stl/head.stl";
  const std::string slowestOfFour = "fill of a loop of 2,554 edges, slowest of four, ms of CPU";
  if (!std::filesystem::exists(path))
    return bars.skipped(state, slowestOfFour, "head.stl of the package occt-misc is not installed");
  HalfEdgeMesh mesh = buildMesh(readMeshFile(path, {}).value().soup).mesh;
  removeDegenerateFaces(mesh);
  removeDuplicateFaces(mesh);
  removeFlaps(mesh);
  stitchBoundaries(mesh, std::vector<bool>(mesh.vertexSlots(), false));
  removeDegenerateFaces(mesh);
  for (const Face f : findBoundaryNeedles(mesh, findBoundaryLoops(mesh), nearWeldReach(mesh))) mesh.removeFace(f);
  const HoleFiller filler(mesh);
  std::vector<BoundaryLoop> cuts;
  for (BoundaryLoop& loop : findBoundaryLoops(mesh)) {
    if (loop.halfEdges.size() > 2000) cuts.push_back(std::move(loop));
  }
  if (cuts.size() != 4) return bars.failed(state, slowestOfFour, std::to_string(cuts.size()) + " loops were found");
  double slowest = 0.0, ours = 0.0, oursBeside = 0.0, theirs = 0.0;  // beside: of loops that the library fills, too
  std::size_t givenUp = 0, open = 0;
  for (auto _ : state) {
    for (const BoundaryLoop& loop : cuts) {
      FillAttempt attempt;
      const double milliseconds = cpuMilliseconds([&] { attempt = filler.propose(loop, {}); });
      open += attempt.failure != FillFailure::None;
      slowest = std::max(slowest, milliseconds);
      ours += milliseconds;
      const bench::LibraryTriangulation library = bench::triangulateByLibrary(loopPoints(mesh, loop));
      givenUp += library.triangles == 0;
      if (library.triangles == 0) continue;
      oursBeside += milliseconds;
      theirs += library.milliseconds;
    }
  }
  const auto fills = static_cast<double>(state.iterations()) * static_cast<double>(cuts.size());
  state.counters["loops"] = static_cast<double>(cuts.size());
  state.counters["ms"] = ours / fills;
  state.counters["cgalDelaunayMs"] = theirs / fills;
  state.counters["cgalGivenUp"] = static_cast<double>(givenUp) / static_cast<double>(state.iterations());
  if (open > 0) return bars.failed(state, slowestOfFour, "left open");
  bars.atMost(slowestOfFour, 100.0, slowest);
  // The library's triangles are neither refined nor bent nor checked, as our patches are.
  const std::string besideLibrary = "fair fill of loops of 2,554 edges with its check, to CGAL's Delaunay search alone";
  if (theirs == 0.0) return bars.skipped(state, besideLibrary, "it gave up on all of them");
  bars.atMost(besideLibrary, 20.0, oursBeside / theirs);
}

}  // namespace

BENCHMARK(fillHole)->Arg(20)->Arg(55)->Arg(80)->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(accuracy)
    ->ArgsProduct({{0, 1, 2}, {1, 2, 4, 8}})  // kWholes; % of the diagonal
    ->ArgNames({"on", "percent"})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK(ridges)
    ->ArgsProduct({{0, 1}, {20, 35}})  // cube or cylinder; % of half its width
    ->ArgNames({"on", "percent"})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK(longLoops)->Unit(benchmark::kMillisecond)->Iterations(2);

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
