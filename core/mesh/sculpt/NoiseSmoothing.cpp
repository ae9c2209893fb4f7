// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/NoiseSmoothing.h"

#include "mesh/selection/RegionGrowing.h"
#include "mesh/structure/FaceNormal.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace handwheel {
namespace {

// Around a vertex with more faces than this, only adjacent faces are compared, so that the time stays proportional to
// the faces.
constexpr std::size_t kLargestSmoothedFan = 32;

class NoiseFilter {
 public:
  NoiseFilter(const HalfEdgeMesh& mesh, const FaceSelection& part, const NoiseSmoothing& options)
      : m_mesh(mesh), m_options(options) {
    // The faces of the part and those around, whose normals are read and stay.
    grownByRing(mesh, part).forEach([&](Face f) {
      if (f >= mesh.faceSlots() || !mesh.isProper(f)) return;
      m_numberOf.emplace(f, m_faces.size());
      m_faces.push_back({f, unitNormal(mesh.points(f)), part.contains(f)});
    });
    m_origin = m_faces.empty() ? Vec3(Vec3::Zero()) : mesh.points(m_faces.front().face)[0];
    const BrushReach reach{&part, options.movesBorder};
    std::unordered_map<Vertex, std::uint32_t> seen;
    for (std::uint32_t i = 0; i < m_faces.size(); ++i) {
      for (HalfEdge h = 3 * m_faces[i].face; h < 3 * m_faces[i].face + 3; ++h) addCorner(h, reach, seen);
    }
  }

  // Returns false if cancelled.
  bool run() {
    for (int pass = 0; pass < m_options.normalPasses; ++pass) {
      if (!pollProgress(pass, m_options.normalPasses, 0.0, 0.6)) return false;
      filterNormals();
    }
    for (int pass = 0; pass < m_options.vertexPasses; ++pass) {
      if (!pollProgress(pass, m_options.vertexPasses, 0.6, 1.0)) return false;
      followNormals();
    }
    return true;
  }

  std::vector<VertexGoal> moves() const {
    std::vector<VertexGoal> moves;
    for (const Corner& c : m_vertices)
      if (c.isFree) moves.push_back({c.leaving, m_origin + c.position});
    return moves;
  }

 private:
  struct Piece {
    Face face;
    Vec3 normal;
    bool isFiltered;
    std::array<std::uint32_t, 3> corners{};
  };
  struct Corner {
    HalfEdge leaving;
    Vec3 position;  // relative to m_origin, to keep the precision far from the origin
    bool isFree;
    std::vector<std::uint32_t> faces;  // examined faces around it
  };

  void addCorner(HalfEdge h, const BrushReach& reach, std::unordered_map<Vertex, std::uint32_t>& seen) {
    const auto next = static_cast<std::uint32_t>(m_vertices.size());
    const auto [it, isNew] = seen.emplace(m_mesh.from(h), next);
    m_faces[m_numberOf.at(HalfEdgeMesh::face(h))].corners[h % 3] = it->second;
    if (!isNew) return;
    const std::vector<HalfEdge> fan = m_mesh.fan(h);
    Corner corner{h, m_mesh.position(m_mesh.from(h)) - m_origin, isFreeToMove(m_mesh, fan, reach), {}};
    for (const HalfEdge g : fan) {
      const auto face = m_numberOf.find(HalfEdgeMesh::face(g));
      if (face != m_numberOf.end()) corner.faces.push_back(static_cast<std::uint32_t>(face->second));
    }
    m_vertices.push_back(std::move(corner));
  }

  bool pollProgress(int pass, int passes, double from, double to) const {
    m_options.progress.part(from, to).set(static_cast<double>(pass) / passes);
    return !m_options.progress.cancelled();
  }

  TrianglePoints points(const Piece& f) const {
    return {m_vertices[f.corners[0]].position, m_vertices[f.corners[1]].position, m_vertices[f.corners[2]].position};
  }
  static Vec3 middle(const TrianglePoints& t) { return (t[0] + t[1] + t[2]) / 3.0; }

