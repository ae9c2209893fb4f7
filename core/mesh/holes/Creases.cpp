// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/Creases.h"

#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/FaceNormal.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace handwheel {
namespace {

constexpr std::size_t kSeen = 4;           // points of a crease that determine its direction
constexpr std::size_t kAlongLoop = 8;      // edges of the loop that may belong to the crease
constexpr double kTurnInSurface = 0.5;     // cosine: the most that a crease turns at a vertex, 60°
constexpr double kTurnAlongLoop = 0.9659;  // 15°: half of the smallest angle that a good triangle has

Vec3 normalOf(const HoleContext& hole, const Triangle& t) {
  return unitNormal({hole.points[t[0]], hole.points[t[1]], hole.points[t[2]]});
}

// Returns the direction of a crease at its end: the tangent of the parabola through the first three points (Bessel's
// end condition), or of the line through two.
Vec3 directionOf(const HoleContext& hole, const std::vector<std::uint32_t>& chain) {
  const Vec3 u = hole.points[chain[0]] - hole.points[chain[1]];
  if (chain.size() < 3) return u.stableNormalized();
  const Vec3 v = hole.points[chain[1]] - hole.points[chain[2]];
  const double s = u.norm(), t = v.norm();
  if (!(s > 0.0) || !(t > 0.0)) return u.stableNormalized();
  const Vec3 slope = u / s, before = v / t;
  return (slope + (slope - before) * (s / (s + t))).stableNormalized();
}

// The creases of the ring.
class CreaseSearch {
 public:
  CreaseSearch(const HoleContext& hole, double least) : m_hole(hole) {
    EdgeTable(hole.ring, hole.points.size()).forEachEdge([&](std::uint32_t a, std::uint32_t b, auto run) {
      if (run.size() != 2) return;
      const Triangle &f = hole.ring[run[0].halfEdge / 3], &g = hole.ring[run[1].halfEdge / 3];
      const Vec3 n = normalOf(hole, f), m = normalOf(hole, g);
      const double angle = std::atan2(n.cross(m).norm(), n.dot(m));
      if (!(angle > least)) return;
      const Vec3& opposite = hole.points[g[(run[1].halfEdge + 2) % 3]];
      const double signedAngle = (opposite - hole.points[a]).dot(n) <= 0.0 ? angle : -angle;
      m_at[a].emplace_back(b, signedAngle);
      m_at[b].emplace_back(a, signedAngle);
    });
  }

  std::vector<CreaseEnd> ends() const {
    std::vector<CreaseEnd> result;
    for (const auto& [v, creases] : m_at) {
      if (v >= m_hole.loopSize) break;
      for (const auto& [next, angle] : creases) {
        if (next < m_hole.loopSize) continue;
        std::optional<CreaseEnd> end = follow(v, next, angle);
        if (end) result.push_back(alongLoop(std::move(*end)));
      }
    }
    return result;
  }

 private:
  using Neighbours = std::vector<std::pair<std::uint32_t, double>>;  // with the angle there

  std::optional<CreaseEnd> follow(std::uint32_t from, std::uint32_t next, double angle) const {
    CreaseEnd end{{from, next}, Vec3::Zero(), angle};
    bool isCorner = false;
    while (end.chain.size() < kSeen) {
      const std::uint32_t last = end.chain.back(), before = end.chain[end.chain.size() - 2];
      const Neighbours& on = m_at.at(last);
      isCorner = on.size() > 2;
      if (on.size() != 2) break;
      const std::uint32_t after = on[0].first == before ? on[1].first : on[0].first;
      const Vec3 u = m_hole.points[last] - m_hole.points[before], v = m_hole.points[after] - m_hole.points[last];
      if (after < m_hole.loopSize || !(u.dot(v) > kTurnInSurface * u.norm() * v.norm())) break;
      end.chain.push_back(after);
    }
    if (end.chain.size() < 3 && !isCorner) return std::nullopt;
    end.direction = directionOf(m_hole, end.chain);
    return end;
  }

  // Follows the loop while it continues the crease: there one side of the crease is missing.
  CreaseEnd alongLoop(CreaseEnd end) const {
    const auto n = static_cast<std::uint32_t>(m_hole.loopSize);
    for (std::size_t i = 0; i < kAlongLoop; ++i) {
      const std::uint32_t at = end.chain[0];
      double best = kTurnAlongLoop;
      std::uint32_t next = kNone;
      for (std::uint32_t w : {(at + 1) % n, (at + n - 1) % n}) {
        const double cosine = (m_hole.points[w] - m_hole.points[at]).stableNormalized().dot(end.direction);
        if (cosine <= best || w == end.chain[1]) continue;
        best = cosine;
        next = w;
      }
      if (next == kNone) break;
      end.chain.insert(end.chain.begin(), next);
      end.direction = directionOf(m_hole, end.chain);
    }
    return end;
  }

  const HoleContext& m_hole;
  std::map<std::uint32_t, Neighbours> m_at;
};

}  // namespace

std::vector<CreaseEnd> findCreaseEnds(const HoleContext& hole, double angle) {
  return CreaseSearch(hole, angle).ends();
}

}  // namespace handwheel
