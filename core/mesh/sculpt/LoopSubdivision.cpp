// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/LoopSubdivision.h"
#include "mesh/sculpt/TriangleSplit.h"
#include "mesh/sculpt/VertexGoals.h"
#include "mesh/selection/RegionGrowing.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/MeshDelta.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {
namespace {

class PatchSplitter {
 public:
  PatchSplitter(HalfEdgeMesh& mesh, const FaceSelection& patch, const SubdivisionLimits& limits)
      : m_mesh(mesh), m_before(mesh), m_limits(limits) {
    patch.forEach([&](Face f) {
      if (f < mesh.faceSlots() && mesh.isProper(f)) m_faces.push_back(f);
    });
    m_step.firstAdded = {static_cast<Vertex>(mesh.vertexSlots()), static_cast<Face>(mesh.faceSlots())};
  }

  // Repeats a subdivision with the diagonals of the finer mesh, its positions, and its added slots.
  void repeat(const HalfEdgeMesh& fine, FirstSlots firstAdded) {
    m_fine = &fine;
    m_step.firstAdded = firstAdded;
  }

  SubdivisionStep run() {
    m_step.failure = makeRoom();
    if (m_step.failure != SubdivisionFailure::None) return std::move(m_step);
    addPoints();
    placePoints();
    for (std::size_t i = 0; i < m_faces.size() && pollProgress(i, m_faces.size(), m_limits.progress); ++i) split(i);
    for (std::size_t i = 0; i < m_faces.size() && !m_limits.progress.cancelled(); ++i) join(i);
    if (!m_limits.progress.cancelled()) finish();
    if (m_limits.progress.cancelled()) m_step.failure = SubdivisionFailure::Cancelled;
    if (m_step.failure != SubdivisionFailure::None) m_mesh = m_before;
    return std::move(m_step);
  }

 private:
  // The sides by face of the patch and corner from which the edge starts.
  struct Sides {
    std::array<HalfEdge, 3> first{kNone, kNone, kNone};   // the half-edge of a part along the beginning of the edge,
    std::array<HalfEdge, 3> second{kNone, kNone, kNone};  // along its end; where it has no point, first is all of it
    std::array<Vertex, 3> point{kNone, kNone, kNone};
  };

  std::size_t indexOf(Face f) const {
    const auto it = std::lower_bound(m_faces.begin(), m_faces.end(), f);
    return it != m_faces.end() && *it == f ? static_cast<std::size_t>(it - m_faces.begin()) : m_faces.size();
  }
  bool isInside(HalfEdge h) const {
    return m_before.hasOpposite(h) && indexOf(HalfEdgeMesh::face(m_before.opposite(h))) < m_faces.size();
  }

  // Adds missing dead slots for the added elements.
  SubdivisionFailure makeRoom() {
    std::size_t inside = 0;
    for (const Face f : m_faces) {
      for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) inside += isInside(h);
    }
    if (inside == 0) return SubdivisionFailure::NoEdgeInside;
    const std::size_t parts = m_faces.size() + inside;  // each edge with a point adds one part to either face
    constexpr std::size_t kMostSlots = 0xffffffff / 3 - 1;
    const bool isTooMany = m_fine ? !fitsFiner(inside, inside / 2)
                                  : parts > m_limits.mostFaces || m_before.faceSlots() + inside > kMostSlots;
    if (isTooMany) return SubdivisionFailure::TooManyFaces;
    const auto [vertex, face] = m_step.firstAdded;
    while (m_mesh.vertexSlots() < vertex + inside / 2) m_mesh.addVertex(Vec3::Zero());
    while (m_mesh.faceSlots() < face + inside) m_mesh.addFace({kNone, kNone, kNone});
    return SubdivisionFailure::None;
  }

  // Returns true if the finer mesh has empty slots for so many more elements.
  bool fitsFiner(std::size_t faces, std::size_t vertices) const {
    const auto [vertex, face] = m_step.firstAdded;
    if (m_before.vertexSlots() > m_fine->vertexSlots() || m_before.faceSlots() > m_fine->faceSlots()) return false;
    if (vertex > m_before.vertexSlots() || vertex + vertices > m_fine->vertexSlots()) return false;
    if (face > m_before.faceSlots() || face + faces > m_fine->faceSlots()) return false;
    const std::size_t end = std::min(face + faces, m_before.faceSlots());
    for (Face f = face; f < end; ++f)
      if (m_before.isLive(f)) return false;
    return true;
  }

