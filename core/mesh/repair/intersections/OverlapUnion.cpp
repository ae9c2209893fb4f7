// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/OverlapUnion.h"

#include "base/Tolerance.h"
#include "mesh/defects/DuplicateFaces.h"
#include "mesh/structure/DisjointSets.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/PositionTriangles.h"
#include "mesh/structure/SolidAngle.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace handwheel {
namespace {

// Number of solid angles that are added in the time of one step of WorkBudget.
constexpr std::size_t kAnglesPerStep = 20;

// Winding numbers in front of a face, where its normal points, and behind it.
struct Sides {
  int front = 0;
  int back = 0;
  bool isInside() const { return front >= 1 && back >= 1; }
};

// Faces between edges at which three or more walls meet. Equal faces count as one; its name is the first face with the
// orientation of the majority.
class Walls {
 public:
  Walls(const HalfEdgeMesh& mesh, Face firstPiece, Uniting which, Progress progress)
      : m_mesh(mesh),
        m_which(which),
        m_progress(progress),
        m_nameOf(mesh.faceSlots()),
        m_net(mesh.faceSlots(), 1),
        m_walls(mesh.faceSlots()),
        m_bodies(mesh.faceSlots()) {
    const PositionTriangles byPosition(mesh, progress.part(0.0, 0.2));
    if (progress.cancelled()) return;
    const EdgeTable edges(byPosition.triangles, byPosition.classes.representative.size(), progress.part(0.2, 0.4));
    std::iota(m_nameOf.begin(), m_nameOf.end(), 0u);
    for (const FaceGroup& group : equalFaces(byPosition.triangles, edges, progress.part(0.4, 0.5)))
      nameGroup(group, byPosition.triangles, firstPiece);
    if (m_which == Uniting::AllSolids || !m_starts.empty())
      connect(edges, byPosition.triangles, progress.part(0.5, 0.7));
  }

  std::vector<Face> toRemove() {
    std::vector<Face> removed;
    if (m_starts.empty() || m_progress.cancelled()) return removed;
    for (const Face f : m_starts) unite(wallOf(f));
    for (Face f = 0; f < m_mesh.faceSlots(); ++f) {
      if (!m_mesh.isLive(f)) continue;
      const auto fate = m_removed.find(wallOf(f));
      if (fate != m_removed.end() && (fate->second == Removal::All || m_nameOf[f] != f)) removed.push_back(f);
    }
    return removed;
  }

 private:
  enum class Removal { All, AllButOne };

  Face wallOf(Face f) { return m_walls.root(m_nameOf[f]); }

  void nameGroup(const FaceGroup& group, const std::vector<Triangle>& triangles, Face firstPiece) {
    const auto up =
        std::count_if(group.faces.begin(), group.faces.end(), [&](Face f) { return looksUp(triangles[f]); });
    const int net = 2 * static_cast<int>(up) - static_cast<int>(group.faces.size());
    const Face name = *std::find_if(group.faces.begin(), group.faces.end(),
                                    [&](Face f) { return net == 0 || looksUp(triangles[f]) == (net > 0); });
    for (const Face f : group.faces) m_nameOf[f] = name;
    m_net[name] = std::abs(net);
    if (std::abs(net) > 1 && group.faces.front() >= firstPiece) m_starts.push_back(name);
  }

  void connect(const EdgeTable& edges, const std::vector<Triangle>& triangles, const Progress& progress) {
    std::vector<std::set<Face>> forks;
    edges.forEachEdge(
        [&](std::uint32_t, std::uint32_t, std::span<const EdgeTable::Entry> entries) {
          std::set<Face> names;
          for (const EdgeTable::Entry& e : entries) names.insert(m_nameOf[e.halfEdge / 3]);
          const Face first = *names.begin(), last = *names.rbegin();
          for (const Face f : names) m_bodies.join(first, f);
          if (names.size() == 2 && m_net[first] == m_net[last]) {
            m_walls.join(first, last);
          } else {
            forks.push_back(std::move(names));
          }
        },
        progress);
    for (const std::set<Face>& names : forks) {
      if (progress.cancelled()) return;
      std::set<Face> walls;
      for (const Face f : names) walls.insert(wallOf(f));
      for (const Face wall : walls) m_forksOf[wall].push_back(m_forks.size());
      m_forks.emplace_back(walls.begin(), walls.end());
    }
    if (m_which == Uniting::AllSolids) {
      for (const auto& [wall, at] : m_forksOf) m_starts.push_back(wall);
    }
    std::set<Face> bodies;
    for (const Face f : m_starts) bodies.insert(m_bodies.root(f));
    for (Face f = 0; f < triangles.size(); ++f) {
      if (hasRepeatedVertex(triangles[f])) continue;
      const Face body = m_bodies.root(m_nameOf[f]);
      if (!bodies.contains(body)) continue;
      m_facesOf[body].push_back(f);
      Face& largest = m_largest.try_emplace(wallOf(f), m_nameOf[f]).first->second;
      if (areaOf(m_mesh.points(f)) > areaOf(m_mesh.points(largest))) largest = m_nameOf[f];
    }
  }

