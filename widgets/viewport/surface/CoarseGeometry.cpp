// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/SurfaceGeometry.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace handwheel {

namespace {

// The cells of the grid that hold vertices, numbered in the order of their discovery.
class Clusters {
 public:
  Clusters(const HalfEdgeMesh& mesh, const Box& bounds, double cell, const std::vector<double>* values)
      : m_mesh(mesh), m_values(values), m_corner(bounds.min()), m_cell(cell) {
    m_clusterOf.assign(mesh.vertexSlots(), kNone);
  }

  std::uint32_t of(Vertex v) {
    if (m_clusterOf[v] != kNone) return m_clusterOf[v];
    const Eigen::Array3d c = ((m_mesh.position(v) - m_corner) / m_cell).array().floor();
    // 21 bits a coordinate; the grids used here have a few hundred cells a side.
    const auto key = (static_cast<std::uint64_t>(c.x()) << 42) | (static_cast<std::uint64_t>(c.y()) << 21) |
                     static_cast<std::uint64_t>(c.z());
    const auto [it, isNew] = m_number.try_emplace(key, static_cast<std::uint32_t>(m_members.size()));
    if (isNew) m_members.push_back({Vec3::Zero(), Vec3::Zero(), 0.0, 0});
    Cluster& cluster = m_members[it->second];
    cluster.sum += m_mesh.position(v) - m_corner;
    if (m_values) cluster.value += (*m_values)[v];
    ++cluster.count;
    return m_clusterOf[v] = it->second;
  }

  void addNormal(std::uint32_t cluster, const Vec3& n) { m_members[cluster].normal += n; }

  Vec3 position(std::uint32_t cluster) const { return m_corner + m_members[cluster].sum / m_members[cluster].count; }

  // If clustering folds the surface over itself, a triangle shows its back to the outside; it covers nothing that its
  // neighbours do not.
  bool isFoldedOver(const std::array<std::uint32_t, 3>& t) const {
    const Vec3 n = (position(t[1]) - position(t[0])).cross(position(t[2]) - position(t[0]));
    return n.dot(m_members[t[0]].normal + m_members[t[1]].normal + m_members[t[2]].normal) <= 0;
  }

  void writeVertices(SurfaceGeometry& g, const Vec3& origin) const {
    for (std::uint32_t c = 0; c < m_members.size(); ++c) {
      const Vec3 p = position(c) - origin;
      const Vec3& sum = m_members[c].normal;
      const Vec3 n = sum.squaredNorm() > 0 ? sum.normalized() : Vec3(Vec3::UnitZ());
      for (int k = 0; k < 3; ++k) {
        g.positions.push_back(static_cast<float>(p[k]));
        g.normals.push_back(static_cast<float>(n[k]));
      }
      if (m_values) g.values.push_back(static_cast<float>(m_members[c].value / m_members[c].count));
    }
  }

 private:
  struct Cluster {
    Vec3 sum;
    Vec3 normal;
    double value;  // their sum
    int count;
  };

  const HalfEdgeMesh& m_mesh;
  const std::vector<double>* const m_values;
  const Vec3 m_corner;
  const double m_cell;
  std::vector<std::uint32_t> m_clusterOf;
  std::unordered_map<std::uint64_t, std::uint32_t> m_number;
  std::vector<Cluster> m_members;
};

}  // namespace

SurfaceGeometry coarseGeometry(const HalfEdgeMesh& mesh, const Box& bounds, const Vec3& origin, std::size_t triangles,
                               const std::vector<double>* values) {
  SurfaceGeometry g;
  if (bounds.isEmpty() || triangles == 0) return g;
  // A surface cuts about two triangles out of each cell it crosses; half the area of the box stands for its area.
  const Vec3 s = bounds.sizes();
  const double area = s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
  const double cell = std::max(std::sqrt(2 * area / static_cast<double>(triangles)), 1e-6 * s.norm());
  if (!(cell > 0)) return g;
  Clusters clusters(mesh, bounds, cell, values);
  std::vector<std::array<std::uint32_t, 3>> kept;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    const auto [a, b, c] = mesh.triangle(f);
    const std::array<std::uint32_t, 3> t{clusters.of(a), clusters.of(b), clusters.of(c)};
    const Vec3 n = (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a));
    for (const std::uint32_t k : t) clusters.addNormal(k, n);
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    kept.push_back(t);
  }
  for (const auto& t : kept) {
    if (clusters.isFoldedOver(t)) continue;
    for (const std::uint32_t k : t) g.indices.push_back(static_cast<std::int32_t>(k));
  }
  clusters.writeVertices(g, origin);
  return g;
}

}  // namespace handwheel
