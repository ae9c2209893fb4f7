// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>

namespace handwheel {

// A point (r, z) of the half plane in which a profile lies, mm.
using ProfilePoint = Eigen::Vector2d;

inline constexpr int kHighestDegree = 3;

// A rational Bézier curve of degree 1 to 3, one smooth piece of a profile. The parameter t is in 0…1. Poles are
// relative to the first one, so that a position far from the origin loses no precision.
struct BezierArc {
  int degree = 1;
  ProfilePoint origin{0, 0};
  // The first degree + 1 entries are (w r, w z, w) relative to the origin. All weights w are positive.
  std::array<Eigen::Vector3d, kHighestDegree + 1> poles;

  // Returns the point and its derivatives of order 1 to 3 with respect to t. Derivatives of an order above the degree
  // are zero only if all weights are equal.
  std::array<ProfilePoint, kHighestDegree + 1> derivatives(double t) const;

  // Returns the unit tangent at t in the direction of rising t. Where the derivative vanishes, for example at double
  // poles, the result is the limit of the tangent from above t (at t = 1, from below). It is zero if the arc is a
  // single point.
  ProfilePoint direction(double t) const;

  // Returns an upper bound of the Hausdorff distance between the arc and its chord. The bound is exact for polynomials
  // of degree 2.
  double chordError() const;

  std::pair<BezierArc, BezierArc> halves() const;

  ProfilePoint start() const { return origin + poles[0].head<2>() / poles[0].z(); }
  ProfilePoint end() const { return origin + poles[degree].head<2>() / poles[degree].z(); }
};

}  // namespace handwheel
