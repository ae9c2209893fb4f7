// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "globe/document/GlobeSurface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handwheel::test {

namespace {

std::vector<Vec3> latticeDirections() {
  std::vector<Vec3> all;
  for (std::size_t i = 0; i < kGlobePoints; ++i) {
    const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(kGlobePoints);
    const double turn = 2.0 * std::numbers::pi * static_cast<double>(i) / std::numbers::phi, r = std::sqrt(1.0 - z * z);
    all.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
  }
  return all;
}

}  // namespace

const std::vector<Vec3>& globeDirections() {
  static const std::vector<Vec3> all = latticeDirections();
  return all;
}

double globeWeight(double chord) {
  const double rest = 1.0 - chord * chord / (kGlobeReach * kGlobeReach);
  return rest > 0.0 ? rest * rest : 0.0;
}

GlobeSurface::GlobeSurface(double radius) : m_radius(radius) {
  for (std::size_t i = 0; i < kGlobePoints; ++i) m_dents.push_back(0.0);
}

GlobeSurface GlobeSurface::withRadius(double radius) const {
  GlobeSurface surface = *this;
  surface.m_radius = radius;
  return surface;
}

void GlobeSurface::setDent(std::size_t i, double dent) {
  m_dents.set(i, std::clamp(dent, 0.0, kDeepest));
}

bool GlobeSurface::isDented() const {
  for (std::size_t i = 0; i < kGlobePoints; ++i) {
    if (m_dents[i] > 0.0) return true;
  }
  return false;
}

double GlobeSurface::heightTowards(const Vec3& p) const {
  const Vec3 direction = p.stableNormalized();
  double sum = 0.0, weights = 0.0;
  for (std::size_t i = 0; i < kGlobePoints; ++i) {
    const double weight = globeWeight((globeDirections()[i] - direction).norm());
    sum += weight * m_dents[i];
    weights += weight;
  }
  return weights > 0.0 ? m_radius * (1.0 - sum / weights) : m_radius;
}

bool GlobeSurface::operator==(const GlobeSurface& other) const {
  if (m_radius != other.m_radius) return false;
  for (std::size_t i = 0; i < kGlobePoints; ++i) {
    if (m_dents[i] != other.m_dents[i]) return false;
  }
  return true;
}

}  // namespace handwheel::test
