// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/PatchRefinement.h"

#include "mesh/holes/EvenRemeshing.h"

#include <algorithm>

namespace handwheel {
namespace {

// Returns true if a vertex around the hole has so many faces that fairing would fill the memory.
bool hasHugeFan(const HoleContext& hole) {
  std::vector<int> faces(hole.points.size(), 0);
  for (const Triangle& t : hole.ring) {
    for (std::uint32_t v : t) ++faces[v];
  }
  return std::any_of(faces.begin(), faces.end(), [](int n) { return n > tolerance::kLibraryFanFaces; });
}

// Returns the mean length of the two loop edges at each point of the loop.
std::vector<double> lengthsAlong(const HoleContext& hole) {
  const std::size_t n = hole.loopSize;
  std::vector<double> lengths(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const double half = 0.5 * (hole.points[j] - hole.points[i]).norm();
    lengths[i] += half;
    lengths[j] += half;
  }
  return lengths;
}

// A patch has twice as many triangles as vertices inside. If the wanted length grows by g for each millimetre from the
// loop, n edges of length e need ∫ n e / (s (e + g r)²) dr = n / (s g) triangles; s is the area of an equilateral
// triangle of side 1.
EvenRemeshing remeshingOf(const HoleContext& hole, const Patch& start, double density, const JoinedPoints& joined) {
  EvenRemeshing wanted;
  const double finer = density / tolerance::kPatchDensity, n = static_cast<double>(hole.loopSize);
  wanted.lengths = lengthsAlong(hole);
  for (double& length : wanted.lengths) length /= finer;
  const double vertices = std::min<double>(tolerance::kPatchVertices, tolerance::kPatchVerticesPerEdge * n);
  if (expectedTriangles({start.points, start.triangles}, wanted.lengths) > 2.0 * vertices)
    wanted.growth = std::min(1.0, finer * n / (kEquilateralArea * 2.0 * vertices));
  wanted.joined = joined;
  wanted.mostPoints = static_cast<std::size_t>(vertices);
  return wanted;
}

}  // namespace

std::optional<Patch> refinePatch(const HoleContext& hole, const Patch& start, double density,
                                 const JoinedPoints& joined, Progress progress) {
  if (hasHugeFan(hole)) return std::nullopt;
  std::optional<TriangleSoup> even =
      remeshEvenly({start.points, start.triangles}, remeshingOf(hole, start, density, joined), progress);
  if (!even) return std::nullopt;
  return Patch{hole.loopSize, std::move(even->points), std::move(even->triangles), FillMethod::Refined, start.bridges};
}

std::optional<Patch> fairPatch(const HoleContext& hole, Patch patch, Continuity continuity,
                               const std::vector<std::pair<std::uint32_t, Vec3>>& held, Progress progress) {
  const std::size_t n = hole.loopSize, known = hole.points.size();
  std::vector<Vec3> points = hole.points;
  points.insert(points.end(), patch.points.begin() + static_cast<std::ptrdiff_t>(n), patch.points.end());
  std::vector<Triangle> triangles = hole.ring;
  for (Triangle t : patch.triangles) {
    for (std::uint32_t& v : t) v = v < n ? v : static_cast<std::uint32_t>(v - n + known);
    triangles.push_back(t);
  }
  std::vector<bool> isFree(points.size(), false);
  std::fill(isFree.begin() + static_cast<std::ptrdiff_t>(known), isFree.end(), true);
  for (const auto& [i, position] : held) {
    points[i - n + known] = position;
    isFree[i - n + known] = false;
  }
  if (!fair(points, triangles, isFree, continuity, progress)) return std::nullopt;
  std::copy(points.begin() + static_cast<std::ptrdiff_t>(known), points.end(),
            patch.points.begin() + static_cast<std::ptrdiff_t>(n));
  patch.method = FillMethod::Fair;
  patch.continuity = continuity;
  return patch;
}

}  // namespace handwheel
