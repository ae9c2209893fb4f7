// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nurbs/ProfileCurve.h"

#include "base/Tolerance.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace handwheel {

namespace {

bool arePolesSound(const ProfileNurbs& nurbs) {
  constexpr double most = ProfileCurve::kLargestCoordinate;
  return std::all_of(nurbs.poles.begin(), nurbs.poles.end(), [](const ProfilePoint& p) {
    return p.x() >= 0.0 && p.x() <= most && std::abs(p.y()) <= most;  // false for NaN
  });
}

bool areWeightsSound(const ProfileNurbs& nurbs) {
  constexpr double most = ProfileCurve::kLargestWeight;
  return nurbs.weights.size() == nurbs.poles.size() &&
         std::all_of(nurbs.weights.begin(), nurbs.weights.end(), [](double w) { return w >= 1.0 / most && w <= most; });
}

bool areKnotsSound(const ProfileNurbs& nurbs) {
  const auto& knots = nurbs.knots;
  const std::size_t degree = static_cast<std::size_t>(nurbs.degree), count = nurbs.poles.size();
  constexpr double most = ProfileCurve::kLargestCoordinate;
  if (knots.size() != count + degree + 1) return false;
  if (!(std::abs(knots.front()) <= most && std::abs(knots.back()) <= most)) return false;
  const double span = tolerance::kKnotSpan * (knots.back() - knots.front());
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double gap = knots[i] - knots[i - 1];
    if (!(gap == 0.0 || (span > 0.0 && gap >= span))) return false;
  }
  if (knots[degree] != knots.front() || knots[count] != knots.back()) return false;
  for (std::size_t i = 1; i < count; ++i) {
    if (knots[i] == knots[i + degree]) return false;
  }
  return true;
}

// The pole of the Bézier arc over [a, b] that takes "ends" of its arguments at b: the value of the span's symmetric
// multi-affine form (its blossom; Ramshaw 1987). t[m] is knot k + m of the span's own knot k.
Eigen::Vector3d blossom(std::array<Eigen::Vector3d, kHighestDegree + 1> poles, int degree, const double* t, int ends) {
  for (int level = 1; level <= degree; ++level) {
    const double u = level <= ends ? t[1] : t[0];
    for (int i = degree; i >= level; --i) {
      const double low = t[i - degree], high = t[i + 1 - level];
      const double share = (u - low) / (high - low);
      poles[i] = (1.0 - share) * poles[i - 1] + share * poles[i];
    }
  }
  return poles[degree];
}

BezierArc arcOf(const ProfileNurbs& nurbs, std::size_t k) {
  BezierArc arc;
  arc.degree = nurbs.degree;
  const std::size_t first = k - static_cast<std::size_t>(nurbs.degree);
  arc.origin = nurbs.poles[first];
  std::array<Eigen::Vector3d, kHighestDegree + 1> local;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(nurbs.degree); ++i) {
    const ProfilePoint p = nurbs.poles[first + i] - arc.origin;
    local[i] = nurbs.weights[first + i] * Eigen::Vector3d(p.x(), p.y(), 1.0);
  }
  for (int i = 0; i <= nurbs.degree; ++i) arc.poles[i] = blossom(local, nurbs.degree, &nurbs.knots[k], i);
  return arc;
}

// ∫ r² dz over the arc by Gauss and Legendre's rule of eight points: Abramowitz and Stegun, table 25.4. Exact if all
// weights are equal.
double gauss(const BezierArc& arc) {
  constexpr std::array<std::pair<double, double>, 4> kRule = {{{0.1834346424956498, 0.3626837833783620},
                                                               {0.5255324099163290, 0.3137066458778873},
                                                               {0.7966664774136267, 0.2223810344533745},
                                                               {0.9602898564975363, 0.1012285362903763}}};
  double sum = 0.0;
  for (const auto& [abscissa, weight] : kRule) {
    for (const double side : {-1.0, 1.0}) {
      const auto at = arc.derivatives(0.5 * (1.0 + side * abscissa));
      sum += 0.5 * weight * at[0].x() * at[0].x() * at[1].y();
    }
  }
  return sum;
}

// Halving an arc this often makes all of its weights alike, for any weights up to ProfileCurve::kLargestWeight.
constexpr int kDeepestSweep = 50;

