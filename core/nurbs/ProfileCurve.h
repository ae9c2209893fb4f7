// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "nurbs/BezierArc.h"

#include <span>
#include <vector>

namespace handwheel {

// The definition of a rational B-spline curve by poles, weights and knots. There are n poles of the (r, z) half plane
// with their weights, and n + degree + 1 knots in rising order. The first and the last knot have multiplicity degree +
// 1, so the curve begins and ends in a pole; an inner knot has at most multiplicity degree, and the curve then has a
// corner in a pole.
struct ProfileNurbs {
  int degree = 1;
  std::vector<double> knots;
  std::vector<ProfilePoint> poles;  // mm
  std::vector<double> weights;
};

// The profile of a turned part, a curve in the half plane r ≥ 0. The half plane is bounded by the axis z. The curve
// runs from the lower end of the part to the upper end. Seen with r to the right and z up, it has the material on its
// left, on the side of the axis. A bore that is open at an end belongs to the curve, which then begins or ends at its
// bottom; if the part is bored through, the curve is closed.
class ProfileCurve {
 public:
  static constexpr std::size_t kMostPoles = 100'000;
  static constexpr double kLargestCoordinate = 1e9;  // mm
  static constexpr double kLargestWeight = 1e6;      // the least weight is its reciprocal

  // Checks a definition and makes its curve. O(poles). Errors: FileTooLarge {poles, count, limit}, ElementMalformed
  // {"profile", what is wrong}.
  static Result<ProfileCurve> make(ProfileNurbs nurbs);
  // Returns the curve of straight lines through at least two points. The parameter rises by 1 along each line.
  static Result<ProfileCurve> polyline(std::vector<ProfilePoint> points);

  const ProfileNurbs& nurbs() const { return m_nurbs; }
  double from() const { return m_nurbs.knots.front(); }
  double to() const { return m_nurbs.knots.back(); }

  bool isClosed() const { return m_nurbs.poles.front() == m_nurbs.poles.back() && m_nurbs.poles.front().x() > 0.0; }

  // Returns the volume (mm³) between the curve, the flat ends through its first and last point, and the axis, or within
  // a closed curve. It is computed by adaptive quadrature. The quadrature is exact for arcs whose weights are equal;
  // for other arcs, the error is at most tolerance::kQuadrature times the volume of the cylinder around the arc.
  // O(poles).
  double volume() const;

  // Returns the smooth pieces in order, one for each pair of different consecutive knots.
  std::span<const BezierArc> arcs() const { return m_arcs; }

  // Return the point and the derivative at u, which is clamped to the range of the parameter. At a knot, they are those
  // of the piece that begins there. O(log poles).
  ProfilePoint point(double u) const;
  ProfilePoint derivative(double u) const;
  ProfilePoint direction(double u) const;  // BezierArc::direction

 private:
  struct Location {
    const BezierArc& arc;
    double t;
    double length;  // length of the arc in the parameter of the curve
  };
  ProfileCurve() = default;
  Location locate(double u) const;

  ProfileNurbs m_nurbs;
  std::vector<BezierArc> m_arcs;
  std::vector<double> m_breaks;  // distinct knots; one more than arcs
};

}  // namespace handwheel