  // Returns nothing if the winding numbers are no integers. A face halves the space around a point of it, regardless of
  // other faces.
  std::optional<Sides> measure(Face wall) {
    const Face face = m_largest.at(wall);
    const TrianglePoints p = m_mesh.points(face);
    const Vec3 at = (p[0] + p[1] + p[2]) / 3.0;
    double angle = 0.0;
    const std::vector<Face>& faces = m_facesOf.at(m_bodies.root(face));
    for (const Face f : faces) {
      if (m_nameOf[f] != face) angle += solidAngle(m_mesh.points(f), at);
    }
    m_progress.spend(faces.size() / kAnglesPerStep + 1);
    const double front = angle / (4.0 * std::numbers::pi) - 0.5 * m_net[face];
    const double whole = std::round(front);
    if (std::abs(front - whole) > tolerance::kWindingDoubt) return {};
    return Sides{static_cast<int>(whole), static_cast<int>(whole) + m_net[face]};
  }

  const std::optional<Sides>& sidesOf(Face wall) {
    const auto known = m_sides.find(wall);
    return known != m_sides.end() ? known->second : m_sides.emplace(wall, measure(wall)).first->second;
  }

  // Removes this wall and all that are shared or inside and connected with it through such walls.
  void unite(Face start) {
    if (!m_seen.insert(start).second) return;
    std::map<Face, Removal> group;
    std::set<std::size_t> met;  // forks
    bool isSure = true;
    for (std::vector<Face> left{start}; !left.empty();) {
      if (m_progress.cancelled()) return;
      const Face wall = left.back();
      left.pop_back();
      const std::optional<Sides>& sides = sidesOf(wall);
      isSure = isSure && sides && sides->front >= 0;
      group[wall] = sides && sides->isInside() ? Removal::All : Removal::AllButOne;
      for (const std::size_t fork : m_forksOf[wall]) {
        if (!met.insert(fork).second) continue;
        for (const Face next : m_forks[fork]) {
          if (m_progress.cancelled()) return;
          if (m_seen.contains(next)) continue;
          const std::optional<Sides>& there = sidesOf(next);
          isSure = isSure && there;
          if (m_net[m_largest.at(next)] < 2 && !(there && there->isInside())) continue;
          m_seen.insert(next);
          left.push_back(next);
        }
      }
    }
    if (isSure) m_removed.merge(group);
  }

  const HalfEdgeMesh& m_mesh;
  const Uniting m_which;
  const Progress m_progress;
  std::vector<Face> m_nameOf;              // per face
  std::vector<int> m_net;                  // per name: surplus of faces with its orientation over the others
  std::vector<Face> m_starts;              // names of shared walls, or of all walls at forks
  DisjointSets m_walls;                    // sets of names
  DisjointSets m_bodies;                   // sets of names
  std::vector<std::vector<Face>> m_forks;  // the walls that meet at an edge, three or more
  std::map<Face, std::vector<std::size_t>> m_forksOf;  // by wall
  std::map<Face, std::vector<Face>> m_facesOf;         // by body
  std::map<Face, Face> m_largest;                      // by wall: the name of its largest face
  std::map<Face, std::optional<Sides>> m_sides;
  std::set<Face> m_seen;
  std::map<Face, Removal> m_removed;
};

}  // namespace

std::size_t uniteAtWalls(HalfEdgeMesh& mesh, Face firstPiece, Uniting which, Progress progress) {
  const std::vector<Face> removed = Walls(mesh, firstPiece, which, progress).toRemove();
  if (progress.cancelled()) return 0;
  for (const Face f : removed) mesh.removeFace(f);
  return removed.size();
}

}  // namespace handwheel
