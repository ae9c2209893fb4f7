// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/SheetThickening.h"

#include "base/Tolerance.h"
#include "mesh/repair/OffsetSheetBuilder.h"
#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/PositionKey.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace handwheel {
namespace {

// Number of searches for intersections, each followed by moving some vertices nearer to their sheet.
constexpr int kMostSearches = 12;
// Number of new attempts to thicken the sheets, with a sharp outline where no side faces are possible.
constexpr int kMostAttempts = 3;

// Returns the vertices at which open edges meet others, so that side faces there would coincide.
std::unordered_set<Vertex> pinchedVertices(const HalfEdgeMesh& mesh) {
  std::map<PointKey, Vertex> first;
  std::unordered_set<Vertex> pinched;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f) || !mesh.isProper(f)) continue;
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      if (mesh.hasOpposite(h)) continue;
      for (const Vertex v : {mesh.from(h), mesh.to(h)}) {
        const auto [at, isNew] = first.emplace(positionKey(mesh.position(v)), v);
        if (isNew || at->second == v) continue;
        pinched.insert({v, at->second});
      }
    }
  }
  return pinched;
}

// Moves the backs of sheets nearer to the sheets where they intersect a face.
class BackWithdrawal {
 public:
  BackWithdrawal(HalfEdgeMesh& mesh, OffsetSheetBuilder& backs, NumberType numbers)
      : m_mesh(mesh),
        m_backs(backs),
        m_numbers(numbers),
        m_added(backs.faces().begin(), backs.faces().end()),
        m_frontOf(backs.facePairs().begin(), backs.facePairs().end()) {}

  // Halves the offset wherever a new face intersects a face or flips, until none does. If a face is so small that its
  // back coincides with it, both are removed. Returns the vertices of outlines from which side faces still intersect
  // others.
  std::unordered_set<Vertex> run(Progress progress) {
    unfold();
    std::set<Vertex> crossing = crossingVertices(progress);
    for (int i = 1; i < kMostSearches && halve(crossing); ++i) {
      unfold();
      crossing = crossingVertices(progress);
    }
    std::unordered_set<Vertex> outline;
    for (const Vertex v : crossing) {
      if (const SheetOffset& offset = *m_backs.offsetOf(v); offset.isOnOutline) outline.insert(offset.front);
    }
    return outline;
  }

 private:
  // The back of another face may coincide with a face too: without its front, the face's own back would be isolated.
  bool isFaceWithItsBack(Face a, Face b) const {
    const auto found = m_frontOf.find(m_added.contains(a) ? a : b);
    return found != m_frontOf.end() && found->second == (found->first == a ? b : a);
  }

  bool haveSameCorners(Face a, Face b) const {
    const auto sorted = [&](Face f) {
      const TrianglePoints p = m_mesh.points(f);
      return std::set<PointKey>{positionKey(p[0]), positionKey(p[1]), positionKey(p[2])};
    };
    return sorted(a) == sorted(b);
  }

  // Returns the back vertices of all faces that intersect others. Pairs of a face and a coincident back are removed.
  std::set<Vertex> crossingVertices(Progress progress) {
    std::set<Vertex> crossing;
    for (const auto& [a, b] : selfIntersectingPairs(m_mesh, m_numbers, progress)) {
      if (!m_mesh.isLive(a) || !m_mesh.isLive(b)) continue;  // removed with the other side of an earlier pair
      if (m_added.contains(a) != m_added.contains(b) && haveSameCorners(a, b) && isFaceWithItsBack(a, b)) {
        m_mesh.removeFace(a);
        m_mesh.removeFace(b);
      }
      for (const Face f : {a, b})
        if (m_added.contains(f) && m_mesh.isLive(f)) insertOffsetVertices(f, crossing);
    }
    return crossing;
  }

  void insertOffsetVertices(Face f, std::set<Vertex>& vertices) const {
    for (const Vertex v : m_mesh.triangle(f))
      if (m_backs.offsetOf(v)) vertices.insert(v);
  }

  // Returns false if none could be halved.
  bool halve(const std::set<Vertex>& vertices) {
    return std::count_if(vertices.begin(), vertices.end(), [&](Vertex v) { return m_backs.halve(v); }) > 0;
  }

