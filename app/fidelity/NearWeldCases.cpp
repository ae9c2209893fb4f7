// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "fidelity/CaseShapes.h"
#include "fidelity/Cases.h"
#include "fidelity/SeededInput.h"
#include "mesh/boundary/Stitching.h"
#include "mesh/structure/MeshBuilder.h"

#include <algorithm>

namespace handwheel {
namespace {

// Shares of the diagonal. Rounding to single precision, or to six digits, tears by 1e-8 to 1e-5 as a part lies one to
// a hundred diagonals from the origin; the finest gaps of scans are some 2e-5.
struct Widths {
  double least, largest;
};
constexpr Widths kTears{1e-8, 1e-5}, kGaps{2e-5, 1e-3};

// Two numbers of what was one point.
struct Parted {
  std::uint32_t a, b;
  bool belongTogether;
};

struct TornMesh {
  HalfEdgeMesh mesh;
  std::vector<Parted> pairs;
};

Vec3 centroid(const TriangleSoup& soup, const Triangle& t) {
  return (soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]) / 3.0;
}

// Gives the triangles on one side of a plane through the middle points of their own wherever both sides share one.
// Points at or beyond firstCopy are copies already and stay whole.
void part(TriangleSoup& soup, Random& random, const Widths& widths, bool belongTogether, std::uint32_t firstCopy,
          std::vector<Parted>& pairs) {
  Box box;
  for (const Vec3& p : soup.points) box.extend(p);
  const Vec3 normal = random.direction(), middle = box.center();
  const auto isBeyond = [&](const Triangle& t) { return (centroid(soup, t) - middle).dot(normal) > 0.0; };
  std::vector<int> sides(soup.points.size(), 0);
  for (const Triangle& t : soup.triangles) {
    for (std::uint32_t v : t) sides[v] |= isBeyond(t) ? 2 : 1;
  }
  for (const Parted& p : pairs) sides[p.a] = sides[p.b] = 0;
  std::vector<std::uint32_t> copyOf(sides.size(), kNone);
  for (std::uint32_t v = 0; v < firstCopy; ++v) {
    if (sides[v] != 3) continue;
    const double width = widths.least * std::pow(widths.largest / widths.least, random.between(0.0, 1.0));
    copyOf[v] = static_cast<std::uint32_t>(soup.points.size());
    soup.points.push_back(soup.points[v] + width * box.diagonal().norm() * random.direction());
    pairs.push_back({v, copyOf[v], belongTogether});
  }
  for (Triangle& t : soup.triangles) {
    if (!isBeyond(t)) continue;
    for (std::uint32_t& v : t) v = copyOf[v] == kNone ? v : copyOf[v];
  }
}

TornMesh torn(TriangleSoup soup, std::uint64_t seed) {
  Random random(seed);
  TornMesh result;
  const auto own = static_cast<std::uint32_t>(soup.points.size());
  part(soup, random, kTears, true, own, result.pairs);
  part(soup, random, kGaps, false, own, result.pairs);
  const BuiltMesh built = buildMesh(soup);
  result.mesh = built.mesh;
  // From points of the soup to vertices of the mesh: face i is triangle i, perhaps turned over.
  std::vector<Vertex> vertexOf(soup.points.size(), kNone);
  for (Face f = 0; f < soup.triangles.size(); ++f) {
    for (std::uint32_t p : soup.triangles[f]) {
      for (Vertex v : built.mesh.triangle(f)) {
        if (built.mesh.position(v) == soup.points[p]) vertexOf[p] = v;
      }
    }
  }
  for (Parted& p : result.pairs) p = {vertexOf[p.a], vertexOf[p.b], p.belongTogether};
  return result;
}

FidelitySample stitch(const TornMesh& input, double nearWeld, Progress progress) {
  HalfEdgeMesh mesh = input.mesh;
  FidelitySample sample;
  sample.cost = cpuMilliseconds([&] { stitchBoundaries(mesh, {}, progress, nearWeld); });
  const auto wrong = std::count_if(input.pairs.begin(), input.pairs.end(), [&](const Parted& p) {
    return (mesh.position(p.a) == mesh.position(p.b)) != p.belongTogether;
  });
  if (!input.pairs.empty()) sample.error = 100.0 * static_cast<double>(wrong) / static_cast<double>(input.pairs.size());
  return sample;
}

}  // namespace

FidelityCase nearWeldCaseOn(const std::string& name, SoupSource soup) {
  const SeededInput<TornMesh> input([soup](std::uint64_t seed) { return torn(*soup(), seed); });
  return {name + ", torn and slit", "by construction", [input](double value, std::uint64_t seed, Progress progress) {
            return stitch(input(seed), value, progress);
          }};
}

std::vector<FidelityCase> nearWeldCases() {
  return {nearWeldCaseOn("sphere of 20,480 faces", sphereSource(5, 50.0)),
          nearWeldCaseOn("torus of 100,000 faces", torusSource(500, 100, 100.0, 20.0))};
}

}  // namespace handwheel
