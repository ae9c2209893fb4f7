// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "fidelity/CaseShapes.h"
#include "fidelity/Cases.h"
#include "fidelity/SeededInput.h"
#include "mesh/measure/Deviation.h"
#include "mesh/measure/MeshFidelity.h"
#include "mesh/simplify/Decimation.h"
#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/MeshBuilder.h"

#include <limits>

namespace handwheel {
namespace {

constexpr const char *kSphereName = "sphere of 5,120 faces", *kTorusName = "torus of 9,600 faces";
constexpr DeviationOptions kMeasuring{.samples = 20'000, .bins = 1};

// Triangles are removed as by the tool; the result is compared with the original, in both directions. In diagonals. An
// unchanged mesh is this far from itself.
constexpr double kRounding = 1e-12;

FidelitySample reduce(const HalfEdgeMesh& original, double value, const Progress& progress) {
  const double diagonal = diagonalOf(original);
  FidelitySample sample{std::numeric_limits<double>::infinity(), 100.0};
  if (!(diagonal > 0.0)) return sample;
  HalfEdgeMesh mesh = original;
  DecimationOptions options;
  options.error = value * diagonal;
  options.keepBorders = options.avoidIntersections = true;
  const DecimationReport report = decimate(mesh, options, progress.part(0.0, 0.7));
  const auto found = deviation(mesh, original, kMeasuring, progress.part(0.7, 1.0));
  if (!found) return sample;
  const double error = found->hausdorff() / diagonal;
  sample.error = error > kRounding ? 100.0 * error : 0.0;
  sample.cost = 100.0 * static_cast<double>(report.facesAfter) / static_cast<double>(report.facesBefore);
  return sample;
}

// To the same number of triangles by either method, with what both can keep.
FidelitySample reduceToShare(const HalfEdgeMesh& original, DecimationMethod method, std::size_t share,
                             const Progress& progress) {
  const double diagonal = diagonalOf(original);
  FidelitySample sample{std::numeric_limits<double>::infinity(), 0.0};
  HalfEdgeMesh mesh = original;
  const DecimationOptions options{.faces = original.liveFaceCount() / share, .keepBorders = true, .method = method};
  DecimationReport report;
  sample.cost = cpuMilliseconds([&] { report = decimate(mesh, options, progress.part(0.0, 0.7)); });
  if (!(diagonal > 0.0) || report.refusal != OpenMeshRefusal::None || report.facesAfter > options.faces) return sample;
  const auto found = deviation(mesh, original, kMeasuring, progress.part(0.7, 1.0));
  if (found) sample.error = 100.0 * found->hausdorff() / diagonal;
  return sample;
}

}  // namespace

FidelityCase decimationErrorCaseOn(const std::string& name, SoupSource soup) {
  const SeededInput<HalfEdgeMesh> input([soup](std::uint64_t) { return buildMesh(*soup()).mesh; });
  return {name, "the mesh, at 20,000 places", [input](double value, std::uint64_t seed, Progress progress) {
            return reduce(input(seed), value, progress);
          }};
}

std::vector<FidelityCase> decimationErrorCases() {
  return {decimationErrorCaseOn(kSphereName, sphereSource(4, 50.0)),
          decimationErrorCaseOn(kTorusName, torusSource(120, 40, 60.0, 30.0))};
}

std::vector<FidelityCase> decimationMethodCasesOn(const std::string& name, const SoupSource& soup) {
  const SeededInput<HalfEdgeMesh> input([soup](std::uint64_t) { return buildMesh(*soup()).mesh; });
  std::vector<FidelityCase> cases;
  for (const auto& [share, words] : {std::pair(2, "half"), std::pair(10, "a tenth"), std::pair(50, "a fiftieth")}) {
    cases.push_back({name + ", " + words + " left", "the mesh, at 20,000 places",
                     [input, share = std::size_t(share)](double value, std::uint64_t seed, Progress progress) {
                       return reduceToShare(input(seed), static_cast<DecimationMethod>(value), share, progress);
                     }});
  }
  return cases;
}

std::vector<FidelityCase> decimationMethodCases() {
  std::vector<FidelityCase> cases = decimationMethodCasesOn(kSphereName, sphereSource(4, 50.0));
  for (FidelityCase& c : decimationMethodCasesOn(kTorusName, torusSource(120, 40, 60.0, 30.0)))
    cases.push_back(std::move(c));
  return cases;
}

}  // namespace handwheel
