// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/EarClipping.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace handwheel {
namespace {

// Badness of an ear that must wait for all others.
constexpr double kFolded = 1e6;

// The polygon still to be closed: a ring of loop points, walked against the loop, so that ears face outward.
class EarClipper {
 public:
  EarClipper(const HoleContext& hole, const Obstacles& obstacles, const EarWeights& weights)
      : m_points(hole.loop()),
        m_outward(hole.outward()),
        m_obstacles(obstacles),
        m_weights(weights),
        m_edges(obstacles.edgesAmong(m_points)) {
    const std::size_t n = m_points.size();
    m_nodes.resize(n);
    double total = 0.0;
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t after = static_cast<std::uint32_t>((i + 1) % n);
      total += (m_points[after] - m_points[i]).norm();
      m_nodes[i].previous = after;
      m_nodes[after].next = i;
      // The face behind the edge from "after" to i.
      const Vec3& apex = hole.apexes[i];
      m_nodes[after].normal = (m_points[after] - m_points[i]).cross(apex - m_points[i]).normalized();
    }
    m_meanEdge = total / static_cast<double>(n);
  }

  std::optional<Patch> run(Progress progress) {
    for (std::uint32_t i = 0; i < m_nodes.size(); ++i) push(i);
    std::size_t left = m_nodes.size();
    while (left > 3) {
      if (m_heap.empty() || progress.cancelled()) return std::nullopt;
      progress.set(1.0 - static_cast<double>(left) / static_cast<double>(m_nodes.size()));
      const Candidate c = m_heap.top();
      m_heap.pop();
      if (m_nodes[c.node].version != c.version || !isFree(c.node)) continue;
      cut(c.node);
      --left;
    }
    const Triangle last = ear(lastNode());
    if (isDegenerate(points(last)) || isBlocked(points(last))) return std::nullopt;
    m_triangles.push_back(last);

    Patch patch;
    patch.loopSize = m_points.size();
    patch.points = m_points;
    patch.triangles = m_triangles;
    patch.method = FillMethod::Ear;
    return patch;
  }

 private:
  struct Node {
    std::uint32_t previous = 0;
    std::uint32_t next = 0;
    Vec3 normal = Vec3::Zero();  // normal of the face behind the edge from this node to the next
    int version = 0;             // grows when the ear changes; -1 once cut
  };
  struct Candidate {
    double badness;
    std::uint32_t node;
    int version;
    bool operator<(const Candidate& other) const {
      return badness != other.badness ? badness > other.badness : node > other.node;
    }
  };

  Triangle ear(std::uint32_t i) const { return {m_nodes[i].previous, i, m_nodes[i].next}; }
  TrianglePoints points(const Triangle& t) const { return {m_points[t[0]], m_points[t[1]], m_points[t[2]]}; }

  double badness(std::uint32_t i) const {
    const TrianglePoints p = points(ear(i));
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    const double newEdge = (p[2] - p[0]).norm();
    double largest = 0.0;
    for (int k = 0; k < 3; ++k) {
      const Vec3 u = p[(k + 1) % 3] - p[k];
      const Vec3 v = p[(k + 2) % 3] - p[k];
      largest = std::max(largest, std::atan2(u.cross(v).norm(), u.dot(v)));
    }
    constexpr double third = M_PI / 3.0;
    const double before = normal.dot(m_nodes[m_nodes[i].previous].normal), after = normal.dot(m_nodes[i].normal);
    const double bend = 1.0 - 0.5 * (before + after);
    const double lid = m_weights.lid * normal.dot(m_outward);
    // A flipped ear is at a reflex corner and is used only as a last resort. The faces it joins cannot decide that
    // where they are perpendicular to the hole, as around a cut.
    const bool isTurned = m_weights.lid > 0.0 ? before + after + lid < 0.0 : before < 0.0 && after < 0.0;
    const double folded = isTurned ? kFolded : 0.0;
    return m_weights.length * newEdge / m_meanEdge + m_weights.angles * (largest - third) / (M_PI - third) +
           m_weights.normal * bend + folded;
  }

  void push(std::uint32_t i) {
    const double b = badness(i);
    if (std::isfinite(b)) m_heap.push({b, i, m_nodes[i].version});
  }

  bool isBlocked(const TrianglePoints& t) const {
    if (m_obstacles.hits(t)) return true;
    return !m_cutOff.forEachInBox(boxOf(t), [&](const TrianglePoints& other) { return !trianglesMeet(t, other); });
  }

  bool isFree(std::uint32_t i) const {
    const Triangle t = ear(i);
    const std::pair<std::uint32_t, std::uint32_t> edge = std::minmax(t[0], t[2]);
    if (std::binary_search(m_edges.begin(), m_edges.end(), edge)) return false;
    return !isDegenerate(points(t)) && !isBlocked(points(t));
  }

  void cut(std::uint32_t i) {
    const Triangle t = ear(i);
    const TrianglePoints p = points(t);
    m_triangles.push_back(t);
    m_cutOff.add(p);
    m_nodes[t[0]].next = t[2];
    m_nodes[t[2]].previous = t[0];
    m_nodes[t[0]].normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    m_nodes[i].version = -1;
    for (std::uint32_t j : {t[0], t[2]}) {
      ++m_nodes[j].version;
      push(j);
    }
  }

  std::uint32_t lastNode() const {
    const auto at = std::find_if(m_nodes.begin(), m_nodes.end(), [](const Node& n) { return n.version >= 0; });
    return static_cast<std::uint32_t>(at - m_nodes.begin());
  }

  std::vector<Vec3> m_points;
  Vec3 m_outward;
  const Obstacles& m_obstacles;
  EarWeights m_weights;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> m_edges;  // edges that already exist
  std::vector<Node> m_nodes;
  std::priority_queue<Candidate> m_heap;
  std::vector<Triangle> m_triangles;  // the ears cut so far
  IncrementalHierarchy m_cutOff;      // hierarchy of these ears
  double m_meanEdge = 0.0;
};

}  // namespace

std::optional<Patch> clipEars(const HoleContext& hole, const Obstacles& obstacles, const EarWeights& weights,
                              Progress progress) {
  return EarClipper(hole, obstacles, weights).run(progress);
}

}  // namespace handwheel
