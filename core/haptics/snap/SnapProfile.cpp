// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/snap/SnapProfile.h"

#include <cmath>

namespace handwheel {
namespace {

// g(0) of eq. 3-3 is exp(-kBorder).
constexpr double kBorder = 4.5;

bool isUsable(double v) {
  return v > 0.0 && v <= 1e100;  // products stay finite
}

}  // namespace

SnapProfile::SnapProfile(SnapShape shape, double stiffness, double distance) : m_shape(shape) {
  if (!isUsable(stiffness) || !isUsable(distance)) return;
  m_stiffness = stiffness;
  m_distance = distance;
}

double SnapProfile::force(double x) const {
  if (!(x > 0.0) || !(x < m_distance)) return 0.0;
  const double left = m_distance - x;  // exact where it is small (Sterbenz)
  switch (m_shape) {
    case SnapShape::Spring:
      return m_stiffness * x;
    case SnapShape::Triangular:
      return m_stiffness * std::fmin(x, left);
    case SnapShape::Quadratic:
      return 2.0 * m_stiffness * x * (left / m_distance);
    case SnapShape::Gaussian:
      // With g(x) / g(0) = exp(4 kBorder u (1 - u)) and u = x/ls nothing cancels at either border.
      return 0.5 * m_stiffness * m_distance *
             (std::expm1(4.0 * kBorder * (x / m_distance) * (left / m_distance)) / std::expm1(kBorder));
  }
  return 0.0;
}

double SnapProfile::largestSlope() const {
  switch (m_shape) {
    case SnapShape::Spring:
    case SnapShape::Triangular:
      return m_stiffness;
    case SnapShape::Quadratic:
      return 2.0 * m_stiffness;  // at the borders
    case SnapShape::Gaussian:
      return m_stiffness * 3.0 * std::exp(-0.5) / -std::expm1(-kBorder);  // a standard deviation beside the peak
  }
  return 0.0;
}

double SnapProfile::peak() const {
  return m_stiffness * m_distance * (m_shape == SnapShape::Spring ? 1.0 : 0.5);
}

double SnapProfile::leap() const {
  return m_shape == SnapShape::Spring ? m_stiffness * m_distance : 0.0;
}

}  // namespace handwheel
