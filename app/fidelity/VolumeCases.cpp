// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "fidelity/CaseShapes.h"
#include "fidelity/Cases.h"
#include "fidelity/SeededInput.h"
#include "proximity/TriangleHierarchy.h"
#include "volume/VolumeFidelity.h"
#include "volume/VolumeShapes.h"
#include "volume/clay/ClayDab.h"
#include "volume/drilling/DrillBits.h"
#include "volume/drilling/DrillRun.h"
#include "volume/repair/VolumeRepair.h"
#include "volume/surface/SharpSurface.h"
#include "volume/surface/VolumeSurface.h"
#include "volume/surface/VolumeToSurface.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

// A known part, and positions on it that are the first to be lost.
struct KnownPart {
  TriangleSoup surface;
  std::vector<Vec3> positions;

  double extent() const {
    Box box;
    for (const Vec3& p : surface.points) box.extend(p);
    return box.sizes().maxCoeff();
  }
};

constexpr double kExtent = 50.0;  // mm

KnownPart ball() {
  KnownPart part{sphereSoup(5, 0.5 * kExtent), {}};
  part.positions = part.surface.points;
  return part;
}

// Returns a block, with positions along its edges.
KnownPart block(const Eigen::Matrix3d& turn) {
  const Vec3 half(24.0, 15.0, 9.0);
  KnownPart part;
  for (int c = 0; c < 8; ++c)
    part.surface.points.push_back(turn * half.cwiseProduct(Vec3(c & 1 ? 1 : -1, c & 2 ? 1 : -1, c & 4 ? 1 : -1)));
  part.surface.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                            {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  constexpr int kSteps = 100;
  for (std::size_t c = 0; c < 8; ++c)
    for (std::size_t k = 0; k < 3; ++k) {
      if (c >> k & 1) continue;
      const Vec3 &a = part.surface.points[c], &b = part.surface.points[c | std::size_t{1} << k];
      for (int i = 0; i <= kSteps; ++i) part.positions.emplace_back(a + (b - a) * i / kSteps);
    }
  return part;
}

// In no direction of the grid.
KnownPart turnedBlock() {
  return block((Eigen::AngleAxisd(0.5, Vec3::UnitZ()) * Eigen::AngleAxisd(0.4, Vec3::UnitX())).toRotationMatrix());
}

// Returns the largest distance between a part and a surface, measured at their positions; mm.
double distanceBetween(const KnownPart& part, const TriangleSoup& surface) {
  constexpr std::size_t kPositions = 20'000;
  const TriangleHierarchy known(part.surface.points, part.surface.triangles);
  const TriangleHierarchy found(surface.points, surface.triangles);
  double most = surface.triangles.empty() ? std::numeric_limits<double>::infinity() : 0.0;
  const auto look = [&](const TriangleHierarchy& hierarchy, const std::vector<Vec3>& positions) {
    const std::size_t step = positions.size() / kPositions + 1;
    for (std::size_t i = 0; i < positions.size(); i += step)
      if (const auto nearest = hierarchy.nearest(positions[i])) most = std::max(most, nearest->squaredDistance);
  };
  look(known, surface.points);
  look(found, part.positions);
  return std::sqrt(most);
}

// Runs on one thread, so that its CPU time is that of the work.
template <class Work>
double millisecondsAlone(Work&& work) {
  tbb::task_arena alone(1);
  return alone.execute([&] { return cpuMilliseconds(work); });
}

using Measured = FidelitySample (*)(const KnownPart&, double value, const Progress&);

FidelitySample voxels(const KnownPart& part, double value, const Progress& progress) {
  TriangleSoup surface;
  FidelitySample sample;
  sample.cost = millisecondsAlone([&] {
    const Result<SurfaceVolume> made = volumeOfSurface(part.surface, usualVoxel(part.surface, value), progress);
    if (made) surface = surfaceOf(made->volume, progress);
  });
  sample.error = 100.0 * distanceBetween(part, surface) / part.extent();
  return sample;
}

constexpr double kMeasuredVoxels = 128.0;  // along the extent, where the voxel is not what is measured

FidelitySample method(const KnownPart& part, double value, const Progress& progress) {
  const double voxel = usualVoxel(part.surface, kMeasuredVoxels);
  std::optional<Result<SurfaceVolume>> made;
  FidelitySample sample;
  sample.cost = millisecondsAlone(
      [&] { made = volumeOfSurface(part.surface, voxel, static_cast<VoxelMethod>(value), progress); });
  sample.error = std::numeric_limits<double>::infinity();
  if (*made) sample.error = 100.0 * distanceBetween(part, surfaceOf((*made)->volume, progress)) / voxel;
  return sample;
}

FidelitySample reduction(const KnownPart& part, double value, const Progress& progress) {
  const double voxel = usualVoxel(part.surface, kMeasuredVoxels);
  const Result<VolumeRepair> made = repairByVolume(part.surface, {.voxel = voxel, .within = value}, progress);
  FidelitySample sample{std::numeric_limits<double>::infinity(), 100.0};
  if (!made) return sample;
  sample.error = 100.0 * distanceBetween(part, made->mesh.compact().soup) / voxel;
  sample.cost = 100.0 * static_cast<double>(made->mesh.liveFaceCount()) / static_cast<double>(made->sampledTriangles);
  return sample;
}

FidelitySample polygons(const KnownPart& part, double value, const Progress& progress) {
  const double voxel = usualVoxel(part.surface, kMeasuredVoxels);
  const Result<SurfaceVolume> made = volumeOfSurface(part.surface, voxel, progress);
  FidelitySample sample{std::numeric_limits<double>::infinity(), 1.0};
  if (!made) return sample;
  TriangleSoup surface;
  sample.cost = millisecondsAlone(
      [&] { surface = value > 0.0 ? sharpSurfaceOf(made->volume, progress) : surfaceOf(made->volume, progress); });
  const TriangleHierarchy found(surface.points, surface.triangles);
  double squares = 0.0;
  for (const Vec3& p : part.positions)
    if (const auto nearest = found.nearest(p)) squares += nearest->squaredDistance;
  sample.error = 100.0 * std::sqrt(squares / static_cast<double>(part.positions.size())) / voxel;
  return sample;
}

FidelityCase caseOf(const std::string& name, const KnownPart& part, Measured measured) {
  return {name, "the part's triangles",
          [measured, part](double value, std::uint64_t, Progress progress) { return measured(part, value, progress); }};
}

std::vector<FidelityCase> casesOf(Measured measured) {
  return {caseOf("ball of 50 mm", ball(), measured), caseOf("turned block of 48 mm", turnedBlock(), measured)};
}

// A ball of 6 mm is led into a large ball of material. Once it is inside, its thrust is even: that of the section, by
// the balance of energy.
FidelitySample hole(double value, double slope, const Progress& progress) {
  constexpr double kVoxel = 0.35, kFeed = 2.0, kCycle = 0.004, kDepth = 9.0, kRadius = 3.0, kBlock = 16.0;
  SparseVolume volume = ballOfVoxels(kBlock, kVoxel);
  DrillSetup setup;
  setup.tool = *drillBitOf("ball:6");
  setup.erosion = erosionOf(value);
  DrillRun run(volume, setup);
  const Vec3 direction = Vec3(std::sin(slope), 0.0, -std::cos(slope));
  const double section = M_PI * kRadius * kRadius;
  const double exact =
      drillLoad(setup.material, setup.tool, section * kFeed * kCycle, kCycle, kFeed, setup.spindle).thrust;
  FidelitySample sample;
  double squares = 0.0, cpu = 0.0;
  int even = 0, cycles = 0;
  for (double gone = 0.0; gone < kDepth + kRadius && !progress.cancelled(); gone = kFeed * kCycle * ++cycles) {
    DrillTick tick;
    cpu +=
        millisecondsAlone([&] { tick = run.move(direction * (gone - kBlock - kRadius), -direction, kCycle * cycles); });
    if (gone < 3.0 * kRadius) continue;  // the head is in, and the slope of the ball behind it
    squares += (tick.thrust / exact - 1.0) * (tick.thrust / exact - 1.0);
    ++even;
  }
  sample.error = 100.0 * std::sqrt(squares / std::max(1, even));
  sample.cost = 1e3 * cpu / std::max(1, cycles);
  return sample;
}

// Balls of so many voxels are carved out of the surface of a large one. Of each only the renewal of pieces is timed.
FidelitySample renewedPieces(double tool, double value, std::uint64_t seed, const Progress& progress) {
  constexpr double kVoxel = 0.1, kBall = 128.0 * kVoxel;
  constexpr int kDabs = 16;
  SparseVolume volume = ballOfVoxels(kBall, kVoxel);
  VolumeSurface surface(volume, progress, pieceCellsOf(value));
  FidelitySample sample;
  sample.error = static_cast<double>(surface.pieces().size());
  Random random(seed);
  for (int i = 0; i < kDabs && !progress.cancelled(); ++i) {
    ClayDab dab;
    dab.centre = kBall * random.direction();
    dab.radius = tool * kVoxel;
    const std::vector<VoxelIndex> changed = applyDab(volume, dab);
    sample.cost += millisecondsAlone([&] { surface.update(volume, changed); });
  }
  sample.cost /= kDabs;
  return sample;
}

}  // namespace