  // Adds points in the middle of each inner edge, and computes Loop's positions.
  void addPoints() {
    m_sides.resize(m_faces.size());
    const auto at = [&](Vertex v) -> const Vec3& { return m_before.position(v); };
    for (std::size_t i = 0; i < m_faces.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const HalfEdge h = 3 * m_faces[i] + k;
        if (m_sides[i].point[k] != kNone || !isInside(h)) continue;
        const HalfEdge o = m_before.opposite(h);
        const Vec3& a = at(m_before.from(h));
        const Vec3 middle = a + 0.5 * (at(m_before.to(h)) - a);
        const Vertex v = m_step.firstAdded.vertex + static_cast<Vertex>(m_edgeOf.size());
        m_mesh.setPosition(v, rounded(middle, m_limits.numbers));
        m_sides[i].point[k] = m_sides[indexOf(HalfEdgeMesh::face(o))].point[o % 3] = v;
        m_edgeOf.push_back(h);
      }
    }
  }

  // Makes all stencils with half-edges of the coarse mesh, which are replaced by those of the finer one later.
  void placePoints() {
    std::vector<std::pair<Vertex, HalfEdge>> corners;
    for (const Face f : m_faces) {
      for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) corners.emplace_back(m_before.from(h), h);
    }
    std::sort(corners.begin(), corners.end());
    std::vector<Vertex> sources;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (i > 0 && corners[i].first == corners[i - 1].first) continue;
      const std::vector<HalfEdge> fan = m_before.fan(corners[i].second);
      const bool isFree = std::all_of(fan.begin(), fan.end(), [&](HalfEdge h) { return isInside(h); });
      sources.assign(1, corners[i].first);
      if (isFree)
        for (const HalfEdge h : fan) sources.push_back(m_before.to(h));
      m_stencils.add(isFree ? LoopStencils::Kind::Inner : LoopStencils::Kind::Fixed, corners[i].second, sources);
    }
    m_corners = m_stencils.size();
    for (const HalfEdge h : m_edgeOf) {
      const auto apex = [&](HalfEdge g) { return m_before.from(HalfEdgeMesh::previous(g)); };
      const std::array<Vertex, 4> ends = {m_before.from(h), m_before.to(h), apex(h), apex(m_before.opposite(h))};
      m_stencils.add(LoopStencils::Kind::Edge, h, ends);
    }
    for (std::size_t e = 0; e < m_edgeOf.size(); ++e)
      m_edgePosition.push_back(m_stencils.position(m_before, m_corners + e));
  }

  void split(std::size_t i) {
    const Face f = m_faces[i];
    std::array<Vertex, 6> points{};
    std::array<Vec3, 6> positions;
    std::array<bool, 3> hasPoint{};
    for (std::size_t k = 0; k < 3; ++k) {
      points[k] = m_before.triangle(f)[k];
      points[3 + k] = m_sides[i].point[k];
      hasPoint[k] = points[3 + k] != kNone;
      positions[k] = m_before.position(points[k]);
      if (hasPoint[k]) positions[3 + k] = m_edgePosition[points[3 + k] - m_step.firstAdded.vertex];
    }
    const auto length = [&](std::size_t p, std::size_t q) { return (positions[p] - positions[q]).squaredNorm(); };
    const TriangleSplit parts = splitOf(hasPoint, [&](std::size_t p, std::size_t q, std::size_t r, std::size_t s) {
      return m_fine ? m_fine->triangle(f)[2] == points[q] : length(p, q) <= length(r, s);
    });
    std::array<std::array<HalfEdge, 6>, 6> along;  // the half-edge of a part that runs from one point to another
    for (auto& row : along) row.fill(kNone);
    for (std::size_t n = 0; n < parts.size(); ++n) {
      const auto& [p, q, r] = parts[n];
      const Triangle corners = {points[p], points[q], points[r]};
      const Face part = n == 0 ? f : m_step.firstAdded.face + static_cast<Face>(m_step.parent.size());
      m_mesh.setTriangle(part, corners);
      if (n > 0) m_step.parent.push_back(f);
      m_step.faces.add(part);
      along[p][q] = 3 * part;
      along[q][r] = 3 * part + 1;
      along[r][p] = 3 * part + 2;
    }
    for (std::size_t p = 0; p < 6; ++p) {
      for (std::size_t q = 0; q < p; ++q)
        if (along[p][q] != kNone && along[q][p] != kNone) m_mesh.pair(along[p][q], along[q][p]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      m_sides[i].first[k] = hasPoint[k] ? along[k][3 + k] : along[k][(k + 1) % 3];
      m_sides[i].second[k] = hasPoint[k] ? along[3 + k][(k + 1) % 3] : kNone;
    }
  }

  void join(std::size_t i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge h = 3 * m_faces[i] + k, o = m_before.opposite(h);
      const HalfEdge first = m_sides[i].first[k], second = m_sides[i].second[k];
      if (second != kNone) {
        m_mesh.pair(first, m_sides[indexOf(HalfEdgeMesh::face(o))].second[o % 3]);
      } else if (m_before.hasOpposite(h)) {
        m_mesh.pair(first, o);
      } else {
        m_mesh.setOpposite(first, o);
      }
    }
  }

  void finish() {
    if (!m_fine && hasFlattened()) {
      m_step.failure = SubdivisionFailure::TooFine;
      return;
    }
    std::vector<VertexGoal> moves;
    for (std::size_t s = 0; s < m_stencils.size(); ++s) {
      const HalfEdge old = m_stencils.leaving(s);
      const Sides& sides = m_sides[indexOf(HalfEdgeMesh::face(old))];
      // At a corner the part along the beginning of an edge leaves it; at a point, the part along the end.
      m_stencils.setLeaving(s, s < m_corners ? sides.first[old % 3] : sides.second[old % 3]);
      const Vertex v = m_mesh.from(m_stencils.leaving(s));
      if (m_fine) {
        m_mesh.setPosition(v, m_fine->position(v));
      } else if (!m_stencils.isFixed(s)) {
        moves.push_back({m_stencils.leaving(s), m_stencils.position(m_before, s)});
      }
    }
    m_step.stencils = std::move(m_stencils);
    m_step.heldBack = moveTowards(m_mesh, moves, m_limits.numbers).heldBack;
  }

  // Returns true if a part has no area though its parent has: the middles of its edges were rounded to equal positions.
  bool hasFlattened() const {
    const auto isFlat = [&](Face part, Face parent) {
      return unitNormal(m_mesh.points(part)).isZero(0.0) && !unitNormal(m_before.points(parent)).isZero(0.0);
    };
    for (const Face f : m_faces)
      if (isFlat(f, f)) return true;
    for (std::size_t n = 0; n < m_step.parent.size(); ++n)
      if (isFlat(m_step.firstAdded.face + static_cast<Face>(n), m_step.parent[n])) return true;
    return false;
  }

  HalfEdgeMesh& m_mesh;
  const HalfEdgeMesh m_before;
  const SubdivisionLimits m_limits;
  const HalfEdgeMesh* m_fine = nullptr;  // the mesh to reproduce
  std::vector<Face> m_faces;             // faces of the patch, ascending
  std::vector<Sides> m_sides;
  std::vector<HalfEdge> m_edgeOf;    // per added point: its coarse edge
  std::vector<Vec3> m_edgePosition;  // per added point: Loop's position
  LoopStencils m_stencils;
  std::size_t m_corners = 0;  // stencils of old vertices; those of new points follow
  SubdivisionStep m_step;
};

