// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/Orientation.h"

namespace handwheel {
namespace {

// Returns the other half-edge on each edge of exactly two triangles; kNone for other edges.
std::vector<std::uint32_t> neighbours(const EdgeTable& edges, std::size_t triangleCount, Progress progress) {
  std::vector<std::uint32_t> other(3 * triangleCount, kNone);
  const auto join = [&](std::uint32_t, std::uint32_t, std::span<const EdgeTable::Entry> run) {
    if (run.size() != 2) return;
    other[run[0].halfEdge] = run[1].halfEdge;
    other[run[1].halfEdge] = run[0].halfEdge;
  };
  edges.forEachEdge(join, progress);
  return other;
}

}  // namespace

std::vector<bool> trianglesToReverse(const EdgeTable& edges, std::span<const Triangle> triangles, Progress progress) {
  const std::vector<std::uint32_t> other = neighbours(edges, triangles.size(), progress.part(0.0, 0.5));
  const auto from = [&](std::uint32_t h) { return triangles[h / 3][h % 3]; };

  std::vector<bool> turn(triangles.size(), false);
  std::vector<bool> reached(triangles.size(), false);
  std::vector<std::uint32_t> part;
  std::size_t visited = 0;
  for (std::uint32_t seed = 0; seed < triangles.size(); ++seed) {
    if (reached[seed]) continue;
    part.assign(1, seed);
    reached[seed] = true;
    std::size_t reversedCount = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      if (!pollProgress(visited++, triangles.size(), progress.part(0.5, 1.0))) return turn;
      const std::uint32_t f = part[i];
      for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
        if (other[h] == kNone || reached[other[h] / 3]) continue;
        const std::uint32_t g = other[h] / 3;
        reached[g] = true;
        const bool sameDirection = from(h) == from(other[h]);
        turn[g] = turn[f] != sameDirection;
        reversedCount += turn[g];
        part.push_back(g);
      }
    }
    if (2 * reversedCount > part.size()) {
      for (std::uint32_t f : part) turn[f] = !turn[f];
    }
  }
  return turn;
}

}  // namespace handwheel
