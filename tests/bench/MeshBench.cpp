// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/Bars.h"
#include "core/proximity/Surfaces.h"
#include "document/formats/MeshFormat.h"
#include "mesh/defects/Defects.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/search/FaceHierarchy.h"
#include "mesh/simplify/Decimation.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/Weld.h"
#include "support/MeshShapes.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>

#include <filesystem>
#include <fstream>

using namespace handwheel;
using bench::secondsOf;

namespace {

bench::Bars bars;

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

std::size_t verticesReadByVtk(const StlFile& file) {
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(file.path().c_str());
  reader->MergingOn();
  reader->Update();
  return static_cast<std::size_t>(reader->GetOutput()->GetNumberOfPoints());
}

// Compares one of our methods from the file to a number of vertices with VTK's reader, which merges equal points. Both
// run in the same process, in turns: "ratio" is the value to compare across machines.
void besideVtk(benchmark::State& state, const std::string& what, double bar,
               std::size_t (*vertices)(const MeshFile& file)) {
  const StlFile file(static_cast<int>(state.range(0)));
  const std::string besideReader = what + " of 1 M triangles, to VTK's STL reader with merging";
  bench::Fastest ours, theirs;
  bool isSame = true;
  for (auto _ : state) {
    std::size_t count = 0, theirCount = 0;
    const double seconds = secondsOf([&] { count = vertices(*readMeshFile(file.path(), {})); });
    state.SetIterationTime(seconds);
    ours.add(seconds);
    theirs.add(secondsOf([&] { theirCount = verticesReadByVtk(file); }));
    isSame = isSame && count > 0 && count == theirCount;
  }
  if (!isSame) return bars.failed(state, besideReader, "the numbers of vertices differ");
  state.counters["vtkMs"] = 1e3 * theirs.seconds;
  state.counters["ratio"] = ours.seconds / theirs.seconds;
  bars.atMost(besideReader, bar, ours.seconds / theirs.seconds);
}

void loadWeld(benchmark::State& state) {
  besideVtk(state, "load and weld", 1.0, [](const MeshFile& file) { return weld(file.soup).points.size(); });
}

// All defects but self-intersections.
void loadInspect(benchmark::State& state) {
  besideVtk(state, "load, topology and defects", 4.0, [](const MeshFile& file) {
    const HalfEdgeMesh mesh = buildMesh(file.soup).mesh;
    benchmark::DoNotOptimize(findDefects(mesh));
    return mesh.vertexSlots();
  });
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

void buildHierarchy(benchmark::State& state) {
  const HalfEdgeMesh mesh = buildMesh(test::icosphere(static_cast<int>(state.range(0)))).mesh;
  for (auto _ : state) {
    const HoleFiller filler(mesh);
    benchmark::DoNotOptimize(&filler);
  }
  state.counters["triangles"] = static_cast<double>(mesh.faceSlots());
}

// To a tenth of the triangles, by either method.
template <DecimationMethod method>
void decimateToATenth(benchmark::State& state) {
  const test::Surface sphere = test::sphere(static_cast<int>(state.range(0)), Vec3(10, 20, 30), 50.0, 0.1);
  const HalfEdgeMesh mesh = buildMesh({sphere.points, sphere.triangles}).mesh;
  for (auto _ : state) {
    HalfEdgeMesh copy = mesh;
    benchmark::DoNotOptimize(decimate(copy, {.faces = mesh.liveFaceCount() / 10, .method = method}));
  }
  state.counters["triangles"] = static_cast<double>(mesh.faceSlots());
}

// Rays from a camera's distance through points all over the model, as the mouse sends them. The bar is for the slowest
// in a thousand, so that a pause of the machine does not count.
void pick(benchmark::State& state) {
  const test::Surface sphere = test::sphere(static_cast<int>(state.range(0)), Vec3(10, 20, 30), 50.0, 0.1);
  const FaceHierarchy faces(buildMesh({sphere.points, sphere.triangles}).mesh);
  const Vec3 centre = faces.bounds().center();
  std::vector<double> times;
  std::size_t i = 0, missed = 0;
  for (auto _ : state) {
    const Vec3 target = centre + 0.5 * (sphere.points[(i++ * 7919) % sphere.points.size()] - centre);  // within
    const Vec3 eye = centre + 5.0 * Vec3(50, 20, -80 + static_cast<double>(i % 160));
    const double seconds = secondsOf([&] { missed += !faces.firstHit({eye, (target - eye).normalized()}); });
    state.SetIterationTime(seconds);
    times.push_back(seconds);
  }
  const std::string slowest = "picking on 2 M triangles, slowest of a thousand rays, ms";
  if (missed > 0) return bars.failed(state, slowest, std::to_string(missed) + " rays have missed");
  const auto slow = times.begin() + static_cast<std::ptrdiff_t>(times.size() * 999 / 1000);
  std::nth_element(times.begin(), slow, times.end());
  state.counters["slowUs"] = 1e6 * *slow;
  bars.atMost(slowest, 1.0, 1e3 * *slow);
}

}  // namespace

BENCHMARK(loadWeld)->Arg(354)->Unit(benchmark::kMillisecond)->UseManualTime()->MinTime(2.0);
BENCHMARK(loadInspect)->Arg(354)->Unit(benchmark::kMillisecond)->UseManualTime()->MinTime(4.0);
BENCHMARK(weldPoints)->Arg(382)->Unit(benchmark::kMillisecond);
BENCHMARK(linkFaces)->Arg(382)->Unit(benchmark::kMillisecond);
BENCHMARK(decimateToATenth<DecimationMethod::Bounded>)->Arg(112)->Unit(benchmark::kMillisecond);
BENCHMARK(decimateToATenth<DecimationMethod::Quadric>)->Arg(112)->Unit(benchmark::kMillisecond);
BENCHMARK(pick)->Arg(500)->Unit(benchmark::kMicrosecond)->UseManualTime();
BENCHMARK(buildHierarchy)->Arg(5)->Arg(7)->Unit(benchmark::kMillisecond);

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
