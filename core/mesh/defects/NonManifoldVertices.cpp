// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/defects/NonManifoldVertices.h"

#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/DisjointSets.h"
#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/PositionTriangles.h"

#include <algorithm>

namespace handwheel {
namespace {

// The triangles at each vertex, bucketed.
struct Incidence {
  std::vector<std::size_t> starts;  // per vertex
  std::vector<std::uint32_t> triangles;

  Incidence(std::span<const Triangle> all, std::size_t vertexCount) : starts(vertexCount + 1, 0) {
    for (const Triangle& t : all) {
      if (hasRepeatedVertex(t)) continue;
      for (std::uint32_t v : t) ++starts[v + 1];
    }
    for (std::size_t v = 0; v < vertexCount; ++v) starts[v + 1] += starts[v];
    triangles.resize(starts.back());
    std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
    for (std::uint32_t f = 0; f < all.size(); ++f) {
      if (hasRepeatedVertex(all[f])) continue;
      for (std::uint32_t v : all[f]) triangles[next[v]++] = f;
    }
  }
};

}  // namespace

std::vector<std::uint32_t> findNonManifoldVertices(std::span<const Triangle> triangles, std::size_t vertexCount,
                                                   Progress progress) {
  const Incidence incidence(triangles, vertexCount);
  std::vector<std::uint32_t> found;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;  // other vertex of an edge, number of its triangle at v
  for (std::uint32_t v = 0; v < vertexCount; ++v) {
    if (!pollProgress(v, vertexCount, progress)) break;
    const std::size_t first = incidence.starts[v];
    const std::size_t count = incidence.starts[v + 1] - first;
    if (count < 2) continue;
    ends.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
      for (std::uint32_t u : triangles[incidence.triangles[first + i]]) {
        if (u != v) ends.emplace_back(u, i);
      }
    }
    std::sort(ends.begin(), ends.end());
    DisjointSets sets(count);
    for (std::size_t k = 1; k < ends.size(); ++k) {
      if (ends[k].first == ends[k - 1].first) sets.join(ends[k].second, ends[k - 1].second);
    }
    std::size_t groups = 0;
    for (std::uint32_t i = 0; i < count; ++i) groups += sets.root(i) == i;
    if (groups > 1) found.push_back(v);
  }
  return found;
}

std::vector<Vertex> findNonManifoldVertices(const HalfEdgeMesh& mesh, Progress progress) {
  const PositionTriangles byPosition(mesh, progress.part(0.0, 0.5));
  if (progress.cancelled()) return {};
  const std::vector<Vertex>& first = byPosition.classes.representative;
  std::vector<Vertex> found = findNonManifoldVertices(byPosition.triangles, first.size(), progress.part(0.5, 1.0));
  if (progress.cancelled()) return {};
  for (Vertex& v : found) v = first[v];
  return found;
}

}  // namespace handwheel
