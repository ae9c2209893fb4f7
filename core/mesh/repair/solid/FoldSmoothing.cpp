// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/solid/FoldSmoothing.h"

#include "mesh/structure/FaceNormal.h"
#include "proximity/SelfIntersection.h"

#include <algorithm>

namespace handwheel {
namespace {

constexpr int kSmoothRounds = 8;             // number of searches, each followed by smoothing
constexpr int kSmoothPasses = 4;             // number of passes of smoothing in a round
constexpr double kMostNoises = 3.0;          // longest displacement of a vertex, in multiples of the noise
constexpr int kFoldRings = 2;                // faces within so many rings of each other are next to each other
constexpr double kFoldCosine = -0.2;         // largest cosine between the normals of faces that may fold
constexpr std::size_t kLeastPairs = 10'000;  // so many intersections are always searched
constexpr std::size_t kMostNear = 1000;      // vertices around a face, after which no ring is added

class FoldSmoother {
 public:
  FoldSmoother(HalfEdgeMesh& mesh, NumberType numbers, Progress progress)
      : m_mesh(mesh), m_numbers(numbers), m_progress(progress), m_neighbours(mesh.vertexSlots()) {
    for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
      if (!mesh.isLive(HalfEdgeMesh::face(h))) continue;
      const Vertex a = mesh.from(h), b = mesh.to(h);
      m_neighbours[a].push_back(b);
      if (!mesh.hasOpposite(h)) m_neighbours[b].push_back(a);
      m_isBorder.resize(mesh.vertexSlots(), false);
      if (!mesh.hasOpposite(h)) m_isBorder[a] = m_isBorder[b] = true;
    }
  }

  SmoothedFolds run() {
    SmoothedFolds result;
    for (int round = 0; round < kSmoothRounds; ++round) {
      const Progress part = m_progress.part(double(round) / kSmoothRounds, (round + 1.0) / kSmoothRounds);
      const std::vector<Vertex> folded = foldedVertices(part);
      if (m_progress.cancelled()) return {};
      if (folded.empty()) break;
      if (round == 0) {
        result.noise = noiseAt(folded);
        m_home = positions();
      }
      for (int pass = 0; pass < kSmoothPasses; ++pass) smooth(folded, kMostNoises * result.noise);
    }
    for (Vertex v = 0; v < m_home.size(); ++v) {
      const double displacement = (m_mesh.position(v) - m_home[v]).norm();
      if (displacement > 0.0) result.moved.push_back(v);
      result.farthest = std::max(result.farthest, displacement);
    }
    return result;
  }

 private:
  std::vector<Vec3> positions() const {
    std::vector<Vec3> all;
    for (Vertex v = 0; v < m_mesh.vertexSlots(); ++v) all.push_back(m_mesh.position(v));
    return all;
  }

  // Returns the vertices of faces that intersect faces next to them, and the vertices around. Where more pairs of faces
  // intersect than there are faces, the vertices of sharp edges stand for the others.
  std::vector<Vertex> foldedVertices(const Progress& progress) const {
    const HalfEdgeMesh::Compact compact = m_mesh.compact();
    const std::size_t most = std::max(kLeastPairs, compact.faceOf.size());
    const auto pairs = selfIntersections(compact.soup.points, compact.soup.triangles, progress, most);
    std::vector<bool> isFolded(m_mesh.vertexSlots(), false);
    if (!pairs) return {};
    if (pairs->size() == most) markSharpEdges(isFolded);
    Face last = kNone;
    std::vector<Vertex> near;  // vertices near the last face
    for (const auto& [first, second] : *pairs) {
      const Face f = compact.faceOf[first], g = compact.faceOf[second];
      if (f != last) near = verticesNear(f);
      last = f;
      const Triangle other = m_mesh.triangle(g);
      if (std::none_of(other.begin(), other.end(),
                       [&](Vertex v) { return std::binary_search(near.begin(), near.end(), v); }))
        continue;
      for (const Face face : {f, g})
        for (const Vertex v : m_mesh.triangle(face)) isFolded[v] = true;
    }
    std::vector<Vertex> folded;
    std::vector<bool> isAround = isFolded;
    for (Vertex v = 0; v < isFolded.size(); ++v) {
      if (!isFolded[v]) continue;
      for (const Vertex w : m_neighbours[v]) isAround[w] = true;
    }
    for (Vertex v = 0; v < isAround.size(); ++v)
      if (isAround[v] && !m_isBorder[v]) folded.push_back(v);
    return folded;
  }

  void markSharpEdges(std::vector<bool>& isMarked) const {
    for (HalfEdge h = 0; h < m_mesh.halfEdgeSlots(); ++h) {
      if (!m_mesh.isLive(HalfEdgeMesh::face(h)) || !m_mesh.hasOpposite(h)) continue;
      const Vec3 ours = unitNormal(m_mesh.points(HalfEdgeMesh::face(h)));
      const Vec3 theirs = unitNormal(m_mesh.points(HalfEdgeMesh::face(m_mesh.opposite(h))));
      if (ours.dot(theirs) < kFoldCosine) isMarked[m_mesh.from(h)] = isMarked[m_mesh.to(h)] = true;
    }
  }

  // Returns the vertices within a few rings of a face, ascending.
  std::vector<Vertex> verticesNear(Face f) const {
    const Triangle corners = m_mesh.triangle(f);
    std::vector<Vertex> near(corners.begin(), corners.end());
    for (int ring = 0; ring < kFoldRings && near.size() < kMostNear; ++ring) {
      const std::vector<Vertex> inner = near;
      for (const Vertex v : inner) near.insert(near.end(), m_neighbours[v].begin(), m_neighbours[v].end());
      std::sort(near.begin(), near.end());
      near.erase(std::unique(near.begin(), near.end()), near.end());
    }
    return near;
  }

  Vec3 middle(Vertex v) const {
    Vec3 sum = Vec3::Zero();
    for (const Vertex w : m_neighbours[v]) sum += m_mesh.position(w);
    return sum / std::max<double>(1.0, static_cast<double>(m_neighbours[v].size()));
  }

  // Returns the median distance of the vertices from the middle of their neighbours.
  double noiseAt(const std::vector<Vertex>& vertices) const {
    std::vector<double> distances;
    for (const Vertex v : vertices) distances.push_back((middle(v) - m_mesh.position(v)).norm());
    const auto at = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), at, distances.end());
    return *at;
  }

  void smooth(const std::vector<Vertex>& vertices, double most) {
    std::vector<Vec3> goals;
    for (const Vertex v : vertices) {
      Vec3 displacement = 0.5 * (m_mesh.position(v) + middle(v)) - m_home[v];
      if (const double length = displacement.norm(); length > most) displacement *= most / length;
      goals.push_back(rounded(Vec3(m_home[v] + displacement), m_numbers));
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) m_mesh.setPosition(vertices[i], goals[i]);
  }

  HalfEdgeMesh& m_mesh;
  NumberType m_numbers;
  Progress m_progress;
  std::vector<std::vector<Vertex>> m_neighbours;
  std::vector<bool> m_isBorder;
  std::vector<Vec3> m_home;  // positions before
};

}  // namespace

SmoothedFolds smoothFolds(HalfEdgeMesh& mesh, NumberType numbers, Progress progress) {
  HalfEdgeMesh work = mesh;
  SmoothedFolds done = FoldSmoother(work, numbers, progress).run();
  if (progress.cancelled()) return {};
  if (!done.moved.empty()) mesh = std::move(work);
  return done;
}

}  // namespace handwheel
