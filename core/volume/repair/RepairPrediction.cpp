// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/RepairPrediction.h"

#include "volume/SurfaceToVolume.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>

namespace handwheel {
namespace {

// Marching cubes make two triangles for a voxel of a plane along the axes, and up to 2√3 in other directions.
constexpr double kTrianglesOfVoxel = 2.6;
// Time for a sampled triangle with and without the reduction, and for a triangle of the surface; s.
constexpr double kSecondsReduced = 33e-6, kSecondsKept = 8e-6, kSecondsOfTriangle = 10e-6;
constexpr double kSecondsComparing = 0.2;  // points all over both surfaces, however many triangles they have

std::atomic<double> slowness{1.0};  // relative to the machine of the constants

// Returns a ball of triangles between parallels and meridians.
TriangleSoup ballOfTriangles(double radius, std::uint32_t parallels, std::uint32_t meridians) {
  TriangleSoup ball;
  for (std::uint32_t i = 0; i <= parallels; ++i)
    for (std::uint32_t j = 0; j < meridians; ++j) {
      const double polar = M_PI * i / parallels, around = 2.0 * M_PI * j / meridians;
      ball.points.push_back(
          radius * Vec3(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)));
    }
  for (std::uint32_t i = 0; i < parallels; ++i)
    for (std::uint32_t j = 0; j < meridians; ++j) {
      const std::uint32_t here = i * meridians + j, beside = i * meridians + (j + 1) % meridians;
      if (i > 0) ball.triangles.push_back({here, here + meridians, beside});
      if (i + 1 < parallels) ball.triangles.push_back({beside, here + meridians, beside + meridians});
    }
  return ball;
}

double secondsOfConstants(double area, std::size_t triangles, const VolumeRepairOptions& options) {
  const RepairWork work = predictedRepairWork(area, triangles, options);
  const double each = work.triangles < work.sampled ? kSecondsReduced : kSecondsKept;
  return work.sampled * each + static_cast<double>(triangles) * kSecondsOfTriangle;
}

}  // namespace

RepairWork predictedRepairWork(double area, std::size_t triangles, const VolumeRepairOptions& options) {
  constexpr double kFewest = 100.0;  // triangles of a reduced surface
  RepairWork work;
  work.sampled = kTrianglesOfVoxel * area / (options.voxel * options.voxel);
  work.triangles = work.sampled;
  if (options.isReduced) work.triangles = std::min(work.sampled, std::max(kFewest, static_cast<double>(triangles)));
  return work;
}

double predictedRepairSeconds(double area, std::size_t triangles, const VolumeRepairOptions& options) {
  return predictedMakingSeconds(area, options.voxel) +
         slowness.load() * (kSecondsComparing + secondsOfConstants(area, triangles, options));
}

void measureRepairSpeed() {
  static std::once_flag isMeasured;
  std::call_once(isMeasured, [] {
    const TriangleSoup ball = ballOfTriangles(10.0, 12, 24);
    const VolumeRepairOptions options{.voxel = 1.0};
    const auto start = std::chrono::steady_clock::now();
    if (!repairByVolume(ball, options)) return;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    slowness = seconds / secondsOfConstants(surfaceArea(ball), ball.triangles.size(), options);
  });
}

}  // namespace handwheel
