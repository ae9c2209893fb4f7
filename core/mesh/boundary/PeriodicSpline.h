// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <span>
#include <vector>

namespace handwheel {

// A closed cubic spline with chord-length parameters that interpolates or smooths points. Among all closed curves it
// minimises Σ|pᵢ − s(tᵢ)|² + λ∫|s″|² (Reinsch, "Smoothing by spline functions", 1967; the cyclic form of Green and
// Silverman, "Nonparametric regression and generalized linear models", 1994, section 2.3). With λ = 0 it passes through
// the points, and the system for its second derivatives is cyclic tridiagonal.
class PeriodicSpline {
 public:
  // Computes the spline. There must be at least three finite points, and neighbours must differ. The unit of λ is the
  // cube of the mean chord, so that the result does not depend on the scale of the points. O(n).
  PeriodicSpline(std::span<const Vec3> points, double lambda);

  std::size_t size() const { return m_points.size(); }
  // Returns the point of the curve that belongs to input point i.
  const Vec3& knot(std::size_t i) const { return m_points[i]; }
  // Returns the point at parameter u between knot i (u = 0) and the next knot (u = 1).
  Vec3 at(std::size_t i, double u) const;

 private:
  std::vector<Vec3> m_points;
  std::vector<Vec3> m_bends;    // second derivatives
  std::vector<double> m_steps;  // parameter interval from each knot to the next; 1 for a chord of mean length
};

// Returns the λ that halves the height of waves of this length. points: the wavelength as a number of evenly spaced
// points. Shorter waves keep less than half of their height, longer ones nearly all of it. Returns 0 for a wavelength
// below two points, since no shorter waves exist.
double lambdaForWavelength(double points);

}  // namespace handwheel
