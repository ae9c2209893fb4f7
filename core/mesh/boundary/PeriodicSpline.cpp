// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/PeriodicSpline.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

// Shortest step of the parameter, in mean chords: shorter ones would only cost digits.
constexpr double kShortestStep = 1e-3;

using Sparse = Eigen::SparseMatrix<double>;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;

Sparse matrix(Eigen::Index n, const std::vector<Eigen::Triplet<double>>& entries) {
  Sparse m(n, n);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

}  // namespace

PeriodicSpline::PeriodicSpline(std::span<const Vec3> points, double lambda) : m_points(points.begin(), points.end()) {
  const std::size_t n = points.size();
  double length = 0.0;
  for (std::size_t i = 0; i < n; ++i) m_steps.push_back((points[(i + 1) % n] - points[i]).stableNorm());
  for (const double step : m_steps) length += step / static_cast<double>(n);
  for (double& step : m_steps) step = std::max(step / length, kShortestStep);

  // R γ = Qᵀ g joins the second derivatives γ to the values g.
  std::vector<Eigen::Triplet<double>> r, q;
  Rows values(n, 3);
  for (std::size_t k = 0; k < n; ++k) {
    const auto i = static_cast<int>(k), next = static_cast<int>((k + 1) % n),
               before = static_cast<int>((k + n - 1) % n);
    const double h = m_steps[k], last = m_steps[(k + n - 1) % n];
    r.emplace_back(i, i, (last + h) / 3.0);
    r.emplace_back(i, next, h / 6.0);
    r.emplace_back(next, i, h / 6.0);
    q.emplace_back(before, i, 1.0 / last);
    q.emplace_back(i, i, -1.0 / last - 1.0 / h);
    q.emplace_back(next, i, 1.0 / h);
    values.row(i) = points[k] - points[0];  // small numbers far from the origin too
  }
  const auto size = static_cast<Eigen::Index>(n);
  const Sparse R = matrix(size, r), Q = matrix(size, q);
  const Sparse system = R + lambda * Sparse(Q.transpose() * Q);
  const Rows bends = Eigen::SimplicialLDLT<Sparse>(system).solve(Rows(Q.transpose() * values));
  const Rows shift = -lambda * (Q * bends);
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    m_points[i] += shift.row(row).transpose();
    m_bends.emplace_back(bends.row(row).transpose());
  }
}

Vec3 PeriodicSpline::at(std::size_t i, double u) const {
  const std::size_t next = (i + 1) % size();
  const double h = m_steps[i], v = 1.0 - u;
  return v * m_points[i] + u * m_points[next] +
         (h * h / 6.0) * ((v * v * v - v) * m_bends[i] + (u * u * u - u) * m_bends[next]);
}

double lambdaForWavelength(double points) {
  if (!(points >= 2.0)) return 0.0;
  // For even spacing a wave of angle θ a point keeps 1 / (1 + λ (2 − 2cosθ)² / ((2 + cosθ) / 3)).
  const double c = std::cos(2.0 * M_PI / points), bend = 2.0 - 2.0 * c;
  return (2.0 + c) / 3.0 / (bend * bend);
}

}  // namespace handwheel
