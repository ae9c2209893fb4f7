// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/SurfaceGeometry.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kCreaseCosine = 0.7660444431189780;  // cos 40°

struct Corner {
  HalfEdge edge = 0;  // the half-edge of the face that leaves the vertex
  Vec3 normal;        // normal of the face, unit length; zero for a face without area
  double angle = 0;
};

Corner cornerAt(const HalfEdgeMesh& mesh, HalfEdge h) {
  const Vec3& p = mesh.position(mesh.from(h));
  const Vec3 a = mesh.position(mesh.to(h)) - p;
  const Vec3 b = mesh.position(mesh.from(HalfEdgeMesh::previous(h))) - p;
  const Vec3 n = a.cross(b);
  const double length = n.norm();
  if (!(length > 0)) return {h, Vec3::Zero(), 0.0};
  return {h, n / length, std::atan2(length, a.dot(b))};
}

bool isCrease(const Corner& a, const Corner& b) {
  const bool bothHaveArea = a.angle > 0 && b.angle > 0;
  return bothHaveArea && a.normal.dot(b.normal) < kCreaseCosine;
}

void append(std::vector<float>& to, const Vec3& v) {
  for (int k = 0; k < 3; ++k) to.push_back(static_cast<float>(v[k]));
}

class BlockBuilder {
 public:
  BlockBuilder(const HalfEdgeMesh& mesh, std::size_t block, const Vec3& origin, Face blockFaces,
               const std::vector<double>* values)
      : m_mesh(mesh), m_origin(origin), m_values(values) {
    m_first = static_cast<Face>(std::min(mesh.faceSlots(), block * blockFaces));
    m_end = static_cast<Face>(std::min(mesh.faceSlots(), std::size_t{m_first} + blockFaces));
    m_vertexOf.assign(3 * std::size_t{m_end - m_first}, -1);
  }

  SurfaceGeometry build() {
    for (Face f = m_first; f < m_end; ++f) {
      if (!m_mesh.isLive(f) || !m_mesh.isProper(f)) continue;
      for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
        if (m_vertexOf[h - 3 * m_first] < 0) addVertex(h);
        m_result.indices.push_back(m_vertexOf[h - 3 * m_first]);
      }
    }
    return std::move(m_result);
  }

 private:
  // Splits the fan around the start of h at its creases into smooth runs and gives each run one drawn vertex.
  void addVertex(HalfEdge h) {
    std::vector<Corner>& corners = m_corners;
    corners.clear();
    m_mesh.visitFan(h, [&](HalfEdge g) { corners.push_back(cornerAt(m_mesh, g)); });
    const std::size_t n = corners.size();
    if (m_mesh.hasOpposite(corners.front().edge)) {  // faces all around: begin at a crease, if there is one
      std::size_t begin = 0;
      while (begin < n && !isCrease(corners[(begin + n - 1) % n], corners[begin])) ++begin;
      std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(begin % n), corners.end());
    }
    for (std::size_t from = 0; from < n;) {
      std::size_t to = from + 1;
      while (to < n && !isCrease(corners[to - 1], corners[to])) ++to;
      addRun(from, to);
      from = to;
    }
  }

  void addRun(std::size_t from, std::size_t to) {
    Vec3 normal = Vec3::Zero();
    bool isInBlock = false;
    const auto vertex = static_cast<std::int32_t>(m_result.vertexCount());
    for (std::size_t i = from; i < to; ++i) {
      const Corner& c = m_corners[i];
      normal += c.angle * c.normal;
      if (c.edge < 3 * m_first || c.edge >= 3 * m_end) continue;
      m_vertexOf[c.edge - 3 * m_first] = vertex;
      isInBlock = true;
    }
    if (!isInBlock) return;
    const Vertex v = m_mesh.from(m_corners[from].edge);
    append(m_result.positions, m_mesh.position(v) - m_origin);
    if (m_values) {  // a version that is only shown may have vertices that have none
      m_result.values.push_back(v < m_values->size() ? static_cast<float>((*m_values)[v]) : std::nanf(""));
    }
    append(m_result.normals, normal.squaredNorm() > 0 ? normal.normalized() : Vec3(Vec3::UnitZ()));
  }

  const HalfEdgeMesh& m_mesh;
  const Vec3 m_origin;
  const std::vector<double>* const m_values;
  Face m_first = 0;
  Face m_end = 0;
  std::vector<std::int32_t> m_vertexOf;  // drawn vertex of each half-edge's start in the block; -1: not yet
  std::vector<Corner> m_corners;         // around the vertex at work; a member to reuse its memory
  SurfaceGeometry m_result;
};

}  // namespace

std::size_t blockCount(const HalfEdgeMesh& mesh, Face blockFaces) {
  return (mesh.faceSlots() + blockFaces - 1) / blockFaces;
}

std::vector<std::size_t> blocksAround(const HalfEdgeMesh& before, const HalfEdgeMesh& after,
                                      const std::vector<Face>& touched, Face blockFaces) {
  std::vector<bool> isAround(std::max(blockCount(before, blockFaces), blockCount(after, blockFaces)));
  for (const Face f : touched) {
    if (f < after.faceSlots()) isAround[f / blockFaces] = true;
    for (const HalfEdgeMesh* mesh : {&before, &after}) {
      if (f >= mesh->faceSlots() || !mesh->isProper(f)) continue;
      for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h)
        mesh->visitFan(h, [&](HalfEdge g) { isAround[HalfEdgeMesh::face(g) / blockFaces] = true; });
    }
  }
  std::vector<std::size_t> blocks;
  for (std::size_t b = 0; b < isAround.size(); ++b)
    if (isAround[b]) blocks.push_back(b);
  return blocks;
}

SurfaceGeometry blockGeometry(const HalfEdgeMesh& mesh, std::size_t block, const Vec3& origin, Face blockFaces,
                              const std::vector<double>* values) {
  return BlockBuilder(mesh, block, origin, blockFaces, values).build();
}

}  // namespace handwheel
