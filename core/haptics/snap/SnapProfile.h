// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace handwheel {

// Shape of a snap force as a function of distance. x is the distance from the tip to the constraint, and ls the snap
// distance. The formulas give the force for 0 < x < ls; elsewhere it is 0. The equation numbers are those of He 2008.
enum class SnapShape : std::uint8_t {
  Spring,      // k x: jumps to 0 at ls, the "force leap"
  Triangular,  // k x up to ls/2, then k (ls - x)                                                       (eq. 3-1)
  Quadratic,   // 2 k x (ls - x) / ls                                                                   (eq. 3-2)
  Gaussian,    // k ls/2 (g(x) - g(0)) / (1 - g(0)), g(x) = exp(-((x - ls/2) / (ls/6))^2 / 2)           (eq. 3-3)
};

// Snap force profile: a shape with stiffness k and snap distance ls. The three smooth shapes have their maximum k ls/2
// at x = ls/2. SnapProfile is a value type, and may be used on any thread.
class SnapProfile {
 public:
  SnapProfile() = default;  // no force
  // stiffness: N/mm. distance: the snap distance, mm. There is no force unless both are positive and at most 1e100.
  SnapProfile(SnapShape shape, double stiffness, double distance);

  SnapShape shape() const { return m_shape; }
  double stiffness() const { return m_stiffness; }
  double distance() const { return m_distance; }
  // Returns the same profile with another snap distance.
  SnapProfile within(double distance) const { return {m_shape, m_stiffness, distance}; }

  // Returns the force towards the constraint, N. It is 0 unless 0 < x < ls, and for NaN.
  double force(double x) const;
  // Returns the largest |dF/dx| in 0 < x < ls, N/mm, for the stiffness limit. The discontinuity of the spring at ls is
  // not included.
  double largestSlope() const;
  double peak() const;  // N; the peak of the spring is just before its discontinuity
  double leap() const;  // N, height of the discontinuity at x = ls

 private:
  SnapShape m_shape = SnapShape::Triangular;
  double m_stiffness = 0.0;
  double m_distance = 0.0;
};

}  // namespace handwheel
