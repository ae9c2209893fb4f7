// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/PagedArray.h"

#include <vector>

namespace handwheel::test {

// The number of points on a globe.
inline constexpr std::size_t kGlobePoints = 2000;
// Returns directions at about equal distances from one another: a Fibonacci lattice on the unit sphere.
const std::vector<Vec3>& globeDirections();

// The weight of a direction at this chord (of the unit sphere) from another: from 1 to 0 at kGlobeReach, smooth.
inline constexpr double kGlobeReach = 0.25;
double globeWeight(double chord);

// Limits of the radius, mm.
inline constexpr double kLeastRadius = 1.0, kLargestRadius = 1000.0;
inline bool isRadius(double radius) {
  return radius >= kLeastRadius && radius <= kLargestRadius;
}

// The surface of a globe: points at varying distances from its centre. They are in fixed directions, each pushed in by
// a fraction of the radius. A value type; versions share unchanged data.
class GlobeSurface {
 public:
  static constexpr double kDeepest = 0.9;

  explicit GlobeSurface(double radius);

  double radius() const { return m_radius; }  // mm
  GlobeSurface withRadius(double radius) const;
  double dent(std::size_t i) const { return m_dents[i]; }  // 0 to kDeepest
  void setDent(std::size_t i, double dent);
  bool isDented() const;

  double height(std::size_t i) const { return m_radius * (1.0 - m_dents[i]); }  // mm, from the centre
  Vec3 point(std::size_t i) const { return height(i) * globeDirections()[i]; }
  // Returns the height of the surface towards p, which is the weighted mean of the points around; mm.
  double heightTowards(const Vec3& p) const;

  bool operator==(const GlobeSurface& other) const;

 private:
  double m_radius;
  PagedArray<double> m_dents;
};

}  // namespace handwheel::test
