// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/Fairing.h"

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

// Largest cotangent of an angle, 0.06°, so that needles do not dominate.
constexpr double kSharpest = 1e3;

struct CornerShape {
  std::array<double, 3> cotangents{};
  std::array<double, 3> areas{};  // the part of the triangle that belongs to each corner
};

// Mixed Voronoi areas: Meyer et al., "Discrete differential-geometry operators for triangulated 2-manifolds", 2003,
// section 3.3.
CornerShape shapeOf(const std::vector<Vec3>& points, const Triangle& t) {
  CornerShape shape;
  std::array<double, 3> squares{};  // squared length of the edge from corner k to the next
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

// Returns the given vertices and those that share a triangle with them.
std::vector<bool> grown(const std::vector<bool>& some, const std::vector<Triangle>& triangles) {
  std::vector<bool> more = some;
  for (const Triangle& t : triangles) {
    if (!some[t[0]] && !some[t[1]] && !some[t[2]]) continue;
    for (std::uint32_t v : t) more[v] = true;
  }
  return more;
}

// The equations of the minimum of a quadratic energy: normal · x = right.
struct Equations {
  Matrix normal;
  Eigen::MatrixX3d right;
};

class Energy {
 public:
  Energy(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, const std::vector<bool>& isFree)
      : m_points(points), m_triangles(triangles), m_isFree(isFree), m_column(points.size(), -1) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (isFree[i]) m_column[i] = m_columns++;
    }
    for (const Triangle& t : triangles) m_shapes.push_back(shapeOf(points, t));
  }

  // Returns the free points of least energy, one per row; nothing if the minimum is not unique.
  std::optional<Eigen::MatrixX3d> least(Continuity continuity, Progress progress) {
    const Equations equations = equationsFor(continuity);
    progress.set(0.2);
    Eigen::SimplicialLDLT<Matrix> factor;
    factor.analyzePattern(equations.normal);
    progress.set(0.4);
    if (progress.cancelled()) return std::nullopt;
    factor.factorize(equations.normal);
    progress.set(0.8);
    if (factor.info() != Eigen::Success || progress.cancelled()) return std::nullopt;
    Eigen::MatrixX3d x = factor.solve(equations.right);
    if (factor.info() != Eigen::Success || !x.allFinite()) return std::nullopt;
    if (continuity == Continuity::Curvature && magnification(equations.normal, factor) > kLostDigits)
      return std::nullopt;
    return x;
  }

  Index columnOf(std::size_t i) const { return m_column[i]; }

 private:
  // Largest accepted rounding error of lengths, relative to the size of the whole.
  static constexpr double kLostDigits = 1e-7;

  // Calls use(t, a, b, w) for the edges of each triangle, with half the cotangent of the angle across: the weights of
  // the Laplacian, and of Σ |∇f|² = Σ w (f(a) − f(b))².
  template <class Use>
  void forEdges(const Use& use) const {
    for (std::size_t i = 0; i < m_triangles.size(); ++i) {
      const Triangle& t = m_triangles[i];
      for (std::size_t k = 0; k < 3; ++k) use(t, t[k], t[(k + 1) % 3], 0.5 * m_shapes[i].cotangents[(k + 2) % 3]);
    }
  }

  // Returns the rounding error of a known solution, all ones. It grows with the sixth power of (size / edge).
  static double magnification(const Matrix& normal, const Eigen::SimplicialLDLT<Matrix>& factor) {
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(normal.cols());
    return (factor.solve(normal * ones) - ones).cwiseAbs().maxCoeff();
  }

  Equations equationsFor(Continuity continuity) {
    if (continuity == Continuity::Position) return membrane();
    const std::vector<bool> nextToFree = grown(m_isFree, m_triangles);
    const bool isTangent = continuity == Continuity::Tangent;
    setLaplacian(isTangent ? nextToFree : grown(nextToFree, m_triangles));
    if (isTangent) return {m_free.transpose() * m_free, -(m_free.transpose() * m_fixed)};
    const Matrix half = m_free.transpose() * gradientOfLaplacian();
    return {half * m_free, -(half * m_fixed)};
  }

  Equations membrane() const {
    std::vector<Eigen::Triplet<double>> entries;
    Equations result{Matrix(m_columns, m_columns), Eigen::MatrixX3d::Zero(m_columns, 3)};
    forEdges([&](const Triangle&, std::uint32_t a, std::uint32_t b, double weight) {
      for (const auto& [v, other] : {std::pair{a, b}, std::pair{b, a}}) {
        if (m_column[v] < 0) continue;
        entries.emplace_back(m_column[v], m_column[v], weight);
        if (m_column[other] >= 0) {
          entries.emplace_back(m_column[v], m_column[other], -weight);
        } else {
          result.right.row(m_column[v]) += weight * m_points[other].transpose();
        }
      }
    });
    result.normal.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  // Δ · √area, a row for each vertex that counts and has a closed fan.
  void setLaplacian(const std::vector<bool>& counts) {
    setRows(counts);
    std::vector<Eigen::Triplet<double>> entries;
    m_fixed = Eigen::MatrixX3d::Zero(m_rows, 3);
    const auto put = [&](Index r, std::uint32_t v, double value) {
      if (m_column[v] >= 0) {
        entries.emplace_back(r, m_column[v], value);
      } else {
        m_fixed.row(r) += value * m_points[v].transpose();
      }
    };
    forEdges([&](const Triangle&, std::uint32_t a, std::uint32_t b, double weight) {
      for (const auto& [v, other] : {std::pair{a, b}, std::pair{b, a}}) {
        if (m_row[v] < 0) continue;
        const double value = weight / std::sqrt(m_area[v]);
        put(m_row[v], other, value);
        put(m_row[v], v, -value);
      }
    });
    m_free.resize(m_rows, m_columns);
    m_free.setFromTriplets(entries.begin(), entries.end());
  }

  void setRows(const std::vector<bool>& counts) {
    m_area.assign(m_points.size(), 0.0);
    std::vector<std::int64_t> balance(m_points.size(), 0);  // 0 where the fan is closed
    for (std::size_t i = 0; i < m_triangles.size(); ++i) {
      const Triangle& t = m_triangles[i];
      for (std::size_t k = 0; k < 3; ++k) {
        m_area[t[k]] += m_shapes[i].areas[k];
        // Each edge of a closed fan leaves its vertex once and comes to it once; the sum of far ends tells.
        balance[t[k]] += static_cast<std::int64_t>(t[(k + 1) % 3]) - static_cast<std::int64_t>(t[(k + 2) % 3]);
      }
    }
    m_row.assign(m_points.size(), -1);
    m_rows = 0;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
      if (counts[i] && balance[i] == 0 && m_area[i] > 0.0) m_row[i] = m_rows++;
    }
  }

  // S so that Σ |∇Δx|² = |Δ · √area|ᵀ S |Δ · √area|, over the triangles whose corners all have rows.
  Matrix gradientOfLaplacian() const {
    std::vector<Eigen::Triplet<double>> entries;
    forEdges([&](const Triangle& t, std::uint32_t a, std::uint32_t b, double weight) {
      if (m_row[t[0]] < 0 || m_row[t[1]] < 0 || m_row[t[2]] < 0) return;
      entries.emplace_back(m_row[a], m_row[a], weight / m_area[a]);
      entries.emplace_back(m_row[b], m_row[b], weight / m_area[b]);
      const double mixed = weight / std::sqrt(m_area[a] * m_area[b]);
      entries.emplace_back(m_row[a], m_row[b], -mixed);
      entries.emplace_back(m_row[b], m_row[a], -mixed);
    });
    Matrix result(m_rows, m_rows);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  const std::vector<Vec3>& m_points;
  const std::vector<Triangle>& m_triangles;
  const std::vector<bool>& m_isFree;
  std::vector<CornerShape> m_shapes;  // per triangle
  std::vector<Index> m_column;        // per free point
  Index m_columns = 0;
  std::vector<Index> m_row;  // per vertex whose Laplacian counts
  Index m_rows = 0;
  std::vector<double> m_area;
  Matrix m_free;             // Δ · √area of the free points,
  Eigen::MatrixX3d m_fixed;  // and of the fixed ones
};

}  // namespace

bool fair(std::vector<Vec3>& points, const std::vector<Triangle>& triangles, const std::vector<bool>& isFree,
          Continuity continuity, Progress progress) {
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

  Energy energy(local, triangles, isFree);
  const std::optional<Eigen::MatrixX3d> least = energy.least(continuity, progress);
  if (!least) return false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (isFree[i]) points[i] = origin + size * Vec3(least->row(energy.columnOf(i)).transpose());
  }
  return true;
}

}  // namespace handwheel
