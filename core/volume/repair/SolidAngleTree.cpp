// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/SolidAngleTree.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr std::uint32_t kLeaf = 8;
constexpr double kFarGroup = 3.0;  // radii of a group beyond which its expansion is used
constexpr int kMostDepth = 64;

Vec3 middleOf(const std::array<Vec3, 3>& t) {
  return (t[0] + t[1] + t[2]) / 3.0;
}

// van Oosterom and Strackee 1983; half of the solid angle.
double halfAngle(const std::array<Vec3, 3>& t, const Vec3& p) {
  const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

}  // namespace

SolidAngleTree::SolidAngleTree(const TriangleSoup& soup, std::span<const std::uint32_t> triangles) {
  m_triangles.reserve(triangles.size());
  for (const std::uint32_t i : triangles) {
    const Triangle& t = soup.triangles[i];
    m_triangles.push_back({soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]});
  }
  if (!m_triangles.empty()) build(0, static_cast<std::uint32_t>(m_triangles.size()));
}

void SolidAngleTree::build(std::uint32_t first, std::uint32_t end) {
  Node node;
  node.first = first;
  node.end = end;
  Box middles;
  for (std::uint32_t i = first; i < end; ++i) middles.extend(middleOf(m_triangles[i]));
  node.centre = middles.center();
  node.area.setZero();
  node.moment.setZero();
  for (std::uint32_t i = first; i < end; ++i) {
    const Corners& t = m_triangles[i];
    const Vec3 area = 0.5 * (t[1] - t[0]).cross(t[2] - t[0]);
    node.area += area;
    node.moment += (middleOf(t) - node.centre) * area.transpose();
    for (const Vec3& p : t) node.radius = std::max(node.radius, (p - node.centre).norm());
  }
  const std::size_t own = m_nodes.size();
  m_nodes.push_back(node);
  if (end - first <= kLeaf) return;
  Eigen::Index axis = 0;
  middles.sizes().maxCoeff(&axis);
  const std::uint32_t half = first + (end - first) / 2;
  std::nth_element(m_triangles.begin() + first, m_triangles.begin() + half, m_triangles.begin() + end,
                   [&](const Corners& a, const Corners& b) { return middleOf(a)[axis] < middleOf(b)[axis]; });
  build(first, half);
  m_nodes[own].right = static_cast<std::uint32_t>(m_nodes.size());
  build(half, end);
}

double SolidAngleTree::turns(const Vec3& p) const {
  if (m_nodes.empty()) return 0.0;
  std::array<std::uint32_t, kMostDepth> waiting;
  std::size_t count = 0;
  waiting[count++] = 0;
  double half = 0.0;
  while (count > 0) {
    const std::uint32_t at = waiting[--count];
    const Node& node = m_nodes[at];
    const Vec3 r = node.centre - p;
    const double squared = r.squaredNorm();
    if (squared > kFarGroup * kFarGroup * node.radius * node.radius) {
      const double cubed = squared * std::sqrt(squared);
      const double second = node.moment.trace() - 3.0 * r.dot(node.moment * r) / squared;
      half += 0.5 * (node.area.dot(r) + second) / cubed;
    } else if (node.right == 0) {
      for (std::uint32_t i = node.first; i < node.end; ++i) half += halfAngle(m_triangles[i], p);
    } else {
      waiting[count++] = at + 1;
      waiting[count++] = node.right;
    }
  }
  return half / (2.0 * M_PI);
}

}  // namespace handwheel
