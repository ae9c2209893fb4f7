// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Repairs the defective scans in HANDWHEEL_DATA by triangles, by volume, and by CGAL's alpha wrap, one after the other:
// what is sound, how far 99 % of the scan's area is from it in voxels, triangles, seconds. HANDWHEEL_SCAN names one
// scan by a part of its path. Some ten minutes.
#include "bench/Bars.h"
#include "document/formats/MeshFormat.h"
#include "mesh/defects/MeshReport.h"
#include "mesh/measure/Deviation.h"
#include "mesh/repair/Repair.h"
#include "mesh/structure/MeshBuilder.h"
#include "support/MeshShapes.h"
#include "volume/SurfaceToVolume.h"
#include "volume/repair/VolumeRepair.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <filesystem>
#include <set>

using namespace handwheel;

namespace {

constexpr double kVoxels = 128.0;              // across the largest extent
constexpr std::size_t kLeastFaces = 200;       // files with fewer faces test readers, and are no scans
constexpr double kAlpha = 4.0, kOffset = 0.5;  // parameters of the wrap, voxels

bench::Bars bars;

struct Outcome {
  bool isSound = false;
  double distance = std::nan("");  // voxels
  std::size_t faces = 0;
  double seconds = 0.0;

  void judge(const HalfEdgeMesh& mesh, const HalfEdgeMesh& scan, double voxel) {
    const TriangleSoup soup = mesh.compact().soup;
    faces = soup.triangles.size();
    isSound = faces > 0 && reportOn(soup, SelfIntersections::Count).isSound();
    if (const auto measured = deviation(mesh, scan, {.samples = 20'000}))
      distance = measured->ofScan.percentiles.back() / voxel;
  }
  void print() const { std::printf(" | %-5s %7.3f %7zu %6.1f", isSound ? "sound" : "NO", distance, faces, seconds); }
};

HalfEdgeMesh alphaWrap(const TriangleSoup& soup, double voxel) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point> points;
  for (const Vec3& p : soup.points) points.emplace_back(p.x(), p.y(), p.z());
  CGAL::Surface_mesh<Point> wrap;
  CGAL::alpha_wrap_3(points, soup.triangles, kAlpha * voxel, kOffset * voxel, wrap);
  TriangleSoup made;
  for (const auto v : wrap.vertices())
    made.points.emplace_back(wrap.point(v).x(), wrap.point(v).y(), wrap.point(v).z());
  for (const auto f : wrap.faces()) {
    Triangle t;
    std::size_t k = 0;
    for (const auto v : vertices_around_face(wrap.halfedge(f), wrap)) t[k++] = static_cast<std::uint32_t>(v);
    made.triangles.push_back(t);
  }
  return buildMesh(made).mesh;
}

struct Counts {
  int defective = 0, byTriangles = 0, byVolume = 0, byWrap = 0, far = 0;
  int lost = 0;     // sound by triangles and not by volume
  int refused = 0;  // refused by our reader, and so not repaired
  double volumeSeconds = 0.0, wrapSeconds = 0.0;
};

void measure(const std::string& name, const TriangleSoup& soup, Counts& counts) {
  const HalfEdgeMesh scan = buildMesh(soup).mesh;
  const double voxel = usualVoxel(soup) * 256.0 / kVoxels;
  Outcome triangles, volume, wrap;
  HalfEdgeMesh repaired = scan;
  triangles.seconds = bench::secondsOf([&] { repair(repaired, {}); });
  triangles.judge(repaired, scan, voxel);
  std::optional<Result<VolumeRepair>> made;
  volume.seconds = bench::secondsOf([&] { made = repairByVolume(scan.compact().soup, {.voxel = voxel}); });
  double kept = std::nan("");
  if (*made) {
    volume.judge((*made)->mesh, scan, voxel);
    kept = (*made)->keptDistance / voxel;
  }
  HalfEdgeMesh wrapped;
  wrap.seconds = bench::secondsOf([&] { wrapped = alphaWrap(scan.compact().soup, voxel); });
  wrap.judge(wrapped, scan, voxel);
  std::printf("%-44s", name.c_str());
  triangles.print();
  volume.print();
  wrap.print();
  std::printf(" | kept %.2f%s\n", kept, *made ? "" : (" " + std::string(made->error().code->id)).c_str());
  std::fflush(stdout);
  ++counts.defective;
  counts.byTriangles += triangles.isSound;
  counts.byVolume += volume.isSound;
  counts.byWrap += wrap.isSound;
  counts.lost += triangles.isSound && !volume.isSound;
  counts.far += volume.isSound && kept > 1.0;
  counts.volumeSeconds += volume.seconds;
  counts.wrapSeconds += wrap.seconds;
}

// Returns true if the format is read, and the file is not one of those damaged on purpose.
bool isScan(const std::filesystem::path& path) {
  return formatForName(path.filename().string()) && path.string().find("/malformed/") == std::string::npos;
}

void defectiveScans(benchmark::State& state) {
  const std::string what = "scans by volume";
  const char* const folder = std::getenv("HANDWHEEL_DATA");
  const char* const one = std::getenv("HANDWHEEL_SCAN");
  for (auto _ : state) {
    if (!folder) return bars.missing(state, what, "HANDWHEEL_DATA is not set");
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(std::filesystem::path(folder) / "scans"))
      if (entry.is_regular_file() && isScan(entry.path()) &&
          (!one || entry.path().string().find(one) != std::string::npos))
        files.insert(entry.path());
    std::printf("%-44s | by triangles: 99 %% of the area, in voxels; triangles; s | by volume | alpha wrap\n", "scan");
    Counts counts;
    for (const auto& path : files) {
      const Result<MeshFile> file = readMeshFile(path, {});
      if (!file) {
        std::printf("%-44s | REFUSED\n", path.filename().string().c_str());
        ++counts.refused;
        continue;
      }
      if (file->soup.triangles.size() < kLeastFaces) continue;
      if (reportOn(file->soup, SelfIntersections::Count).isSound()) continue;
      measure(path.parent_path().filename().string() + "/" + path.filename().string(), file->soup, counts);
    }
    bars.tell("defective scans", counts.defective);
    bars.tell("sound by triangles", counts.byTriangles);
    bars.tell("sound by volume", counts.byVolume);
    bars.tell("sound by alpha wrap", counts.byWrap);
    bars.atMostOver(files.size(), "scans that our reader refuses", 0.0, counts.refused);
    bars.atMostOver(static_cast<std::size_t>(counts.byTriangles), "sound by triangles and not by volume", 0.0,
                    counts.lost);
    bars.tell("sound by volume, kept surface farther than a voxel", counts.far);
    bars.tell("by volume, s", counts.volumeSeconds);
    bars.tell("alpha wrap, s", counts.wrapSeconds);
  }
}
BENCHMARK(defectiveScans)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
