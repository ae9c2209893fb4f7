// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/Shells.h"

#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/Orientation.h"

#include <unordered_map>

namespace handwheel {
namespace {

// Copies faces from one mesh behind those of another. Numbers of the target, given out as they are met.
class Copy {
 public:
  Copy(const HalfEdgeMesh& from, HalfEdgeMesh& to) : m_from(from), m_to(to) {}

  void add(std::span<const Face> faces) {
    const auto first = static_cast<Face>(m_to.faceSlots());
    for (std::uint32_t i = 0; i < faces.size(); ++i) m_faces.emplace(faces[i], first + i);
    for (const Face f : faces) {
      Triangle corners = m_from.triangle(f);
      for (std::uint32_t& v : corners) v = vertexFor(v);
      m_to.addSlot(corners, {behind(3 * f), behind(3 * f + 1), behind(3 * f + 2)});
    }
  }

 private:
  Vertex vertexFor(Vertex v) {
    const auto [at, isNew] = m_vertices.try_emplace(v, static_cast<Vertex>(m_to.vertexSlots()));
    if (isNew) m_to.addVertex(m_from.position(v));
    return at->second;
  }

  HalfEdge behind(HalfEdge h) const {
    if (!m_from.hasOpposite(h)) return m_from.opposite(h);
    const HalfEdge o = m_from.opposite(h);
    const auto face = m_faces.find(HalfEdgeMesh::face(o));
    return face == m_faces.end() ? static_cast<HalfEdge>(Open::Border) : 3 * face->second + o % 3;
  }

  const HalfEdgeMesh& m_from;
  HalfEdgeMesh& m_to;
  std::unordered_map<Face, Face> m_faces;
  std::unordered_map<Vertex, Vertex> m_vertices;
};

}  // namespace

std::vector<std::vector<Face>> findShells(const HalfEdgeMesh& mesh, Progress progress) {
  std::vector<std::uint32_t> shellOf(mesh.faceSlots(), kNone);
  std::vector<Face> open;
  std::uint32_t count = 0;
  std::size_t steps = 0;
  for (Face seed = 0; seed < mesh.faceSlots(); ++seed) {
    if (!mesh.isLive(seed) || shellOf[seed] != kNone) continue;
    shellOf[seed] = count;
    open.assign(1, seed);
    while (!open.empty()) {
      if (!pollProgress(steps++, mesh.faceSlots(), progress)) return {};
      const Face f = open.back();
      open.pop_back();
      for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
        if (!mesh.hasOpposite(h)) continue;
        const Face other = HalfEdgeMesh::face(mesh.opposite(h));
        if (shellOf[other] != kNone) continue;
        shellOf[other] = count;
        open.push_back(other);
      }
    }
    ++count;
  }
  std::vector<std::vector<Face>> shells(count);
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (shellOf[f] != kNone) shells[shellOf[f]].push_back(f);
  }
  return shells;
}

// Every face is written once, from what it was before.
double areaOfShell(const HalfEdgeMesh& mesh, std::span<const Face> shell) {
  double area = 0.0;
  for (const Face f : shell) area += areaOf(mesh.points(f));
  return area;
}

void reverseShells(HalfEdgeMesh& mesh, std::span<const Face> faces) {
  for (const Face f : faces) {
    std::array<HalfEdge, 3> opposites;
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h)
      opposites[reversedHalfEdge(h) % 3] = mesh.hasOpposite(h) ? reversedHalfEdge(mesh.opposite(h)) : mesh.opposite(h);
    mesh.setTriangle(f, reversed(mesh.triangle(f)));
    for (HalfEdge k = 0; k < 3; ++k) mesh.setOpposite(3 * f + k, opposites[k]);
  }
}

HalfEdgeMesh extracted(const HalfEdgeMesh& mesh, std::span<const Face> faces) {
  HalfEdgeMesh result;
  Copy(mesh, result).add(faces);
  return result;
}

std::vector<HalfEdgeMesh> splitIntoShells(const HalfEdgeMesh& mesh, Progress progress) {
  const std::vector<std::vector<Face>> shells = findShells(mesh, progress.part(0.0, 0.3));
  std::vector<HalfEdgeMesh> result;
  for (const std::vector<Face>& faces : shells) {
    if (progress.cancelled()) return {};
    result.push_back(extracted(mesh, faces));
    progress.part(0.3, 1.0).set(static_cast<double>(result.size()) / static_cast<double>(shells.size()));
  }
  return result;
}

Face append(HalfEdgeMesh& mesh, const HalfEdgeMesh& other) {
  const auto first = static_cast<Face>(mesh.faceSlots());
  std::vector<Face> live;
  for (Face f = 0; f < other.faceSlots(); ++f) {
    if (other.isLive(f)) live.push_back(f);
  }
  Copy(other, mesh).add(live);
  return first;
}

}  // namespace handwheel
