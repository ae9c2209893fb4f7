// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>

namespace handwheel {

// A point of the half plane in which a profile lies: (r, z), mm.
using ProfilePoint = Eigen::Vector2d;

inline constexpr int kHighestDegree = 3;

// A rational Bézier curve of degree 1 to 3, one smooth piece of a profile. The parameter t is in 0…1. Poles are
// relative to the first one, so that a position far from the origin loses no precision.
struct BezierArc {
  int degree = 1;
  ProfilePoint origin{0, 0};
  // (w r, w z, w) relative to the origin; the first degree + 1 of them; all weights are positive.
  std::array<Eigen::Vector3d, kHighestDegree + 1> poles;

  // Returns the point and the derivatives by t of order 1 to 3; those beyond the degree are zero only if no weight
  // varies.
  std::array<ProfilePoint, kHighestDegree + 1> derivatives(double t) const;

  // Returns the unit tangent at t, towards the rest of the arc (at t = 1, from the arc before). If the derivative
  // vanishes, as it does at double poles, it is the limit; zero if the arc is one point.
  ProfilePoint direction(double t) const;

  // Returns the Hausdorff distance of the arc from its chord. Exact for polynomials of degree 2; else an upper bound.
  double chordError() const;

  std::pair<BezierArc, BezierArc> halves() const;

  ProfilePoint start() const { return origin + poles[0].head<2>() / poles[0].z(); }
  ProfilePoint end() const { return origin + poles[degree].head<2>() / poles[degree].z(); }
};

}  // namespace handwheel
