// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nurbs/BezierArc.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

using Poles = std::array<Eigen::Vector3d, kHighestDegree + 1>;

// de Casteljau's algorithm over the first degree + 1 poles.
Eigen::Vector3d evaluate(Poles poles, int degree, double t) {
  for (int level = degree; level > 0; --level) {
    for (int i = 0; i < level; ++i) poles[i] = (1.0 - t) * poles[i] + t * poles[i + 1];
  }
  return poles[0];
}

double distanceToSegment(const ProfilePoint& p, const ProfilePoint& end) {
  const double length = end.squaredNorm();
  const double along = length > 0.0 ? std::clamp(p.dot(end) / length, 0.0, 1.0) : 0.0;
  return (p - along * end).norm();
}

}  // namespace

std::array<ProfilePoint, kHighestDegree + 1> BezierArc::derivatives(double t) const {
  Poles homogeneous;  // derivatives of (w r, w z, w)
  Poles differences = poles;
  double factor = 1.0;
  for (int order = 0; order <= kHighestDegree; ++order) {
    homogeneous[order].setZero();
    if (order > degree) continue;
    homogeneous[order] = factor * evaluate(differences, degree - order, t);
    factor *= degree - order;
    for (int i = 0; i < degree - order; ++i) differences[i] = differences[i + 1] - differences[i];
  }
  // The quotient rule: A = w C, so A⁽ᵏ⁾ = Σ binomial(k, i) w⁽ⁱ⁾ C⁽ᵏ⁻ⁱ⁾.
  constexpr double binomial[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
  std::array<ProfilePoint, kHighestDegree + 1> result;
  for (int order = 0; order <= kHighestDegree; ++order) {
    ProfilePoint sum = homogeneous[order].head<2>();
    for (int i = 1; i <= order; ++i) sum -= binomial[order][i] * homogeneous[i].z() * result[order - i];
    result[order] = sum / homogeneous[0].z();
  }
  result[0] += origin;
  result[0].x() = std::max(0.0, result[0].x());  // rounding must not carry it across the axis
  return result;
}

ProfilePoint BezierArc::direction(double t) const {
  double size = 0.0;
  for (int i = 0; i <= degree; ++i) size = std::max(size, poles[i].head<2>().norm() / poles[i].z());
  const auto derivative = derivatives(t);
  for (int order = 1; order <= kHighestDegree; ++order) {
    // A smaller derivative is only rounding of zero.
    if (derivative[order].norm() <= 1e-12 * size) continue;
    const double backwards = t >= 1.0 && order % 2 == 0 ? -1.0 : 1.0;
    return backwards * derivative[order].normalized();
  }
  return ProfilePoint::Zero();
}

// With Q the nearest points of the chord to the poles P, the arc is as far from Σ wBQ / Σ wB, a point of the chord, as
// Σ wB(P - Q) / Σ wB gives, with only inner poles in the sum; and their share Σ wB / Σ wB is largest at t = ½ if it is
// bounded by the least weight of the ends and the largest of the others.
double BezierArc::chordError() const {
  const double least = std::min(poles[0].z(), poles[degree].z());
  const ProfilePoint first = start() - origin;
  const ProfilePoint chord = end() - origin - first;
  double furthest = 0.0, weight = 0.0;
  for (int i = 1; i < degree; ++i) {
    furthest = std::max(furthest, distanceToSegment(poles[i].head<2>() / poles[i].z() - first, chord));
    weight = std::max(weight, poles[i].z());
  }
  const double inner = (degree == 3 ? 3.0 : 1.0) * weight;
  return furthest * inner / (inner + least);
}

std::pair<BezierArc, BezierArc> BezierArc::halves() const {
  BezierArc left = *this, right = *this;
  for (int level = 1; level <= degree; ++level) {
    for (int i = 0; i <= degree - level; ++i) right.poles[i] = 0.5 * (right.poles[i] + right.poles[i + 1]);
    left.poles[level] = right.poles[0];
  }
  return {left, right};
}

}  // namespace handwheel
