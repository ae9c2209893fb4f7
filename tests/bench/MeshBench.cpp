// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/proximity/Surfaces.h"
#include "document/formats/MeshFormat.h"
#include "mesh/HoleFilling.h"
#include "mesh/MeshBuilder.h"
#include "mesh/Weld.h"
#include "support/MeshShapes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <benchmark/benchmark.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>

#include <chrono>
#include <filesystem>
#include <fstream>

using namespace handwheel;

namespace {

double secondsOf(auto&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// A binary STL of a closed bumpy sphere with 8 n² triangles; gone with this.
class StlFile {
 public:
  explicit StlFile(int n)
      : m_path(std::filesystem::temp_directory_path() / ("handwheel-bench-" + std::to_string(n) + ".stl")) {
    const test::Surface sphere = test::sphere(n, Vec3(10, 20, 30), 50.0, 0.1);
    std::ofstream(m_path, std::ios::binary)
        << writeMesh({sphere.points, sphere.triangles}, MeshFormat::Stl, NumberType::Float32);
  }
  ~StlFile() { std::filesystem::remove(m_path); }
  StlFile(const StlFile&) = delete;
  StlFile& operator=(const StlFile&) = delete;

  std::string path() const { return m_path.string(); }

 private:
  std::filesystem::path m_path;
};

// From the file to the half-edge mesh, beside VTK's reader, which only merges equal points. Both in the same run:
// "timesFaster" is what to compare across machines.
void loadWeldBuild(benchmark::State& state) {
  const StlFile file(static_cast<int>(state.range(0)));
  double ours = 0.0, building = 0.0, theirs = 0.0;
  std::size_t triangles = 0;
  for (auto _ : state) {
    std::size_t vertices = 0, theirVertices = 0;
    const double seconds = secondsOf([&] {
      Result<MeshFile> read = readMeshFile(file.path(), {});
      building += secondsOf([&] {
        const BuiltMesh built = buildMesh(read->soup);
        triangles = built.mesh.faceSlots();
        vertices = built.mesh.vertexSlots();
      });
    });
    state.SetIterationTime(seconds);
    ours += seconds;
    theirs += secondsOf([&] {
      vtkNew<vtkSTLReader> reader;
      reader->SetFileName(file.path().c_str());
      reader->MergingOn();
      reader->Update();
      theirVertices = static_cast<std::size_t>(reader->GetOutput()->GetNumberOfPoints());
    });
    if (vertices != theirVertices) state.SkipWithError("the numbers of vertices differ");
  }
  const auto runs = static_cast<double>(state.iterations());
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["buildMs"] = 1e3 * building / runs;
  state.counters["vtkMs"] = 1e3 * theirs / runs;
  state.counters["timesFaster"] = theirs / ours;
}

// The two halves of building.
void weldPoints(benchmark::State& state) {
  const test::Surface sphere = test::sphere(static_cast<int>(state.range(0)));
  const TriangleSoup soup = test::unshared({sphere.points, sphere.triangles});
  for (auto _ : state) benchmark::DoNotOptimize(weld(soup));
}

void linkFaces(benchmark::State& state) {
  const test::Surface sphere = test::sphere(static_cast<int>(state.range(0)));
  const HalfEdgeMesh mesh = buildMesh({sphere.points, sphere.triangles}).mesh;
  for (auto _ : state) {
    HalfEdgeMesh copy = mesh;
    benchmark::DoNotOptimize(relink(copy));
  }
}

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

// The library alone: no check for intersections, no other method to fall back to.
double fillByLibrary(Surface surface, std::size_t& newFaces) {
  std::vector<Surface::Halfedge_index> borders;
  pmp::extract_boundary_cycles(surface, std::back_inserter(borders));
  std::vector<Surface::Face_index> faces;
  std::vector<Surface::Vertex_index> vertices;
  const double seconds = secondsOf([&] {
    pmp::triangulate_refine_and_fair_hole(surface, borders.front(), std::back_inserter(faces),
                                          std::back_inserter(vertices));
  });
  newFaces = faces.size();
  return seconds;
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
    const double seconds = secondsOf([&] {
      const FillAttempt attempt = filler.propose(loop, {});
      newFaces = attempt.patch.triangles.size();
      if (attempt.patch.method != FillMethod::Fair) state.SkipWithError("not filled fairly");
    });
    state.SetIterationTime(seconds);
    ours += seconds;
    theirs += fillByLibrary(surface, theirFaces);
  }
  state.counters["edges"] = static_cast<double>(loop.halfEdges.size());
  state.counters["newFaces"] = static_cast<double>(newFaces);
  state.counters["cgalFaces"] = static_cast<double>(theirFaces);
  state.counters["cgalMs"] = 1e3 * theirs / static_cast<double>(state.iterations());
  state.counters["timesAsLong"] = ours / theirs;
}

void buildHierarchy(benchmark::State& state) {
  const HalfEdgeMesh mesh = buildMesh(test::icosphere(static_cast<int>(state.range(0)))).mesh;
  for (auto _ : state) {
    const HoleFiller filler(mesh);
    benchmark::DoNotOptimize(&filler);
  }
  state.counters["triangles"] = static_cast<double>(mesh.faceSlots());
}

}  // namespace

BENCHMARK(loadWeldBuild)->Arg(100)->Arg(382)->Unit(benchmark::kMillisecond)->UseManualTime()->MinTime(2.0);
BENCHMARK(weldPoints)->Arg(382)->Unit(benchmark::kMillisecond);
BENCHMARK(linkFaces)->Arg(382)->Unit(benchmark::kMillisecond);
BENCHMARK(fillHole)->Arg(20)->Arg(55)->Arg(80)->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(buildHierarchy)->Arg(5)->Arg(7)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
