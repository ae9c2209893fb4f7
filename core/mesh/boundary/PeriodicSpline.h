// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <span>
#include <vector>

namespace handwheel {

// A closed cubic spline, chord-length parametrised, that interpolates or smooths points. It is, of all closed curves,
// the one with the least Σ|pᵢ − s(tᵢ)|² + λ∫|s″|² (Reinsch, "Smoothing by spline functions", 1967; the cyclic form of
// Green and Silverman, "Nonparametric regression and generalized linear models", 1994, section 2.3). With λ = 0 it
// passes through the points, and the system for its second derivatives is the cyclic tridiagonal one.
class PeriodicSpline {
 public:
  // At least three points, finite and no two neighbours equal. The unit of λ is the mean chord cubed, so that it does
  // not depend on the scale. O(n).
  PeriodicSpline(std::span<const Vec3> points, double lambda);

  std::size_t size() const { return m_points.size(); }
  // Where the curve passes for point i.
  const Vec3& knot(std::size_t i) const { return m_points[i]; }
  // On the way from knot i (u = 0) to the next (u = 1).
  Vec3 at(std::size_t i, double u) const;

 private:
  std::vector<Vec3> m_points;
  std::vector<Vec3> m_bends;    // second derivatives
  std::vector<double> m_steps;  // of the parameter, to the next knot; 1 for a mean chord
};

// The λ that halves the height of waves of this length. The length is in points, evenly spaced; shorter waves keep
// less, down to nothing, longer ones nearly all. 0 for waves shorter than two points, of which there are none.
double lambdaForWavelength(double points);

}  // namespace handwheel
