// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/Peninsulas.h"

#include "mesh/structure/CancelPolling.h"

#include <algorithm>
#include <optional>
#include <queue>
#include <set>
#include <unordered_map>
#include <utility>

namespace handwheel {
namespace {

constexpr double kNeck = 4.0;               // least ratio of the length along the loop to the distance
constexpr double kDetour = 1.6;             // largest ratio of the path along edges to the straight line
constexpr double kFacesPerEdge = 0.55;      // faces of a region over the square of the edges around it
constexpr std::size_t kLoopSamples = 3000;  // number of samples of the loop's points
constexpr std::size_t kMostTries = 200;     // number of necks, the narrowest first
constexpr std::size_t kMostVisits = 4096;   // vertices visited in the search for one neck

struct Neck {
  std::size_t from = 0, to = 0;  // indices in the loop; the peninsula is between them, across the end if to < from
  double apart = 0.0;            // mm
  double ratio = 0.0;            // length along the loop divided by apart
};

class Peninsulas {
 public:
  Peninsulas(const HalfEdgeMesh& mesh, const BoundaryLoop& hole)
      : m_mesh(mesh), m_loop(hole.halfEdges), m_points(loopPoints(mesh, hole)), m_along{0.0}, m_isTaken(size(), false) {
    for (std::size_t i = 0; i < size(); ++i) m_along.push_back(m_along[i] + (m_points[next(i)] - m_points[i]).norm());
  }

  FaceSelection run(Progress progress) {
    FaceSelection all;
    std::vector<Neck> necks = candidates(progress);
    std::size_t tries = 0;
    for (const Neck& neck : necks) {
      if (progress.cancelled() || tries == kMostTries) break;
      if (m_isTaken[neck.from] || m_isTaken[neck.to]) continue;
      ++tries;
      const auto path = pathThrough(neck);
      const auto region = path ? behind(neck, *path) : std::nullopt;
      if (!region) continue;
      all.add(*region);
      for (std::size_t i = neck.from;; i = next(i)) {
        m_isTaken[i] = true;
        if (i == neck.to) break;
      }
    }
    return all;
  }

 private:
  using Edge = std::pair<Vertex, Vertex>;

  std::size_t size() const { return m_loop.size(); }
  std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  Vertex vertex(std::size_t i) const { return m_mesh.from(m_loop[i]); }
  std::size_t edgesBetween(const Neck& n) const { return (n.to + size() - n.from) % size(); }

  // Returns the direction from the border into the surface at point i, across the edges before and after it.
  Vec3 inward(std::size_t i) const {
    Vec3 sum = Vec3::Zero();
    for (const std::size_t k : {(i + size() - 1) % size(), i}) {
      const Vec3 along = (m_points[next(k)] - m_points[k]).stableNormalized();
      const Vec3 to = m_mesh.position(m_mesh.from(HalfEdgeMesh::previous(m_loop[k]))) - m_points[k];
      sum += (to - to.dot(along) * along).stableNormalized();
    }
    return sum;
  }

  // Returns for each point the narrowest neck that starts there, sorted by narrowness.
  std::vector<Neck> candidates(Progress progress) const {
    const std::size_t stride = (size() + kLoopSamples - 1) / kLoopSamples;
    std::vector<Vec3> in;
    for (std::size_t i = 0; i < size(); ++i) in.push_back(inward(i));
    std::vector<Neck> necks;
    for (std::size_t i = 0; i < size(); i += stride) {
      if (progress.cancelled()) break;
      Neck best;
      for (std::size_t k = i + stride; k < size(); k += stride) {
        const Vec3 across = m_points[k] - m_points[i];
        const double apart = across.norm(), arc = m_along[k] - m_along[i], rest = m_along.back() - arc;
        const double shorter = std::min(arc, rest);
        if (!(shorter >= kNeck * apart) || shorter <= best.ratio * apart) continue;
        if (!(across.dot(in[i]) > 0.0) || !(across.dot(in[k]) < 0.0)) continue;
        best = arc <= rest ? Neck{i, k, apart, arc / apart} : Neck{k, i, apart, rest / apart};
      }
      if (best.ratio > 0.0) necks.push_back(best);
    }
    std::stable_sort(necks.begin(), necks.end(), [](const Neck& a, const Neck& b) { return a.ratio > b.ratio; });
    return necks;
  }

