// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/MeshSelection.h"

#include <algorithm>
#include <unordered_set>

namespace handwheel {

const BoundaryLoop* loopWithKey(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, Vertex key) {
  const auto found =
      std::find_if(loops.begin(), loops.end(), [&](const BoundaryLoop& loop) { return keyOf(mesh, loop) == key; });
  return found == loops.end() ? nullptr : &*found;
}

std::vector<Vec3> outlineOf(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) {
  std::vector<Vec3> points = loopPoints(mesh, loop);
  if (!points.empty()) points.push_back(points.front());
  return points;
}

std::vector<std::vector<Vec3>> outlinesOf(const HalfEdgeMesh& mesh, const FaceSelection& faces) {
  const auto isInside = [&](HalfEdge h) {
    return mesh.hasOpposite(h) && faces.contains(HalfEdgeMesh::face(mesh.opposite(h)));
  };
  std::unordered_set<HalfEdge> seen;
  std::vector<std::vector<Vec3>> lines;
  faces.forEach([&](Face f) {
    if (!mesh.isProper(f)) return;
    for (HalfEdge first = 3 * f; first < 3 * f + 3; ++first) {
      if (isInside(first) || seen.contains(first)) continue;
      std::vector<Vec3>& line = lines.emplace_back();
      for (HalfEdge h = first; seen.insert(h).second;) {
        line.push_back(mesh.position(mesh.from(h)));
        for (h = HalfEdgeMesh::next(h); isInside(h);) h = HalfEdgeMesh::next(mesh.opposite(h));
      }
      line.push_back(line.front());
    }
  });
  return lines;
}

void MeshSelection::add(const MeshSelection& other) {
  faces.add(other.faces);
  loops.insert(other.loops.begin(), other.loops.end());
}

void MeshSelection::remove(const MeshSelection& other) {
  faces.remove(other.faces);
  std::erase_if(loops, [&](Vertex key) { return other.loops.count(key) != 0; });
}

void MeshSelection::dropDead(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> present) {
  faces.dropDead(mesh);
  if (loops.empty()) return;
  std::set<Vertex> keys;
  for (const BoundaryLoop& loop : present) keys.insert(keyOf(mesh, loop));
  std::erase_if(loops, [&](Vertex key) { return keys.count(key) == 0; });
}

void SelectionHistory::change(MeshSelection selection) {
  if (selection == present()) return;
  m_steps.erase(m_steps.begin() + static_cast<std::ptrdiff_t>(m_at) + 1, m_steps.end());
  if (m_steps.size() == kMostSteps) m_steps.erase(m_steps.begin());
  m_steps.push_back(std::move(selection));
  m_at = m_steps.size() - 1;
}

}  // namespace handwheel
