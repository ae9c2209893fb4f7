// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/SculptBrush.h"

#include "mesh/structure/FaceNormal.h"
#include "proximity/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <unordered_map>
#include <unordered_set>

namespace handwheel {
namespace {

// Taubin's λ and μ, for a pass band up to 1/λ + 1/μ = 0.01: waves of some 60 edges. A wider one amplifies the passed
// waves.
constexpr double kShrinking = 0.5;
constexpr double kGrowing = 1.0 / (0.01 - 1.0 / kShrinking);

double weightAt(double squaredDistance, double radius) {
  const double s = 1.0 - squaredDistance / (radius * radius);
  return s > 0.0 ? s * s : 0.0;
}

// Returns the normal weighted by the angles at the vertex, not normalised; zero if there is none.
Vec3 normalAround(const HalfEdgeMesh& mesh, HalfEdge leaving) {
  Vec3 sum = Vec3::Zero();
  for (const HalfEdge h : mesh.fan(leaving)) {
    const Vec3& p = mesh.position(mesh.from(h));
    const Vec3 a = mesh.position(mesh.to(h)) - p, b = mesh.position(mesh.from(HalfEdgeMesh::previous(h))) - p;
    sum += std::atan2(a.cross(b).norm(), a.dot(b)) * unitNormal(mesh.points(HalfEdgeMesh::face(h)));
  }
  return sum;
}

// Finds the neighbours of the start vertex of a half-edge; for a vertex at the border, only those along it.
void neighboursOf(const HalfEdgeMesh& mesh, HalfEdge leaving, std::vector<Vertex>& neighbours) {
  const std::vector<HalfEdge> fan = mesh.fan(leaving);
  const Vertex last = mesh.from(HalfEdgeMesh::previous(fan.back()));
  if (!mesh.hasOpposite(fan.front())) return neighbours.assign({mesh.to(fan.front()), last});
  neighbours.clear();
  for (const HalfEdge h : fan) neighbours.push_back(mesh.to(h));
}

// Distances along edges from each vertex under a brush to the nearest vertex that stays (Dijkstra, 1959).
class DistancesToHeld {
 public:
  bool isNew(Vertex v) const { return !m_reached.contains(v); }
  void add(Vertex v, HalfEdge leaving, bool isFree) {
    m_reached.emplace(v, Reached{leaving, isFree ? std::numeric_limits<double>::infinity() : 0.0});
    if (!isFree) m_queue.emplace(0.0, v);
  }
  bool anyHeld() const { return !m_queue.empty(); }

  void measure(const HalfEdgeMesh& mesh) {
    while (!m_queue.empty()) {
      const auto [distance, v] = m_queue.top();
      m_queue.pop();
      const Reached& here = m_reached.at(v);
      if (distance > here.distance) continue;
      for (const HalfEdge h : mesh.fan(here.leaving)) {
        for (const Vertex n : {mesh.to(h), mesh.from(HalfEdgeMesh::previous(h))}) {
          const auto it = m_reached.find(n);
          if (it == m_reached.end()) continue;
          const double over = distance + (mesh.position(n) - mesh.position(v)).norm();
          if (!(over < it->second.distance)) continue;
          it->second.distance = over;
          m_queue.emplace(over, n);
        }
      }
    }
  }
  double from(Vertex v) const { return m_reached.at(v).distance; }

 private:
  struct Reached {
    HalfEdge leaving;
    double distance;
  };
  using Entry = std::pair<double, Vertex>;
  std::unordered_map<Vertex, Reached> m_reached;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> m_queue;
};

void fadeTowardsHeld(const HalfEdgeMesh& mesh, const DistancesToHeld& distances, BrushArea& area) {
  const auto middle =
      std::max_element(area.vertices.begin(), area.vertices.end(),
                       [](const BrushArea::Held& a, const BrushArea::Held& b) { return a.weight < b.weight; });
  if (middle == area.vertices.end()) return;
  const double whole = distances.from(mesh.from(middle->leaving));
  for (BrushArea::Held& held : area.vertices) {
    const double x = std::min(1.0, distances.from(mesh.from(held.leaving)) / whole);
    if (x < 1.0) held.weight *= x * x * (3.0 - 2.0 * x);
  }
}

}  // namespace

bool isFreeToMove(const HalfEdgeMesh& mesh, std::span<const HalfEdge> fan, const BrushReach& reach) {
  if (!reach.movesBorder && !mesh.hasOpposite(fan.front())) return false;
  return std::all_of(fan.begin(), fan.end(), [&](HalfEdge h) {
    return !mesh.isSeam(h) && !mesh.isSeam(HalfEdgeMesh::previous(h)) &&
           (!reach.patch || reach.patch->contains(HalfEdgeMesh::face(h)));
  });
}

BrushArea brushArea(const HalfEdgeMesh& mesh, Face seed, const Vec3& centre, double radius, const BrushReach& reach) {
  BrushArea area{centre, radius, {}, {}};
  if (!(radius > 0.0) || !centre.allFinite() || seed >= mesh.faceSlots() || !mesh.isProper(seed)) return area;
  std::unordered_set<Face> seen{seed};
  std::vector<Face> waiting{seed};
  DistancesToHeld distances;
  while (!waiting.empty()) {
    const Face f = waiting.back();
    waiting.pop_back();
    const auto [p, q, r] = mesh.points(f);
    // Coordinates are relative to the centre, to keep the precision far from the origin.
    const Vec3 nearest = closestOnTriangle(Vec3::Zero(), p - centre, q - centre, r - centre);
    if (f != seed && nearest.squaredNorm() > radius * radius) continue;
    area.faces.push_back(f);
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      const double weight = weightAt((mesh.position(mesh.from(h)) - centre).squaredNorm(), radius);
      if (weight > 0.0 && distances.isNew(mesh.from(h))) {
        const bool isFree = isFreeToMove(mesh, mesh.fan(h), reach);
        distances.add(mesh.from(h), h, isFree);
        if (isFree) area.vertices.push_back({h, weight});
      }
      if (!mesh.hasOpposite(h)) continue;
      const Face neighbour = HalfEdgeMesh::face(mesh.opposite(h));
      if (seen.insert(neighbour).second) waiting.push_back(neighbour);
    }
  }
  if (!distances.anyHeld()) return area;
  distances.measure(mesh);
  fadeTowardsHeld(mesh, distances, area);
  return area;
}

