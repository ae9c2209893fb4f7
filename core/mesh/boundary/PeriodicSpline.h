// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <span>
#include <vector>

namespace handwheel {

// A closed cubic spline, chord-length parametrised, that interpolates or smooths points. Among all closed curves it
// minimises Σ|pᵢ − s(tᵢ)|² + λ∫|s″|² (Reinsch, "Smoothing by spline functions", 1967; the cyclic form of Green and
// Silverman, "Nonparametric regression and generalized linear models", 1994, section 2.3). With λ = 0 it passes through
// the points, and the system for its second derivatives is the cyclic tridiagonal one.
class PeriodicSpline {
 public:
  // There must be at least three finite points, and neighbours must differ. The unit of λ is the mean chord cubed, so
  // that it does not depend on the scale. O(n).
  PeriodicSpline(std::span<const Vec3> points, double lambda);

  std::size_t size() const { return m_points.size(); }
  // Returns the point of the curve for point i.
  const Vec3& knot(std::size_t i) const { return m_points[i]; }
  // Returns the point at parameter u between knot i (u = 0) and the next (u = 1).
  Vec3 at(std::size_t i, double u) const;

 private:
  std::vector<Vec3> m_points;
  std::vector<Vec3> m_bends;    // second derivatives
  std::vector<double> m_steps;  // parameter intervals to the next knot; 1 for a mean chord
};

// Returns the λ that halves the height of waves of this length. The length is a number of evenly spaced points. Shorter
// waves keep less of their height, longer ones nearly all. Returns 0 for less than two points, since no shorter waves
// exist.
double lambdaForWavelength(double points);

}  // namespace handwheel