  // Weights: area, nearness of the middles, likeness of the normals.
  void filterNormals() {
    std::vector<Vec3> middles;
    std::vector<double> areas;
    for (const Piece& f : m_faces) {
      const TrianglePoints t = points(f);
      middles.push_back(middle(t));
      areas.push_back((t[1] - t[0]).cross(t[2] - t[0]).norm());
    }
    const double spread = spacing(middles);
    if (!(spread > 0.0)) return;
    const auto bell = [](double squared, double width) { return std::exp(-0.5 * squared / (width * width)); };
    std::vector<Vec3> filtered(m_faces.size());
    for (std::size_t i = 0; i < m_faces.size(); ++i) {
      const Piece& f = m_faces[i];
      Vec3 sum = Vec3::Zero();
      const auto add = [&](std::size_t j) {
        const Vec3& n = m_faces[j].normal;
        sum += areas[j] * bell((middles[j] - middles[i]).squaredNorm(), spread) *
               bell((n - f.normal).squaredNorm(), m_options.normalSpread) * n;
      };
      filtered[i] = f.normal;
      if (!f.isFiltered) continue;
      // A face that shares an edge is met at both of its ends, and so counts twice.
      for (const std::uint32_t c : f.corners) {
        if (m_vertices[c].faces.size() > kLargestSmoothedFan) continue;
        for (const std::uint32_t j : m_vertices[c].faces) add(j);
      }
      sum.stableNormalize();
      if (sum.squaredNorm() > 0.5) filtered[i] = sum;
    }
    for (std::size_t i = 0; i < m_faces.size(); ++i) m_faces[i].normal = filtered[i];
  }

  // The mean distance between the middles of faces that share a vertex.
  double spacing(const std::vector<Vec3>& middles) const {
    double sum = 0.0;
    std::size_t n = 0;
    for (const Corner& c : m_vertices) {
      for (std::size_t k = 1; k < c.faces.size(); ++k, ++n)
        sum += (middles[c.faces[k]] - middles[c.faces[k - 1]]).norm();
    }
    return n > 0 ? sum / static_cast<double>(n) : 0.0;
  }

  void followNormals() {
    std::vector<Vec3> steps(m_vertices.size(), Vec3::Zero());
    for (std::size_t v = 0; v < m_vertices.size(); ++v) {
      const Corner& c = m_vertices[v];
      if (!c.isFree) continue;
      for (const std::uint32_t f : c.faces) {
        const Vec3& n = m_faces[f].normal;
        steps[v] += n * n.dot(middle(points(m_faces[f])) - c.position);
      }
      steps[v] /= static_cast<double>(c.faces.size());
    }
    for (std::size_t v = 0; v < m_vertices.size(); ++v) m_vertices[v].position += steps[v];
  }

  const HalfEdgeMesh& m_mesh;
  const NoiseSmoothing m_options;
  Vec3 m_origin;
  std::vector<Piece> m_faces;
  std::unordered_map<Face, std::size_t> m_numberOf;
  std::vector<Corner> m_vertices;
};

}  // namespace

std::optional<MovedVertices> smoothNoise(HalfEdgeMesh& mesh, const FaceSelection& part, const NoiseSmoothing& options) {
  NoiseFilter filter(mesh, part, options);
  if (!filter.run()) return std::nullopt;
  return moveTowards(mesh, filter.moves(), options.numbers, options.progress.part(1.0, 1.0));
}

FaceSelection facesAtBorder(const HalfEdgeMesh& mesh, int rings) {
  FaceSelection faces;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (!mesh.isBorder(h)) continue;
    for (const HalfEdge end : {h, HalfEdgeMesh::next(h)})
      for (const HalfEdge g : mesh.fan(end)) faces.add(HalfEdgeMesh::face(g));
  }
  for (int ring = 0; ring < rings && !faces.empty(); ++ring) faces = grownByRing(mesh, faces);
  return faces;
}

}  // namespace handwheel