  // A flipped back shows that the sheet bends more than the offset allows.
  void unfold() {
    std::set<Vertex> turned;
    do {
      turned.clear();
      for (const auto& [back, front] : m_backs.facePairs()) {
        if (m_mesh.isLive(back) && unitNormal(m_mesh, back).dot(unitNormal(m_mesh, front)) > 0.0)
          insertOffsetVertices(back, turned);
      }
    } while (halve(turned));
  }

  HalfEdgeMesh& m_mesh;
  OffsetSheetBuilder& m_backs;
  NumberType m_numbers;
  std::unordered_set<Face> m_added;
  std::unordered_map<Face, Face> m_frontOf;  // by the back
};

std::vector<Face> liveFaces(const HalfEdgeMesh& mesh, std::vector<Face> faces) {
  std::erase_if(faces, [&](Face f) { return !mesh.isLive(f); });
  return faces;
}

}  // namespace

void SheetThickness::extend(const SheetThickness& other) {
  vertices += other.vertices;
  thinVertices += other.thinVertices;
  if (other.largest <= 0.0) return;
  least = largest > 0.0 ? std::min(least, other.least) : other.least;
  largest = std::max(largest, other.largest);
}

std::size_t SheetOutcomes::leftCount() const {
  return std::accumulate(left.begin(), left.end(), std::size_t{0},
                         [](std::size_t sum, const auto& entry) { return sum + entry.second; });
}

void SheetOutcomes::extend(const SheetOutcomes& later) {
  thickened += later.thickened;
  left = later.left;
  leftLoops = later.leftLoops;
  thickness.extend(later.thickness);
}

ThickenedSheets thickenSheets(HalfEdgeMesh& mesh, std::span<const OpenSheet> sheets, NumberType numbers,
                              Progress progress) {
  const HalfEdgeMesh before = mesh;
  std::unordered_set<Vertex> kept = pinchedVertices(mesh);
  for (int attempt = 1;; ++attempt) {
    OffsetSheetBuilder backs(mesh, numbers, kept);
    std::vector<bool> isThickened;
    for (const OpenSheet& sheet : sheets) {
      isThickened.push_back(!progress.cancelled() && backs.add(sheet));
      progress.spend(sheet.faces.size());
    }
    const std::unordered_set<Vertex> crossing = BackWithdrawal(mesh, backs, numbers).run(progress);
    if (crossing.empty() || attempt == kMostAttempts || progress.cancelled())
      return {liveFaces(mesh, backs.faces()), backs.reached(), std::move(isThickened)};
    kept.insert(crossing.begin(), crossing.end());
    mesh = before;
  }
}

double defaultSheetThickness(const Box& box) {
  return box.isEmpty() ? 0.0 : tolerance::kSheetThickness * box.diagonal().norm();
}

double defaultSheetThickness(const HalfEdgeMesh& mesh) {
  return defaultSheetThickness(boundsOf(mesh));
}

double proposedSheetThickness(std::span<const Box> outlines, const Box& part, double unit) {
  constexpr double kShare = 0.01, kOfNoise = 10.0;
  double largest = 0.0;
  for (const Box& outline : outlines)
    if (!outline.isEmpty()) largest = std::max(largest, outline.diagonal().norm());
  if (!(largest > 0.0) || part.isEmpty()) return defaultSheetThickness(part);
  const double wanted = std::max(kShare * largest, kOfNoise * tolerance::kNearWeld * part.diagonal().norm()) / unit;
  const double digit = std::floor(std::log10(wanted)), scale = std::pow(10.0, std::abs(digit));
  const double rounded = digit < 0.0 ? std::round(wanted * scale) / scale : std::round(wanted / scale) * scale;
  return std::isfinite(rounded) ? rounded * unit : defaultSheetThickness(part);
}

std::vector<Face> sheetOf(const HalfEdgeMesh& mesh, Face f) {
  std::vector<Face> sheet{f};
  std::unordered_set<Face> seen{f};
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    for (HalfEdge h = 3 * sheet[i]; h < 3 * sheet[i] + 3; ++h) {
      if (!mesh.hasOpposite(h)) continue;
      const Face g = HalfEdgeMesh::face(mesh.opposite(h));
      if (seen.insert(g).second) sheet.push_back(g);
    }
  }
  return sheet;
}

}  // namespace handwheel
