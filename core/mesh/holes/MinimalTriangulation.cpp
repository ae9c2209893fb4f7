// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/MinimalTriangulation.h"

#include "base/Tolerance.h"
#include "proximity/TriangleIntersection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// The cost of a diagonal's square relative to areas: enough to choose among equal ones, far above their rounding.
constexpr double kDiagonalCost = 1e-9;
// Angles count as equal within this step of (1 - cos) / 2, or rounding would choose among those of a flat hole.
constexpr double kBendStep = 1e-9;

struct Cost {
  double bend = 0.0;  // the largest (1 - cos) / 2 between neighbours, in steps; 0 throughout when area alone counts
  double area = 0.0;
  bool operator<(const Cost& other) const { return bend != other.bend ? bend < other.bend : area < other.area; }
};

class Programme {
 public:
  Programme(const HoleContext& hole, Criterion criterion,
            const std::vector<std::pair<std::uint32_t, std::uint32_t>>& taken)
      : m_hole(hole),
        m_n(hole.loopSize),
        m_bends(criterion == Criterion::Dihedral),
        m_best(m_n * m_n),
        m_middle(m_n * m_n, kNone) {
    // The points are scaled to size 1 at the origin, so that no digits are lost.
    Box box;
    for (std::size_t i = 0; i < m_n; ++i) box.extend(hole.points[i]);
    const double size = std::max(box.diagonal().norm(), std::numeric_limits<double>::min());
    const auto local = [&](const Vec3& p) -> Vec3 { return (p - box.min()) / size; };
    for (std::size_t i = 0; i < m_n; ++i) m_points.push_back(local(hole.points[i]));
    if (m_bends) {
      m_normals.assign(m_n * m_n, Vec3::Zero());
      for (std::size_t i = 0; i < m_n; ++i) {
        const std::size_t j = (i + 1) % m_n;
        const Vec3 behind = (m_points[j] - m_points[i]).cross(local(hole.apexes[i]) - m_points[i]);
        both(m_normals, i, j, behind.stableNormalized());
      }
    }
    for (const auto& [a, b] : taken) {
      if (b != a + 1 && (a != 0 || b + 1 != m_n)) both(m_best, a, b, Cost{kInfinity, kInfinity});
    }
  }

  bool run(Progress progress) {
    for (std::size_t span = 2; span < m_n; ++span) {
      if (progress.cancelled()) return false;
      progress.set(static_cast<double>(span) / static_cast<double>(m_n));
      for (std::size_t i = 0; i + span < m_n; ++i) choose(i, i + span);
    }
    return m_best[m_n - 1].area < kInfinity;
  }

  std::vector<Triangle> triangles() const {
    std::vector<Triangle> result;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, m_n - 1}};
    while (!open.empty()) {
      const auto [i, k] = open.back();
      open.pop_back();
      if (k - i < 2) continue;
      const std::uint32_t m = m_middle[i * m_n + k];
      result.push_back({static_cast<std::uint32_t>(k), m, static_cast<std::uint32_t>(i)});
      open.emplace_back(i, m);
      open.emplace_back(m, k);
    }
    return result;
  }

 private:
  // A table of values per edge between points a and b. Each value is stored twice, so that both ends have a row.
  template <class T>
  void both(std::vector<T>& table, std::size_t a, std::size_t b, const T& value) const {
    table[a * m_n + b] = table[b * m_n + a] = value;
  }

  void choose(std::size_t i, std::size_t k) {
    if (m_best[i * m_n + k].area == kInfinity) return;  // the edge already exists
    const bool isLast = i == 0 && k + 1 == m_n;
    const Vec3 u = m_points[i] - m_points[k];
    const Vec3 behind = m_bends && isLast ? m_normals[m_n - 1] : Vec3::Zero();
    const double diagonal = isLast ? 0.0 : kDiagonalCost * u.squaredNorm();
    Cost least{kInfinity, kInfinity};
    Vec3 leastNormal = Vec3::Zero();
    for (std::size_t m = i + 1; m < k; ++m) {
      const Cost &left = m_best[i * m_n + m], &right = m_best[k * m_n + m];
      Cost sum{std::max(left.bend, right.bend), left.area + right.area + diagonal};
      if (!(sum < least)) continue;
      const Vec3 v = m_points[m] - m_points[k];
      const Vec3 doubled = v.cross(u);
      const double length = doubled.norm();
      sum.area += 0.5 * length;
      if (m_bends) {
        double cosine = std::min(doubled.dot(m_normals[i * m_n + m]), doubled.dot(m_normals[k * m_n + m]));
        if (isLast) cosine = std::min(cosine, doubled.dot(behind));
        sum.bend = std::max(sum.bend, std::round((0.5 - 0.5 * cosine / length) / kBendStep));
      }
      if (!(sum < least) || isFlat(i, m, k, length, u, v)) continue;
      least = sum;
      m_middle[i * m_n + k] = static_cast<std::uint32_t>(m);
      leastNormal = doubled / length;
    }
    both(m_best, i, k, least);
    if (m_bends && !isLast) both(m_normals, i, k, leastNormal);
  }

  // Returns true if a triangle has no area. The exact test is made only in doubt.
  bool isFlat(std::size_t i, std::size_t m, std::size_t k, double doubled, const Vec3& u, const Vec3& v) const {
    if (doubled > tolerance::kLeastSine * u.norm() * v.norm()) return false;
    return !(doubled > 0.0) || isDegenerate({m_hole.points[i], m_hole.points[m], m_hole.points[k]});
  }

  const HoleContext& m_hole;
  std::size_t m_n;
  bool m_bends;
  std::vector<Vec3> m_points;
  std::vector<Cost> m_best;             // cost of the part of the loop between two points
  std::vector<std::uint32_t> m_middle;  // the third corner of the triangle that closes it
  std::vector<Vec3> m_normals;          // normal of that triangle, or of the face behind an edge of the loop
};

}  // namespace

std::optional<Patch> triangulateOptimal(const HoleContext& hole, Criterion criterion,
                                        const std::vector<std::pair<std::uint32_t, std::uint32_t>>& taken,
                                        Progress progress) {
  if (hole.loopSize < 3 || hole.loopSize > tolerance::kOptimalFillEdges) return std::nullopt;
  Programme programme(hole, criterion, taken);
  if (!programme.run(progress)) return std::nullopt;
  Patch patch;
  patch.loopSize = hole.loopSize;
  patch.points = hole.loop();
  patch.triangles = programme.triangles();
  patch.method = criterion == Criterion::Area ? FillMethod::Area : FillMethod::Dihedral;
  return patch;
}

}  // namespace handwheel