std::vector<VertexGoal> dragged(const HalfEdgeMesh& mesh, const BrushArea& area, const Vec3& displacement) {
  std::vector<VertexGoal> moves;
  for (const auto& [leaving, weight] : area.vertices)
    moves.push_back({leaving, mesh.position(mesh.from(leaving)) + weight * displacement});
  return moves;
}

std::vector<VertexGoal> inflated(const HalfEdgeMesh& mesh, const BrushArea& area, double distance) {
  std::vector<VertexGoal> moves;
  for (const auto& [leaving, weight] : area.vertices) {
    const Vec3 outward = normalAround(mesh, leaving).stableNormalized();
    moves.push_back({leaving, mesh.position(mesh.from(leaving)) + weight * distance * outward});
  }
  return moves;
}

// The plane through the mean of the faces' middles, perpendicular to the mean of their normals; both weighted by area.
std::vector<VertexGoal> flattened(const HalfEdgeMesh& mesh, const BrushArea& area, double strength) {
  Vec3 middle = Vec3::Zero(), normal = Vec3::Zero();
  double sum = 0.0;
  for (const Face f : area.faces) {
    const auto [p, q, r] = mesh.points(f);
    const Vec3 across = (q - p).cross(r - p), off = (p - area.centre + q - area.centre + r - area.centre) / 3.0;
    const double weight = weightAt(off.squaredNorm(), area.radius);
    sum += weight * across.norm();
    middle += weight * across.norm() * off;
    normal += weight * across;
  }
  std::vector<VertexGoal> moves;
  normal.stableNormalize();
  if (!(sum > 0.0) || !(normal.squaredNorm() > 0.5)) return moves;
  middle /= sum;
  for (const auto& [leaving, weight] : area.vertices) {
    const Vec3& p = mesh.position(mesh.from(leaving));
    moves.push_back({leaving, p - strength * weight * normal.dot(p - area.centre - middle) * normal});
  }
  return moves;
}

std::vector<VertexGoal> smoothed(const HalfEdgeMesh& mesh, const BrushArea& area, double strength) {
  std::vector<VertexGoal> moves;
  std::unordered_map<Vertex, std::size_t> moveOf;
  for (const auto& [leaving, weight] : area.vertices) {
    const Vertex v = mesh.from(leaving);
    moveOf.emplace(v, moves.size());
    moves.push_back({leaving, mesh.position(v)});
  }
  const auto at = [&](Vertex v) -> const Vec3& {
    const auto it = moveOf.find(v);
    return it == moveOf.end() ? mesh.position(v) : moves[it->second].to;
  };
  std::vector<Vec3> steps(moves.size());
  std::vector<Vertex> neighbours;
  for (const double factor : {kShrinking, kGrowing}) {
    for (std::size_t i = 0; i < moves.size(); ++i) {
      neighboursOf(mesh, moves[i].leaving, neighbours);
      Vec3 sum = Vec3::Zero();
      double weights = 0.0;
      for (const Vertex n : neighbours) {
        const Vec3 edge = at(n) - moves[i].to;
        const double length = edge.norm();
        if (!(length > 0.0)) continue;
        sum += edge / length;
        weights += 1.0 / length;
      }
      steps[i] = weights > 0.0 ? Vec3(factor * strength * area.vertices[i].weight / weights * sum) : Vec3(Vec3::Zero());
    }
    for (std::size_t i = 0; i < moves.size(); ++i) moves[i].to += steps[i];
  }
  return moves;
}

}  // namespace handwheel
