// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/CreaseMatching.h"

#include "base/Tolerance.h"
#include "mesh/holes/HoleDecomposition.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

namespace handwheel {
namespace {

constexpr std::size_t kMostEnds = 64;  // a surface with more of them is rough
constexpr double kAim = 0.5;           // 60° between an end's direction and the straight line to the other;
constexpr double kSureAim = 0.82;      // 35°: no corner of a box comes so near
// Largest distance of creases from their common corner, relative to their distance to it.
constexpr double kMeeting = 0.15;

struct Match {
  double cost;
  std::vector<std::size_t> ends;
  Vec3 point = Vec3::Zero();  // common point of three creases
  bool operator<(const Match& other) const { return cost < other.cost; }
};

std::optional<double> costOf(const HoleContext& hole, const CreaseEnd& a, const CreaseEnd& b, double aim) {
  const Vec3 line = (hole.points[b.chain[0]] - hole.points[a.chain[0]]).stableNormalized();
  const double aimA = a.direction.dot(line), aimB = -b.direction.dot(line);
  if (!(aimA > aim) || !(aimB > aim) || (a.angle > 0.0) != (b.angle > 0.0)) return std::nullopt;
  return (1.0 - aimA) + (1.0 - aimB) + std::abs(a.angle - b.angle) / M_PI;
}

// Returns the number of pieces of a curve of this length if points have this distance.
double piecesOf(const HoleContext& hole, double length, double spacing, double density) {
  const double pieces = std::round(length / spacing * density / tolerance::kPatchDensity);
  return std::min(pieces, static_cast<double>(tolerance::kPatchVerticesPerEdge) * static_cast<double>(hole.loopSize));
}

// Cubic Hermite. Over an arc that leaves its chord by the angle a, Bézier handles of 4/3 · tan(a/2) radii follow a
// circle (Goldapp, "Approximation of circular arcs by cubic polynomials", 1991); that is a tangent of chord /
// cos²(a/2).
std::vector<Vec3> curveBetween(const HoleContext& hole, const CreaseEnd& a, const CreaseEnd& b, double density) {
  const Vec3 &p = hole.points[a.chain[0]], &q = hole.points[b.chain[0]];
  const Vec3 line = (q - p).stableNormalized();
  const double chord = (q - p).norm();
  const double cosine = 0.5 * (a.direction.dot(line) - b.direction.dot(line));  // cosine of the mean angle
  const double length = chord / (0.5 + 0.5 * cosine);
  const Vec3 u = length * a.direction, v = -length * b.direction;
  const double spacing = 0.5 * (hole.edgeLength[a.chain[0]] + hole.edgeLength[b.chain[0]]);
  const double pieces = piecesOf(hole, 0.5 * (chord + length), spacing, density);
  std::vector<Vec3> curve;
  for (int i = 1; i < pieces; ++i) {
    const double t = i / pieces, s = 1.0 - t;
    curve.push_back((1.0 + 2.0 * t) * s * s * p + t * s * s * u + t * t * (3.0 - 2.0 * t) * q - t * t * s * v);
  }
  return curve;
}

// Returns the point nearest to the lines that continue three ends.
std::optional<Match> meetingOf(const HoleContext& hole, const std::vector<CreaseEnd>& ends,
                               const std::vector<std::size_t>& three) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
  const Vec3 origin = hole.points[ends[three[0]].chain[0]];
  for (std::size_t i : three) {
    const Vec3& d = ends[i].direction;
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - d * d.transpose();
    sum += across;
    right += across * (hole.points[ends[i].chain[0]] - origin);
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(sum);
  if (!solver.isInvertible()) return std::nullopt;
  Match match{0.0, three, origin + solver.solve(right)};
  for (std::size_t i : three) {
    const Vec3 displacement = match.point - hole.points[ends[i].chain[0]];
    const double ahead = displacement.dot(ends[i].direction), aside = (displacement - ahead * ends[i].direction).norm();
    if (!(ahead > 0.0) || !(aside < kMeeting * ahead)) return std::nullopt;
    match.cost += aside / ahead;
  }
  return match;
}

class Matching {
 public:
  Matching(const HoleContext& hole, const std::vector<CreaseEnd>& ends, double density)
      : m_hole(hole), m_ends(ends), m_density(density), m_isUsed(ends.size(), false) {}

  void addPairs(double aim) {
    std::vector<Match> matches;
    for (std::size_t a = 0; a < m_ends.size(); ++a) {
      for (std::size_t b = a + 1; b < m_ends.size(); ++b) {
        if (const auto cost = costOf(m_hole, m_ends[a], m_ends[b], aim)) matches.push_back({*cost, {a, b}});
      }
    }
    for (const Match& match : accepted(std::move(matches))) {
      const CreaseEnd &a = m_ends[match.ends[0]], &b = m_ends[match.ends[1]];
      m_creases.pairs.push_back({a, b, curveBetween(m_hole, a, b, m_density)});
    }
  }

