// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"
#include "proximity/ClosestPoint.h"

#include <limits>

namespace handwheel::test {

// A reference god-object without friction on a triangle mesh, for comparison. The triangles must share points. The
// proxy always stays on the surface, so tips outside are not supported. In each step it moves straight to the
// position nearest to the tip on one of the triangles that it touches. It stops when no step brings it nearer. It uses
// no hierarchy of triangles.
class ExactGodObject {
 public:
  explicit ExactGodObject(const TriangleSoup& mesh) : m_mesh(mesh), m_first(mesh.points.size() + 1, 0) {
    for (const Triangle& t : mesh.triangles)
      for (const std::uint32_t v : t) ++m_first[v + 1];
    for (std::size_t v = 0; v < mesh.points.size(); ++v) m_first[v + 1] += m_first[v];
    m_around.resize(3 * mesh.triangles.size());
    std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      for (const std::uint32_t v : mesh.triangles[t]) m_around[next[v]++] = t;
  }

  // Sets the proxy to the position on the mesh nearest to the tip.
  void place(const Vec3& tip) {
    m_best = std::numeric_limits<double>::infinity();
    for (std::uint32_t t = 0; t < m_mesh.triangles.size(); ++t) look(t, tip);
  }

  // Sets the proxy to a position on a triangle.
  void stand(std::uint32_t triangle, const Vec3& position) {
    m_triangle = triangle;
    m_proxy = position;
  }

  const Vec3& follow(const Vec3& tip) {
    m_best = (m_proxy - tip).squaredNorm();
    double before = std::numeric_limits<double>::infinity();
    while (m_best < before) {
      before = m_best;
      goOn(tip);
    }
    return m_proxy;
  }

  const Vec3& proxy() const { return m_proxy; }

 private:
  static constexpr double kOn = 1e-9;  // mm, largest distance of a triangle that the proxy touches

  void goOn(const Vec3& tip) {
    const Vec3 from = m_proxy;
    const std::uint32_t at = m_triangle;
    for (const std::uint32_t v : m_mesh.triangles[at])
      for (std::uint32_t i = m_first[v]; i < m_first[v + 1]; ++i)
        if ((closestOn(m_around[i], from) - from).norm() < kOn) look(m_around[i], tip);
  }

  Vec3 closestOn(std::uint32_t t, const Vec3& p) const {
    const Triangle& c = m_mesh.triangles[t];
    return closestOnTriangle(p, m_mesh.points[c[0]], m_mesh.points[c[1]], m_mesh.points[c[2]]);
  }

  void look(std::uint32_t t, const Vec3& tip) {
    const Vec3 p = closestOn(t, tip);
    const double distance = (p - tip).squaredNorm();
    if (!(distance < m_best)) return;
    m_best = distance;
    m_proxy = p;
    m_triangle = t;
  }

  const TriangleSoup& m_mesh;
  std::vector<std::uint32_t> m_first, m_around;  // the triangles around each point
  std::uint32_t m_triangle = 0;
  Vec3 m_proxy = Vec3::Zero();
  double m_best = 0.0;  // mm², squared distance from the proxy to the tip
};

}  // namespace handwheel::test
