// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/LoopSubdivision.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handwheel {
namespace {

// Returns the axes x, y and normal from a tangent and a normal that need not have unit length or be perpendicular.
Eigen::Matrix3d frameOf(const Vec3& tangent, const Vec3& normal) {
  const Vec3 n = normal.stableNormalized();
  Vec3 t = tangent - n * n.dot(tangent);
  if (!(n.squaredNorm() > 0.0) || !(t.squaredNorm() > 0.0)) return Eigen::Matrix3d::Identity();
  t.stableNormalize();
  Eigen::Matrix3d frame;
  frame << t, n.cross(t), n;
  return frame;
}

// Returns the power of two that scales numbers of this size to about 1.
double scaleOf(const Vec3& v) {
  int exponent = 0;
  std::frexp(v.cwiseAbs().maxCoeff(), &exponent);
  return std::ldexp(1.0, -std::max(exponent, -1000));
}

// Equation 4-2; Loop, "Smooth subdivision surfaces based on triangles", 1987.
double loopShare(double valence) {
  const double c = 0.375 + 0.25 * std::cos(2.0 * std::numbers::pi / valence);
  return (0.625 - c * c) / valence;
}

}  // namespace

void LoopStencils::add(Kind kind, HalfEdge leaving, std::span<const Vertex> sources) {
  m_stencils.push_back(
      {leaving, static_cast<std::uint32_t>(m_sources.size()), static_cast<std::uint32_t>(sources.size()), kind});
  m_sources.insert(m_sources.end(), sources.begin(), sources.end());
}

std::span<const Vertex> LoopStencils::sources(std::size_t i) const {
  return std::span(m_sources).subspan(m_stencils[i].first, m_stencils[i].count);
}

// Sums of differences keep the precision far from the origin.
Vec3 LoopStencils::position(const HalfEdgeMesh& coarse, std::size_t i) const {
  const std::span<const Vertex> s = sources(i);
  const Vec3& p = coarse.position(s[0]);
  const auto off = [&](std::size_t k) { return Vec3(coarse.position(s[k]) - p); };
  if (m_stencils[i].kind == Kind::Fixed) return p;
  if (m_stencils[i].kind == Kind::Edge) return p + 0.375 * off(1) + 0.125 * (off(2) + off(3));
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 1; k < s.size(); ++k) sum += off(k);
  return p + loopShare(static_cast<double>(s.size() - 1)) * sum;
}

Eigen::Matrix3d LoopStencils::frame(const HalfEdgeMesh& coarse, std::size_t i) const {
  const std::span<const Vertex> s = sources(i);
  if (m_stencils[i].kind == Kind::Fixed) return Eigen::Matrix3d::Identity();
  // Only directions matter, and the products of lengths must neither overflow nor vanish.
  const double scale = scaleOf(coarse.position(s[1]) - coarse.position(s[0]));
  const auto off = [&](std::size_t k) { return Vec3(scale * (coarse.position(s[k]) - coarse.position(s[0]))); };
  if (m_stencils[i].kind == Kind::Edge) return frameOf(off(1), off(1).cross(off(2)) + off(3).cross(off(1)));
  Vec3 normal = Vec3::Zero();
  for (std::size_t k = 1; k < s.size(); ++k) normal += off(k).cross(off(k + 1 < s.size() ? k + 1 : 1));
  return frameOf(off(1), normal);
}

}  // namespace handwheel
