// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "GarbageMeshes.h"
#include "mesh/repair/Repair.h"
#include "mesh/repair/RepairBudget.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <span>
#include <utility>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it if that is not available. The first byte chooses the meaning of
// the others: the corners of loose triangles on a small grid, so that points coincide and lines cross in points; pairs
// of a point and a position for it that damage a ball; or the seed of one that is damaged at random.

namespace {

using namespace handwheel;
using Rest = std::span<const std::uint8_t>;

constexpr std::size_t kMostTriangles = 60;  // loose ones; each may meet each
// CPU seconds that a repair may take for each microsecond that its effort stands for, with sanitizers.
constexpr double kSlowest = 10e-6;
constexpr double kLeastTime = 2.0;  // s, allowed in any case
// CPU seconds of a step in the reference repair, with sanitizers. On a machine that needs more, a repair may take as
// many times longer.
constexpr double kUsualStep = 16e-6;
// CPU time of a counted step of effort, at most, to that of the reference repair on the same machine and build. Work
// that is not counted shows above it.
constexpr double kSlowestToReference = 3.0;
constexpr std::size_t kUncounted = 50'000;  // steps' time, for what a repair of so few triangles does beside

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "RepairFuzz: %s\n", what);
  std::abort();
}

Vec3 onGrid(std::uint8_t byte) {
  return {double(byte & 7), double(byte >> 3 & 7), double(byte >> 6 & 3)};
}

TriangleSoup looseTriangles(Rest bytes) {
  TriangleSoup soup;
  for (; bytes.size() >= 3 && soup.triangles.size() < kMostTriangles; bytes = bytes.subspan(3)) {
    const auto n = static_cast<std::uint32_t>(soup.points.size());
    for (std::size_t k = 0; k < 3; ++k) soup.points.push_back(onGrid(bytes[k]));
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  return soup;
}

TriangleSoup damagedBall(Rest bytes) {
  TriangleSoup soup = test::icosphere(1);
  for (; bytes.size() >= 2; bytes = bytes.subspan(2)) {
    if (bytes[0] < 128) {
      soup.points[bytes[0] % soup.points.size()] = 0.5 * onGrid(bytes[1]) - Vec3(1.5, 1.5, 0.5);
    } else {
      soup.triangles[bytes[0] % soup.triangles.size()][bytes[1] % 3] = (bytes[1] >> 2) % 42u;  // one of 42 points
    }
  }
  return soup;
}

TriangleSoup damagedAtRandom(Rest bytes) {
  std::mt19937 random(bytes.empty() ? 0 : bytes[0]);
  return test::damagedSphere(random, 1, bytes.size() < 2 ? 20 : bytes[1]);
}

TriangleSoup soupOf(Rest bytes) {
  const std::uint8_t kind = bytes.empty() ? 0 : bytes[0];
  const Rest rest = bytes.subspan(bytes.empty() ? 0 : 1);
  return kind % 3 == 0 ? looseTriangles(rest) : kind % 3 == 1 ? damagedBall(rest) : damagedAtRandom(rest);
}

double processorSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Run {
  RepairReport report;
  double seconds;  // CPU time
};

Run timedRepair(HalfEdgeMesh& mesh, bool cutCrossings) {
  RepairOptions options;
  options.cutCrossings = cutCrossings;
  const double start = processorSeconds();
  RepairReport report = repair(mesh, options);
  return {std::move(report), processorSeconds() - start};
}

// CPU seconds of a step of effort in the repair of a certain damaged sphere: the faster of two runs.
double referenceStep() {
  double fastest = 1e9;
  for (int run = 0; run < 2; ++run) {
    std::mt19937 random(5);
    HalfEdgeMesh mesh = buildMesh(test::damagedSphere(random, 1, 30)).mesh;
    const auto [report, seconds] = timedRepair(mesh, true);
    fastest = std::min(fastest, seconds / static_cast<double>(report.countedEffort));
  }
  return fastest;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const HalfEdgeMesh before = buildMesh(soupOf({data, size})).mesh;
  static const double step = referenceStep();
  HalfEdgeMesh after = before;
  const auto [report, seconds] = timedRepair(after, size % 2 == 1);
  const std::size_t most = 2 * repairBudget(before.liveFaceCount());
  require(report.countedEffort <= most + most / 10, "more effort than a mesh of this size may take");
  require(seconds <= std::max(1.0, step / kUsualStep) * (kLeastTime + kSlowest * static_cast<double>(most)),
          "too long for the number of triangles");
  require(seconds <= kSlowestToReference * step * static_cast<double>(report.countedEffort + kUncounted),
          "too long for the effort that it counted");
  require(validate(after).empty(), "the repaired mesh is not valid");
  for (const LoopResult& loop : report.loops)
    require((loop.outcome == LoopOutcome::Filled) == (loop.reason == FillFailure::None),
            "an open loop without a reason");
  return 0;
}