  // Finds the shortest path along edges (Dijkstra), not along the peninsula's own border. Returns its edges, each with
  // the smaller vertex first.
  std::optional<std::set<Edge>> pathThrough(const Neck& neck) const {
    std::set<HalfEdge> border;
    for (std::size_t i = neck.from; i != neck.to; i = next(i)) border.insert(m_loop[i]);
    struct Reached {
      double distance;
      Vertex before;
      HalfEdge leaving;
      bool isDone = false;
    };
    std::unordered_map<Vertex, Reached> reached;
    using Waiting = std::pair<double, Vertex>;
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting;
    const double longest = kDetour * neck.apart;
    const auto reach = [&](Vertex v, Vertex before, HalfEdge leaving, double distance) {
      if (!(distance <= longest)) return;
      const auto [at, isNew] = reached.try_emplace(v, Reached{distance, before, leaving});
      if (!isNew && at->second.distance <= distance) return;
      if (!isNew) at->second = {distance, before, leaving};
      waiting.emplace(distance, v);
    };
    const Vertex start = vertex(neck.from), goal = vertex(neck.to);
    reach(start, start, m_loop[neck.from], 0.0);
    for (std::size_t visits = 0; !waiting.empty() && visits < kMostVisits; ++visits) {
      const auto [distance, v] = waiting.top();
      waiting.pop();
      if (v == goal) break;
      if (std::exchange(reached.at(v).isDone, true)) continue;
      for (const HalfEdge g : m_mesh.fan(reached.at(v).leaving)) {
        const HalfEdge back = HalfEdgeMesh::previous(g);
        const auto length = [&, &distance = distance, &v = v](Vertex to) {
          return distance + (m_mesh.position(to) - m_mesh.position(v)).norm();
        };
        if (!border.contains(g)) reach(m_mesh.to(g), v, HalfEdgeMesh::next(g), length(m_mesh.to(g)));
        if (!m_mesh.hasOpposite(back) && !border.contains(back))
          reach(m_mesh.from(back), v, back, length(m_mesh.from(back)));
      }
    }
    if (!reached.contains(goal)) return std::nullopt;
    std::set<Edge> edges;
    for (Vertex v = goal; v != start; v = reached.at(v).before) edges.insert(std::minmax(v, reached.at(v).before));
    return edges;
  }

  // Returns the faces on the peninsula's side of the path; nothing if there are too many.
  std::optional<FaceSelection> behind(const Neck& neck, const std::set<Edge>& path) const {
    const auto around = static_cast<double>(edgesBetween(neck) + path.size());
    const auto most = static_cast<std::size_t>(kFacesPerEdge * around * around) + 4;
    FaceSelection region;
    std::vector<Face> waiting;
    const auto take = [&](Face f) {
      if (region.add(f)) waiting.push_back(f);
    };
    for (std::size_t i = neck.from; i != neck.to; i = next(i)) take(HalfEdgeMesh::face(m_loop[i]));
    while (!waiting.empty() && region.count() <= most) {
      const Face f = waiting.back();
      waiting.pop_back();
      for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
        if (!m_mesh.hasOpposite(h) || path.contains(std::minmax(m_mesh.from(h), m_mesh.to(h)))) continue;
        take(HalfEdgeMesh::face(m_mesh.opposite(h)));
      }
    }
    if (region.count() > most) return std::nullopt;
    // The rim itself stays.
    for (std::size_t i = neck.to; i != neck.from; i = next(i))
      if (region.contains(HalfEdgeMesh::face(m_loop[i]))) return std::nullopt;
    return region;
  }

  const HalfEdgeMesh& m_mesh;
  const std::vector<HalfEdge>& m_loop;
  std::vector<Vec3> m_points;
  std::vector<double> m_along;
  std::vector<bool> m_isTaken;
};

}  // namespace

FaceSelection findPeninsulas(const HalfEdgeMesh& mesh, const BoundaryLoop& hole, Progress progress) {
  return Peninsulas(mesh, hole).run(progress);
}

}  // namespace handwheel
