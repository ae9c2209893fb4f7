// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "nurbs/ProfileCurve.h"

namespace handwheel {

// A point of a surface of revolution, with its derivatives and normal.
struct RevolutionPoint {
  Vec3 position;   // mm
  Vec3 byCircle;   // ∂S/∂u; zero on the axis
  Vec3 byProfile;  // ∂S/∂v
  Vec3 normal;     // unit vector away from the material; zero only where the profile is a single point
};

// A surface of revolution as a rational B-spline (NURBS). Along the circle, it has degree 2 and nine columns; along the
// profile, it has the degree of the profile. In poles[i][j] and weights[i][j], i counts along the circle and j along
// the profile.
struct SurfaceNurbs {
  int profileDegree = 1;
  std::vector<double> circleKnots, profileKnots;
  std::array<std::vector<Vec3>, 9> poles;
  std::array<std::vector<double>, 9> weights;
};

// The exact surface that a profile sweeps around the axis z. S(u, v) = (r(v) cos θ(u), r(v) sin θ(u), z(v)).
class SurfaceOfRevolution {
 public:
  explicit SurfaceOfRevolution(ProfileCurve profile) : m_profile(std::move(profile)) {}

  const ProfileCurve& profile() const { return m_profile; }

  // Returns a point of the surface. u: the parameter 0…1 round the axis, from +x through +y; v: the parameter of the
  // profile. O(log poles).
  RevolutionPoint at(double u, double v) const;

  SurfaceNurbs nurbs() const;

 private:
  ProfileCurve m_profile;
};

}  // namespace handwheel
