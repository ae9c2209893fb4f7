// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/RoundingCollisions.h"

#include "mesh/defects/NonManifoldVertices.h"
#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/Weld.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <set>

namespace handwheel {

namespace {

using Key = std::array<double, 3>;
Key keyOf(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

// Positions as the mesh means them and as a reader of the file sees them. "Meant" and "seen" below are class numbers.
struct Positions {
  PointClasses meant;
  PointClasses seen;
  std::uint32_t seenOf(std::uint32_t meantClass) const { return seen.classOf[meant.representative[meantClass]]; }
};

// Returns both ends of an edge in the mesh, as meant classes.
std::pair<std::uint32_t, std::uint32_t> meantEdge(const Positions& positions, const Triangle& t, std::uint32_t corner) {
  return std::minmax(positions.meant.classOf[t[corner]], positions.meant.classOf[t[(corner + 1) % 3]]);
}

// Returns the seen classes that have several meant ones, such that welding them spoils the class or an edge that was
// sound before.
std::vector<bool> spoilingClasses(const Positions& positions, const std::vector<Triangle>& triangles,
                                  Progress progress) {
  const std::size_t count = positions.seen.representative.size();
  std::vector<std::uint32_t> members(count, 0);
  for (std::uint32_t m = 0; m < positions.meant.representative.size(); ++m) ++members[positions.seenOf(m)];

  std::vector<Triangle> seenTriangles(triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) seenTriangles[f][k] = positions.seen.classOf[triangles[f][k]];
  }
  std::vector<bool> spoiling(count, false);
  for (std::uint32_t c : findNonManifoldVertices(seenTriangles, count, progress)) spoiling[c] = members[c] > 1;
  const EdgeTable edges(seenTriangles, count, progress);
  edges.forEachEdge(
      [&](std::uint32_t low, std::uint32_t high, std::span<const EdgeTable::Entry> run) {
        if (run.size() < 2 || (members[low] < 2 && members[high] < 2)) return;
        const auto ends = [&](const EdgeTable::Entry& e) {
          return meantEdge(positions, triangles[e.halfEdge / 3], e.halfEdge % 3);
        };
        const bool severalMeant =
            std::any_of(run.begin(), run.end(), [&](const auto& e) { return ends(e) != ends(run[0]); });
        const auto forward = std::count_if(run.begin(), run.end(), [&](const EdgeTable::Entry& e) {
          return seenTriangles[e.halfEdge / 3][e.halfEdge % 3] == low;
        });
        const bool sound = run.size() == 2 && forward == 1;
        if (!severalMeant || sound) return;
        spoiling[low] = spoiling[low] || members[low] > 1;
        spoiling[high] = spoiling[high] || members[high] > 1;
      },
      progress);
  return spoiling;
}

// Returns the meant classes to move: for each spoiling class all but the one that rounding did not move, or else the
// first.
std::vector<bool> classesToMove(const Positions& positions, const std::vector<bool>& spoiling,
                                const TriangleSoup& exact, const TriangleSoup& inFile) {
  const std::size_t count = positions.meant.representative.size();
  std::vector<std::uint32_t> stays(spoiling.size(), kNone);
  const auto isFixed = [&](std::uint32_t m) {
    const std::uint32_t p = positions.meant.representative[m];
    return exact.points[p] == inFile.points[p];
  };
  for (std::uint32_t m = 0; m < count; ++m) {
    std::uint32_t& keeper = stays[positions.seenOf(m)];
    if (keeper == kNone || isFixed(m)) keeper = m;
  }
  std::vector<bool> moves(count, false);
  for (std::uint32_t m = 0; m < count; ++m) {
    moves[m] = spoiling[positions.seenOf(m)] && stays[positions.seenOf(m)] != m;
  }
  return moves;
}

// Returns one step at the precision of p's largest coordinate: smaller ones would be lost in the arithmetic of other
// programs.
double visibleStep(const Vec3& p) {
  const auto largest = static_cast<float>(p.cwiseAbs().maxCoeff());
  return std::max(std::nextafter(largest, FLT_MAX) - largest, FLT_MIN);
}

// Returns the free position next to p that lies furthest towards "inwards"; p itself if all 26 are taken.
Vec3 freeNeighbour(const Vec3& p, const Vec3& inwards, const std::set<Key>& taken) {
  const double step = visibleStep(p);
  Vec3 best = p;
  double bestScore = -HUGE_VAL;
  for (int code = 0; code < 27; ++code) {
    const Vec3 direction(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
    const Vec3 position = rounded(Vec3(p + step * direction), NumberType::Float32);
    const double score = direction.isZero() ? -HUGE_VAL : direction.normalized().dot(inwards);
    if (score > bestScore && !taken.contains(keyOf(position))) {
      best = position;
      bestScore = score;
    }
  }
  return best;
}

// Returns directions towards the middle of the faces around each class that moves.
std::vector<Vec3> inwardDirections(const Positions& positions, const std::vector<bool>& moves,
                                   const TriangleSoup& inFile) {
  std::vector<Vec3> directions(moves.size(), Vec3::Zero());
  for (const Triangle& t : inFile.triangles) {
    for (std::uint32_t v : t) {
      const std::uint32_t m = positions.meant.classOf[v];
      if (!moves[m]) continue;
      for (std::uint32_t u : t) directions[m] += inFile.points[u] - inFile.points[v];
    }
  }
  return directions;
}

}  // namespace

std::vector<std::uint32_t> separateRoundedVertices(const TriangleSoup& exact, TriangleSoup& inFile, Progress progress) {
  constexpr int kRounds = 4;  // a parted vertex may meet further ones
  Positions positions{classifyPoints(exact.points, progress.part(0.0, 0.2)), {}};
  std::vector<bool> isParted(exact.points.size(), false);
  for (int round = 0; round < kRounds; ++round) {
    const Progress now = progress.part(0.2 + 0.2 * round, 0.4 + 0.2 * round);
    positions.seen = classifyPoints(inFile.points, now.part(0.0, 0.4));
    if (progress.cancelled()) return {};
    if (positions.seen.representative.size() >= positions.meant.representative.size()) break;
    const std::vector<bool> spoiling = spoilingClasses(positions, exact.triangles, now.part(0.4, 1.0));
    if (progress.cancelled()) return {};
    if (std::find(spoiling.begin(), spoiling.end(), true) == spoiling.end()) break;

    const std::vector<bool> moves = classesToMove(positions, spoiling, exact, inFile);
    const std::vector<Vec3> inwards = inwardDirections(positions, moves, inFile);
    std::set<Key> taken;
    for (const Vec3& p : inFile.points) taken.insert(keyOf(p));
    std::vector<Vec3> moved(moves.size());
    for (std::uint32_t m = 0; m < moves.size(); ++m) {
      if (!moves[m]) continue;
      moved[m] = freeNeighbour(inFile.points[positions.meant.representative[m]], inwards[m], taken);
      taken.insert(keyOf(moved[m]));
    }
    for (std::size_t v = 0; v < exact.points.size(); ++v) {
      const std::uint32_t m = positions.meant.classOf[v];
      if (!moves[m] || moved[m] == inFile.points[v]) continue;
      inFile.points[v] = moved[m];
      isParted[v] = true;
    }
  }
  std::vector<std::uint32_t> parted;
  for (std::uint32_t v = 0; v < isParted.size(); ++v) {
    if (isParted[v]) parted.push_back(v);
  }
  return parted;
}

}  // namespace handwheel