// The mean length of the edges of the faces for which the edge counts; 0 where there is none.
template <class Counts>
double meanEdge(const HalfEdgeMesh& mesh, const FaceSelection& faces, Counts counts) {
  double sum = 0.0;
  std::size_t n = 0;
  faces.forEach([&](Face f) {
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      if (!counts(h)) continue;
      sum += (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm();
      ++n;
    }
  });
  return n > 0 ? sum / static_cast<double>(n) : 0.0;
}

bool isBetween(const HalfEdgeMesh& mesh, const FaceSelection& patch, HalfEdge h) {
  return mesh.hasOpposite(h) && patch.contains(HalfEdgeMesh::face(mesh.opposite(h)));
}

}  // namespace

SubdivisionStep subdivide(HalfEdgeMesh& mesh, const FaceSelection& patch, const SubdivisionLimits& limits) {
  return PatchSplitter(mesh, patch, limits).run();
}

std::optional<SubdivisionStep> subdivisionBetween(const HalfEdgeMesh& coarse, const FaceSelection& patch,
                                                  const HalfEdgeMesh& fine, FirstSlots firstAdded) {
  HalfEdgeMesh made = coarse;
  PatchSplitter splitter(made, patch, {});
  splitter.repeat(fine, firstAdded);
  SubdivisionStep step = splitter.run();
  if (step.failure != SubdivisionFailure::None || !MeshDelta::between(made, fine).isEmpty()) return std::nullopt;
  return step;
}

double outlineAspect(const HalfEdgeMesh& mesh, const FaceSelection& patch) {
  double sum = 0.0;
  std::size_t n = 0;
  patch.forEach([&](Face f) {
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      if (isBetween(mesh, patch, h)) continue;
      const Vec3& p = mesh.position(mesh.from(h));
      const Vec3 edge = mesh.position(mesh.to(h)) - p;
      const double area = edge.cross(mesh.position(mesh.from(HalfEdgeMesh::previous(h))) - p).norm();
      if (!(area > 0.0)) continue;
      sum += edge.squaredNorm() / area;
      ++n;
    }
  });
  return n > 0 ? sum / static_cast<double>(n) : 0.0;
}

}  // namespace handwheel
