// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/PagedArray.h"

#include <vector>

namespace handwheel::test {

// The number of points on a globe.
inline constexpr std::size_t kGlobePoints = 2000;
// Returns unit vectors at nearly equal distances from one another (a Fibonacci lattice on the sphere).
const std::vector<Vec3>& globeDirections();

// The distance on the unit sphere, as a chord, at which globeWeight() becomes 0.
inline constexpr double kGlobeReach = 0.25;
// Returns the weight of a point whose direction is this chord of the unit sphere away. It falls smoothly from 1 to 0.
double globeWeight(double chord);

// Limits of the radius, mm.
inline constexpr double kLeastRadius = 1.0, kLargestRadius = 1000.0;
inline bool isRadius(double radius) {
  return radius >= kLeastRadius && radius <= kLargestRadius;
}

// The surface of a globe: points in fixed directions from its centre. Each point is pushed in by a fraction of the
// radius. It is a value type; copies share unchanged data.
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
  // Returns the height of the surface in the direction of p, mm: the weighted mean of the nearby points.
  double heightTowards(const Vec3& p) const;

  bool operator==(const GlobeSurface& other) const;

 private:
  double m_radius;
  PagedArray<double> m_dents;
};

}  // namespace handwheel::test
