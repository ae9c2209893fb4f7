// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/Translatable.h"
#include "fidelity/CaseShapes.h"
#include "fidelity/Cases.h"
#include "fidelity/SeededInput.h"
#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/MeshBuilder.h"
#include "proximity/TriangleHierarchy.h"
#include "viewport/surface/MeshPreparation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

constexpr std::size_t kSamples = 20000;

struct ShownMesh {
  HalfEdgeMesh mesh;
  Box bounds;
  std::vector<Vec3> samples;  // points on its faces
};

ShownMesh shown(const TriangleSoup& soup, std::uint64_t seed) {
  ShownMesh shown{buildMesh(soup).mesh, {}, {}};
  shown.bounds = boundsOf(shown.mesh);
  Random random(seed);
  for (std::size_t i = 0; i < kSamples && shown.mesh.faceSlots() > 0; ++i) {
    const auto f = static_cast<Face>(random.below(shown.mesh.faceSlots()));
    double u = random.between(0.0, 1.0), v = random.between(0.0, 1.0);
    if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
    if (!shown.mesh.isProper(f)) continue;
    const TrianglePoints p = shown.mesh.points(f);
    shown.samples.push_back(p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0]));
  }
  return shown;
}

// Points about the origin as the display has it.
TriangleSoup soupOf(const SurfaceGeometry& g) {
  TriangleSoup soup;
  for (std::size_t i = 0; i < g.positions.size(); i += 3)
    soup.points.emplace_back(g.positions[i], g.positions[i + 1], g.positions[i + 2]);
  const auto corner = [&](std::size_t i) { return static_cast<std::uint32_t>(g.indices[i]); };
  for (std::size_t i = 0; i < g.indices.size(); i += 3)
    soup.triangles.push_back({corner(i), corner(i + 1), corner(i + 2)});
  return soup;
}

// From the mesh to what stands in for it, so that a thin part that vanishes counts in full.
FidelitySample standIn(const ShownMesh& shown, double value) {
  const auto triangles = static_cast<std::size_t>(value);
  if (!hasCoarseVersion(shown.mesh, triangles)) return {0.0, static_cast<double>(shown.mesh.liveFaceCount())};
  const Vec3 origin = shown.bounds.center();
  const TriangleSoup coarse = soupOf(coarseGeometry(shown.mesh, shown.bounds, origin, triangles));
  FidelitySample sample{std::numeric_limits<double>::infinity(), static_cast<double>(coarse.triangles.size())};
  if (coarse.triangles.empty()) return sample;
  const TriangleHierarchy hierarchy(coarse.points, coarse.triangles);
  double furthest = 0.0;  // squared
  for (const Vec3& p : shown.samples) furthest = std::max(furthest, hierarchy.nearest(p - origin)->squaredDistance);
  sample.error = 100.0 * std::sqrt(furthest) / shown.bounds.diagonal().norm();
  return sample;
}

}  // namespace

FidelitySetting coarseTrianglesSetting() {
  FidelitySetting s;
  s.id = "view.coarse_triangles";
  s.label = translatable("Fidelity", "Triangles that a slow display draws while the view moves");
  s.scale = FidelityScale::Logarithmic;
  s.least = 2000.0;
  s.largest = 200000.0;
  s.whole = true;
  s.standard = kCoarseTriangles;
  s.presets = {2000.0, 20000.0, 200000.0};
  s.error = {translatable("Fidelity", "largest distance from the mesh, in diagonals"), "%"};
  s.cost = {translatable("Fidelity", "triangles of a frame"), translatable("Fidelity", "triangles")};
  return s;
}

FidelityCase coarseTrianglesCaseOn(const std::string& name, SoupSource soup) {
  const SeededInput<ShownMesh> input([soup](std::uint64_t seed) { return shown(*soup(), seed); });
  return {name, "the mesh, at 20,000 places",
          [input](double value, std::uint64_t seed, Progress) { return standIn(input(seed), value); }};
}

std::vector<FidelityCase> coarseTrianglesCases() {
  return {coarseTrianglesCaseOn("torus of 1,000,000 faces", torusSource(2000, 250, 100.0, 20.0)),
          coarseTrianglesCaseOn("sphere of 1,310,720 faces", sphereSource(8, 50.0))};
}

}  // namespace handwheel
