// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "fidelity/CaseShapes.h"
#include "fidelity/Cases.h"
#include "fidelity/CutSurface.h"
#include "fidelity/SeededInput.h"
#include "fidelity/VirtualScanner.h"
#include "mesh/measure/MeshFidelity.h"

#include <cmath>
#include <limits>

namespace handwheel {
namespace {

constexpr int kCuts = 4;  // each triangle of a patch is sampled at the middles of kCuts² parts

// Σ area · (distance / size)² over the patch and Σ area.
struct PatchDeviation {
  double squares = 0.0;
  double area = 0.0;

  void add(const Patch& patch, const DistanceToTruth& distance, double size) {
    for (const Triangle& t : patch.triangles) {
      const Vec3 a = patch.points[t[0]], u = (patch.points[t[1]] - a) / kCuts, v = (patch.points[t[2]] - a) / kCuts;
      const double part = 0.5 * u.cross(v).norm();
      for (int i = 0; i < kCuts; ++i) {
        for (int j = 0; j < kCuts - i; ++j) {
          addPoint(distance(a + (i + 1.0 / 3.0) * u + (j + 1.0 / 3.0) * v) / size, part);
          if (j < kCuts - i - 1) addPoint(distance(a + (i + 2.0 / 3.0) * u + (j + 2.0 / 3.0) * v) / size, part);
        }
      }
    }
  }
  void addPoint(double share, double part) {
    squares += part * share * share;
    area += part;
  }
};

FidelitySample fill(const CutSurface& input, const FillOptions& options, Progress progress) {
  FidelitySample sample;
  PatchDeviation deviation;
  for (const CutSurface::Hole& hole : input.holes) {
    FillAttempt attempt;
    sample.cost += cpuMilliseconds([&] { attempt = input.filler->propose(hole.loop, options, progress); });
    if (attempt.failure == FillFailure::None) {
      deviation.add(attempt.patch, hole.distance, hole.loop.box.diagonal().norm());
    }
  }
  if (!input.holes.empty()) sample.cost /= static_cast<double>(input.holes.size());
  sample.error = deviation.area > 0.0 ? 100.0 * std::sqrt(deviation.squares / deviation.area)
                                      : std::numeric_limits<double>::infinity();
  return sample;
}

// A surface, and the truth about it; a truth without a function is what is cut out.
struct Surface {
  std::string name;
  SoupSource soup;
  DistanceToTruth distance = nullptr;
  CutOptions cuts = {};
  std::string holes = "four holes cut";
};

// A part as a scanner sees it. Half of the holes are across its sharp edges, all so small that most cross one only.
Surface scanned(const std::string& name, const ExactPart& part) {
  Surface surface{name + ", scanned", [part] { return std::make_shared<const TriangleSoup>(scanOf(part, {})); },
                  [part](const Vec3& p) { return std::abs(part.distance(p)); }};
  surface.cuts = {.holes = 12, .radius = 0.05, .distanceToCrease = part.distanceToCrease};
  surface.holes = "twelve holes cut";
  return surface;
}

std::vector<Surface> builtIn() {
  return {{"sphere", sphereSource(5, 50.0), [](const Vec3& p) { return std::abs(p.norm() - 50.0); }},
          {"torus", torusSource(240, 80, 60.0, 30.0), [](const Vec3& p) { return distanceToTorus(p, 60.0, 30.0); }},
          scanned("milled part", milledPart()),
          scanned("turned part", turnedPart())};
}

// With loops of some 300 edges.
std::vector<Surface> fine() {
  return {
      {"fine sphere", sphereSource(7, 50.0), [](const Vec3& p) { return std::abs(p.norm() - 50.0); }},
      {"fine torus", torusSource(720, 240, 60.0, 30.0), [](const Vec3& p) { return distanceToTorus(p, 60.0, 30.0); }}};
}

FidelityCase caseOn(const Surface& surface, void (*choose)(FillOptions&, double value)) {
  const SeededInput<CutSurface> input(
      [surface](std::uint64_t seed) { return cutHoles(*surface.soup(), seed, surface.distance, surface.cuts); });
  return {surface.name + ", " + surface.holes, surface.distance ? "closed form" : "surface cut out",
          [input, choose](double value, std::uint64_t seed, Progress progress) {
            FillOptions options;
            choose(options, value);
            return fill(input(seed), options, progress);
          }};
}

void chooseMethod(FillOptions& options, double value) {
  FidelityValues values;
  if (values.set(fillMethodSetting(), value)) options.method = fillMethodOf(values);
}

void chooseContinuity(FillOptions& options, double value) {
  FidelityValues values;
  if (values.set(fillContinuitySetting(), value)) options.continuity = fillContinuityOf(values);
}

void chooseDensity(FillOptions& options, double value) {
  options.density = value;
}

void choosePieceEdges(FillOptions& options, double value) {
  options.pieceEdges = static_cast<std::size_t>(value);
}

std::vector<FidelityCase> casesOn(const std::vector<Surface>& surfaces, void (*choose)(FillOptions&, double value)) {
  std::vector<FidelityCase> cases;
  for (const Surface& surface : surfaces) cases.push_back(caseOn(surface, choose));
  return cases;
}

}  // namespace

std::vector<FidelityCase> fillMethodCases() {
  return casesOn(builtIn(), chooseMethod);
}

FidelityCase fillMethodCaseOn(const std::string& name, SoupSource soup) {
  return caseOn({name, std::move(soup)}, chooseMethod);
}

std::vector<FidelityCase> fillContinuityCases() {
  return casesOn(builtIn(), chooseContinuity);
}

FidelityCase fillContinuityCaseOn(const std::string& name, SoupSource soup) {
  return caseOn({name, std::move(soup)}, chooseContinuity);
}

std::vector<FidelityCase> patchDensityCases() {
  return casesOn(builtIn(), chooseDensity);
}

FidelityCase patchDensityCaseOn(const std::string& name, SoupSource soup) {
  return caseOn({name, std::move(soup)}, chooseDensity);
}

std::vector<FidelityCase> pieceEdgesCases() {
  return casesOn(fine(), choosePieceEdges);
}

FidelityCase pieceEdgesCaseOn(const std::string& name, SoupSource soup) {
  return caseOn({name, std::move(soup)}, choosePieceEdges);
}

}  // namespace handwheel