// Returns ∫ r² dz to an error of "error", mm³; "whole" is the result of gauss(). Halves the arc while its weights
// differ much, because all of the curve may then lie between two points of the rule, and while the halves give another
// result.
double sweep(const BezierArc& arc, double whole, double error, int depth) {
  double least = arc.poles[0].z(), largest = least;
  for (int i = 1; i <= arc.degree; ++i) {
    least = std::min(least, arc.poles[i].z());
    largest = std::max(largest, arc.poles[i].z());
  }
  if (least == largest || depth == 0) return whole;
  const auto [left, right] = arc.halves();
  const double first = gauss(left), second = gauss(right);
  if (largest <= 2.0 * least && std::abs(first + second - whole) <= error) return first + second;
  return sweep(left, first, error, depth - 1) + sweep(right, second, error, depth - 1);
}

}  // namespace

Result<ProfileCurve> ProfileCurve::make(ProfileNurbs nurbs) {
  const auto malformed = [](const char* what) { return Error{ErrorCode::ElementMalformed, {"profile", what}, {}, {}}; };
  if (nurbs.degree < 1 || nurbs.degree > kHighestDegree) return malformed("its degree must be 1, 2 or 3");
  if (nurbs.poles.size() > kMostPoles) {
    return Error{
        ErrorCode::FileTooLarge, {"poles", std::to_string(nurbs.poles.size()), std::to_string(kMostPoles)}, {}, {}};
  }
  if (nurbs.poles.size() < static_cast<std::size_t>(nurbs.degree) + 1) return malformed("it has too few poles");
  if (!arePolesSound(nurbs)) return malformed("a pole is across the axis, too far away or not finite");
  if (!areWeightsSound(nurbs)) return malformed("a weight is missing, not positive or too large");
  if (!areKnotsSound(nurbs)) return malformed("its knots do not fit its poles");

  ProfileCurve curve;
  for (std::size_t k = static_cast<std::size_t>(nurbs.degree); k < nurbs.poles.size(); ++k) {
    if (nurbs.knots[k] == nurbs.knots[k + 1]) continue;
    curve.m_arcs.push_back(arcOf(nurbs, k));
    curve.m_breaks.push_back(nurbs.knots[k]);
  }
  curve.m_breaks.push_back(nurbs.knots.back());
  curve.m_nurbs = std::move(nurbs);
  return curve;
}

Result<ProfileCurve> ProfileCurve::polyline(std::vector<ProfilePoint> points) {
  ProfileNurbs nurbs;
  nurbs.weights.assign(points.size(), 1.0);
  nurbs.knots.push_back(0.0);
  for (std::size_t i = 0; i < points.size(); ++i) nurbs.knots.push_back(static_cast<double>(i));
  nurbs.knots.push_back(nurbs.knots.back());
  nurbs.poles = std::move(points);
  return make(std::move(nurbs));
}

double ProfileCurve::volume() const {
  double sum = 0.0;
  for (const BezierArc& arc : m_arcs) {
    double radius = 0.0, low = arc.origin.y(), high = low;
    for (int i = 0; i <= arc.degree; ++i) {
      const ProfilePoint pole = arc.origin + arc.poles[i].head<2>() / arc.poles[i].z();
      radius = std::max(radius, pole.x());
      low = std::min(low, pole.y());
      high = std::max(high, pole.y());
    }
    sum += sweep(arc, gauss(arc), tolerance::kQuadrature * radius * radius * (high - low), kDeepestSweep);
  }
  return M_PI * sum;
}

ProfileCurve::Location ProfileCurve::locate(double u) const {
  const auto inner = std::upper_bound(m_breaks.begin() + 1, m_breaks.end() - 1, u);
  const auto i = static_cast<std::size_t>(inner - m_breaks.begin()) - 1;
  const double length = m_breaks[i + 1] - m_breaks[i];
  return {m_arcs[i], std::clamp((u - m_breaks[i]) / length, 0.0, 1.0), length};
}

ProfilePoint ProfileCurve::point(double u) const {
  const Location at = locate(u);
  return at.arc.derivatives(at.t)[0];
}

ProfilePoint ProfileCurve::derivative(double u) const {
  const Location at = locate(u);
  return at.arc.derivatives(at.t)[1] / at.length;
}

ProfilePoint ProfileCurve::direction(double u) const {
  const Location at = locate(u);
  return at.arc.direction(at.t);
}

}  // namespace handwheel
