// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/Fairing.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace handwheel {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Index = Eigen::Index;

// No angle counts as sharper than this cotangent, 0.06°: needles must not drown the rest.
constexpr double kSharpest = 1e3;

struct CornerShape {
  std::array<double, 3> cotangents{};
  std::array<double, 3> areas{};  // the part of the triangle that belongs to each corner
};

// Mixed Voronoi areas: Meyer et al., "Discrete differential-geometry operators for triangulated 2-manifolds", 2003,
// section 3.3.
CornerShape shapeOf(const std::vector<Vec3>& points, const Triangle& t) {
  CornerShape shape;
  std::array<double, 3> squares{};  // of the edge from corner k to the next
  double area = 0.0;
  int obtuse = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 u = points[t[(k + 1) % 3]] - points[t[k]], v = points[t[(k + 2) % 3]] - points[t[k]];
    area = 0.5 * u.cross(v).norm();
    squares[k] = u.squaredNorm();
    if (u.dot(v) < 0.0) obtuse = static_cast<int>(k);
    shape.cotangents[k] = std::clamp(u.dot(v) / std::max(2.0 * area, 1e-300), -kSharpest, kSharpest);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    if (obtuse < 0) {
      shape.areas[k] = 0.125 * (squares[k] * shape.cotangents[m] + squares[m] * shape.cotangents[l]);
    } else {
      shape.areas[k] = area * (static_cast<int>(k) == obtuse ? 0.5 : 0.25);
    }
  }
  return shape;
}

class Energy {
 public:
  Energy(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, const std::vector<bool>& isFree)
      : m_column(points.size(), -1), m_balance(points.size(), 0), m_area(points.size(), 0.0) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (isFree[i]) m_column[i] = m_columns++;
    }
    std::vector<bool> counts(points.size(), false);  // free, or next to a free one
    for (const Triangle& t : triangles) {
      if (!isFree[t[0]] && !isFree[t[1]] && !isFree[t[2]]) continue;
      for (std::uint32_t v : t) counts[v] = true;
    }
    for (const Triangle& t : triangles) add(points, t, counts);
    build(points, counts);
  }

  // The free points where the energy is least, one to a row; none when there is no single such place.
  std::optional<Eigen::MatrixX3d> least() const {
    const Matrix normal = m_free.transpose() * m_free;
    const Eigen::SimplicialLDLT<Matrix> factor(normal);
    if (factor.info() != Eigen::Success) return std::nullopt;
    Eigen::MatrixX3d x = factor.solve(Eigen::MatrixX3d(-(m_free.transpose() * m_fixed)));
    if (factor.info() != Eigen::Success || !x.allFinite()) return std::nullopt;
    return x;
  }

  Index columnOf(std::size_t i) const { return m_column[i]; }

 private:
  struct Weight {
    std::uint32_t row, other;
    double value;
  };

  void add(const std::vector<Vec3>& points, const Triangle& t, const std::vector<bool>& counts) {
    if (!counts[t[0]] && !counts[t[1]] && !counts[t[2]]) return;
    const CornerShape shape = shapeOf(points, t);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      const double half = 0.5 * shape.cotangents[(k + 2) % 3];
      m_area[a] += shape.areas[k];
      // Each edge of a closed fan leaves its vertex once and comes to it once; the sum of far ends tells.
      m_balance[a] += static_cast<std::int64_t>(b) - static_cast<std::int64_t>(t[(k + 2) % 3]);
      if (counts[a]) m_weights.push_back({a, b, half});
      if (counts[b]) m_weights.push_back({b, a, half});
    }
  }

  void build(const std::vector<Vec3>& points, const std::vector<bool>& counts) {
    std::vector<Index> row(points.size(), -1);
    Index rows = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (counts[i] && m_balance[i] == 0 && m_area[i] > 0.0) row[i] = rows++;
    }
    std::vector<Eigen::Triplet<double>> entries;
    m_fixed = Eigen::MatrixX3d::Zero(rows, 3);
    const auto put = [&](Index r, std::uint32_t v, double value) {
      if (m_column[v] >= 0) {
        entries.emplace_back(r, m_column[v], value);
      } else {
        m_fixed.row(r) += value * points[v].transpose();
      }
    };
    for (const Weight& w : m_weights) {
      if (row[w.row] < 0) continue;
      const double value = w.value / std::sqrt(m_area[w.row]);
      put(row[w.row], w.other, value);
      put(row[w.row], w.row, -value);
    }
    m_free.resize(rows, m_columns);
    m_free.setFromTriplets(entries.begin(), entries.end());
  }

  std::vector<Index> m_column;  // of each free point
  Index m_columns = 0;
  std::vector<std::int64_t> m_balance;  // 0 where the fan is closed
  std::vector<double> m_area;
  std::vector<Weight> m_weights;
  Matrix m_free;             // Δ / √area of the free points,
  Eigen::MatrixX3d m_fixed;  // and of the fixed ones
};

}  // namespace

bool fair(std::vector<Vec3>& points, const std::vector<Triangle>& triangles, const std::vector<bool>& isFree) {
  // Around the origin, and of size 1, so that no digits are lost and nothing under- or overflows.
  Box box;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (isFree[i]) box.extend(points[i]);
  }
  if (box.isEmpty()) return true;
  std::vector<Vec3> local = points;
  Box all;
  for (const Triangle& t : triangles) {
    for (std::uint32_t v : t) all.extend(points[v]);
  }
  const double size = all.diagonal().norm();
  if (!(size > 0.0) || !std::isfinite(size)) return false;
  const Vec3 origin = box.center();
  for (Vec3& p : local) p = (p - origin) / size;

  const Energy energy(local, triangles, isFree);
  const std::optional<Eigen::MatrixX3d> least = energy.least();
  if (!least) return false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (isFree[i]) points[i] = origin + size * Vec3(least->row(energy.columnOf(i)).transpose());
  }
  return true;
}

}  // namespace handwheel
