// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nurbs/SurfaceOfRevolution.h"

#include "nurbs/UnitCircle.h"

namespace handwheel {

RevolutionPoint SurfaceOfRevolution::at(double u, double v) const {
  const unit_circle::Point circle = unit_circle::at(u);
  const double cosine = circle.direction.x(), sine = circle.direction.y();
  const ProfilePoint p = m_profile.point(v), along = m_profile.derivative(v), direction = m_profile.direction(v);
  RevolutionPoint result;
  result.position = {p.x() * cosine, p.x() * sine, p.y()};
  result.byCircle = p.x() * circle.speed * Vec3(-sine, cosine, 0.0);
  result.byProfile = {along.x() * cosine, along.x() * sine, along.y()};
  // The normal follows from the profile alone, since the cross product of the two derivatives is zero on the axis.
  result.normal = {direction.y() * cosine, direction.y() * sine, -direction.x()};
  return result;
}

SurfaceNurbs SurfaceOfRevolution::nurbs() const {
  const ProfileNurbs& profile = m_profile.nurbs();
  const auto circle = unit_circle::poles();
  const auto circleWeights = unit_circle::weights();
  SurfaceNurbs nurbs;
  nurbs.profileDegree = profile.degree;
  nurbs.circleKnots = unit_circle::knots();
  nurbs.profileKnots = profile.knots;
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t j = 0; j < profile.poles.size(); ++j) {
      const ProfilePoint& p = profile.poles[j];
      nurbs.poles[i].emplace_back(p.x() * circle[i].x(), p.x() * circle[i].y(), p.y());
      nurbs.weights[i].push_back(circleWeights[i] * profile.weights[j]);
    }
  }
  return nurbs;
}

}  // namespace handwheel