  void addCorners() {
    std::vector<Match> matches;
    for (std::size_t a = 0; a < m_ends.size(); ++a) {
      for (std::size_t b = a + 1; b < m_ends.size(); ++b) {
        for (std::size_t c = b + 1; c < m_ends.size(); ++c) {
          if (m_isUsed[a] || m_isUsed[b] || m_isUsed[c]) continue;
          if (auto match = meetingOf(m_hole, m_ends, {a, b, c})) matches.push_back(std::move(*match));
        }
      }
    }
    for (Match& match : accepted(std::move(matches))) {
      std::sort(match.ends.begin(), match.ends.end(),
                [&](std::size_t a, std::size_t b) { return m_ends[a].chain[0] < m_ends[b].chain[0]; });
      CreaseCorner corner;
      corner.point = match.point;
      for (std::size_t k = 0; k < 3; ++k) {
        corner.ends[k] = m_ends[match.ends[k]];
        corner.curves[k] = spoke(corner.ends[k].chain[0], match.point);
      }
      m_creases.corners.push_back(std::move(corner));
    }
  }

  // Two creases that end at one point of the loop mark a corner of the part: a third may lead to it.
  void addCreasesToCorners() {
    std::vector<Match> matches;
    for (std::size_t a = 0; a < m_ends.size(); ++a) {
      for (std::size_t b = a + 1; b < m_ends.size(); ++b) {
        if (m_ends[a].chain[0] != m_ends[b].chain[0]) continue;
        const Vec3& corner = m_hole.points[m_ends[a].chain[0]];
        for (std::size_t c = 0; c < m_ends.size(); ++c) {
          const Vec3 displacement = corner - m_hole.points[m_ends[c].chain[0]];
          const double ahead = displacement.dot(m_ends[c].direction),
                       aside = (displacement - ahead * m_ends[c].direction).norm();
          if (ahead > 0.0 && aside < kMeeting * ahead) matches.push_back({aside / ahead, {c, a}, corner});
        }
      }
    }
    for (const Match& match : accepted(std::move(matches))) {
      const CreaseEnd& end = m_ends[match.ends[0]];
      m_creases.pairs.push_back({end, m_ends[match.ends[1]], spoke(end.chain[0], match.point)});
    }
  }

  const Creases& creases() const { return m_creases; }

 private:
  // The best of the matches that agree with each other and with those before.
  std::vector<Match> accepted(std::vector<Match> matches) {
    std::stable_sort(matches.begin(), matches.end());
    std::vector<Match> result;
    for (Match& match : matches) {
      if (std::any_of(match.ends.begin(), match.ends.end(), [&](std::size_t i) { return m_isUsed[i]; })) continue;
      std::vector<HoleBridge> more = m_bridges;
      const std::size_t count = match.ends.size();
      for (std::size_t k = count == 2 ? 1 : 0; k < count; ++k) {
        const HoleBridge s{m_ends[match.ends[(k + count - 1) % count]].chain[0], m_ends[match.ends[k]].chain[0]};
        // Two of three creases that meet may be adjacent: nothing is cut there.
        const bool isEdge = (s.a + 1) % m_hole.loopSize == s.b || (s.b + 1) % m_hole.loopSize == s.a;
        if (count == 2 || !isEdge) more.push_back(s);
      }
      if (!splitHole(m_hole.loopSize, more)) continue;
      m_bridges = std::move(more);
      for (std::size_t i : match.ends) m_isUsed[i] = true;
      result.push_back(std::move(match));
    }
    return result;
  }

  std::vector<Vec3> spoke(std::uint32_t from, const Vec3& to) const {
    const Vec3& p = m_hole.points[from];
    const double pieces = piecesOf(m_hole, (to - p).norm(), m_hole.edgeLength[from], m_density);
    std::vector<Vec3> curve;
    for (int i = 1; i < pieces; ++i) curve.push_back(p + i / pieces * (to - p));
    return curve;
  }

  const HoleContext& m_hole;
  const std::vector<CreaseEnd>& m_ends;
  double m_density;
  std::vector<bool> m_isUsed;
  std::vector<HoleBridge> m_bridges;
  Creases m_creases;
};

}  // namespace

Creases matchCreases(const HoleContext& hole, const std::vector<CreaseEnd>& ends, double density) {
  if (ends.size() > kMostEnds) return {};
  Matching matching(hole, ends, density);
  matching.addPairs(kSureAim);
  matching.addCorners();
  matching.addCreasesToCorners();
  matching.addPairs(kAim);
  return matching.creases();
}

}  // namespace handwheel