std::vector<FidelityCase> volumeVoxelsCases() {
  return casesOf(voxels);
}

std::vector<FidelityCase> volumeMethodCases() {
  return casesOf(method);
}

std::vector<FidelityCase> volumeReductionCases() {
  return casesOf(reduction);
}

std::vector<FidelityCase> volumePolygonsCases() {
  return {caseOf("block of 48 mm along the grid", block(Eigen::Matrix3d::Identity()), polygons),
          caseOf("turned block of 48 mm", turnedBlock(), polygons)};
}

std::vector<FidelityCase> volumePiecesCases() {
  const auto carved = [](const char* name, double tool) {
    return FidelityCase{name, "counted", [tool](double value, std::uint64_t seed, Progress progress) {
                          return renewedPieces(tool, value, seed, progress);
                        }};
  };
  return {carved("ball of 256 voxels, carved by one of 16", 8.0),
          carved("ball of 256 voxels, carved by one of 80", 40.0)};
}

std::vector<FidelityCase> drillErosionCases() {
  const auto holeCase = [](const char* name, double slope) {
    return FidelityCase{name, "closed form", [slope](double value, std::uint64_t, Progress progress) {
                          return hole(value, slope, progress);
                        }};
  };
  return {holeCase("a hole of 6 mm along the grid", 0.0), holeCase("a hole of 6 mm across the grid", 0.6)};
}

}  // namespace handwheel
