// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/repair/RemainingDefects.h"

#include "mesh/structure/FaceComponents.h"
#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/OrientationReversal.h"
#include "tools/mesh/repair/DefectFixes.h"

#include <QtGlobal>
#include <algorithm>
#include <map>
#include <set>

namespace handwheel {
namespace {

constexpr const char* kTooManyToSeparate =
    QT_TRANSLATE_NOOP("Tool", "separating all of them would take too long for a mesh of this size");
constexpr const char* kAtKeptBoundary = QT_TRANSLATE_NOOP("Tool", "a boundary that is to stay open goes through it");
constexpr const char* kNeedsLongCut = QT_TRANSLATE_NOOP(
    "Tool",
    "it takes a cut longer than a hundredth of the model, which “Repair all” does not make; it can be made here");
constexpr const char* kCutStaysOpen = QT_TRANSLATE_NOOP(
    "Tool", "the cut would begin and end at an open edge, which “Repair all” does not make; it can be made here");

// The corners of the loops that a repair left for one of these reasons.
std::set<PointKey> cornersOf(const InspectedMesh& after, const RepairReport& report,
                             std::initializer_list<FillFailure> reasons) {
  std::set<Vertex> keys;
  for (const OpenLoop& loop : report.openLoops)
    if (std::find(reasons.begin(), reasons.end(), loop.reason) != reasons.end()) keys.insert(loop.key);
  std::set<PointKey> corners;
  if (keys.empty()) return corners;
  for (const BoundaryLoop& loop : after.defects->loops) {
    if (!keys.contains(keyOf(after.mesh, loop))) continue;
    for (const Vec3& p : loopPoints(after.mesh, loop)) corners.insert(positionKey(p));
  }
  return corners;
}

// The reasons why one-sided components were not cut, by component: a repair cuts along short cycles inside the surface
// only.
class OneSidedParts {
 public:
  // The result is invalid if cancelled.
  OneSidedParts(const InspectedMesh& after, Progress progress)
      : m_byPosition(after.mesh, progress.part(0.0, 0.3)),
        m_components(after.mesh, m_byPosition, progress.part(0.3, 0.5)) {
    if (progress.cancelled()) return;
    const std::vector<std::uint32_t>& classOf = m_byPosition.classes.classOf;
    for (Face f = 0; f < after.mesh.faceSlots(); ++f) {
      if (!after.mesh.isLive(f) || hasRepeatedVertex(m_byPosition.triangles[f])) continue;
      for (const std::uint32_t corner : m_byPosition.triangles[f]) m_componentOf[corner] = m_components.of(f);
    }
    for (const auto& [a, b] : after.defects->nonOrientableEdges) m_parts.try_emplace(m_componentOf.at(classOf[a]));
    for (Face f = 0; f < after.mesh.faceSlots(); ++f) {
      if (!after.mesh.isLive(f)) continue;
      const auto part = m_parts.find(m_components.of(f));
      if (part != m_parts.end()) part->second.push_back(m_byPosition.triangles[f]);
    }
    const double longest = tolerance::kOneSidedCut * diagonalOf(after.mesh);
    for (auto& [component, triangles] : m_parts) {
      m_reasons[component] = reasonFor(after.mesh, triangles, longest, progress.part(0.5, 1.0));
      triangles = {};
    }
  }

  const char* reasonAt(Vertex v) const { return m_reasons.at(m_componentOf.at(m_byPosition.classes.classOf[v])); }

 private:
  // triangles: over the classes of points; numbered anew, so that all parts together take O(n).
  const char* reasonFor(const HalfEdgeMesh& mesh, std::vector<Triangle>& triangles, double longest,
                        const Progress& progress) const {
    std::map<std::uint32_t, std::uint32_t> numbers;
    std::vector<Vec3> points;
    for (Triangle& t : triangles) {
      for (std::uint32_t& corner : t) {
        const auto [at, isNew] = numbers.emplace(corner, static_cast<std::uint32_t>(points.size()));
        if (isNew) points.push_back(mesh.position(m_byPosition.classes.representative[corner]));
        corner = at->second;
      }
    }
    const EdgeTable edges(triangles, points.size(), progress);
    const auto cycle = shortestOrientationReversingCycle(edges, triangles, points, longest, progress);
    if (!cycle) return kNeedsLongCut;
    return cycle->isOnBorder ? kCutStaysOpen : kNoCleanCut;
  }

  PositionTriangles m_byPosition;
  FaceComponents m_components;
  std::map<std::uint32_t, std::uint32_t> m_componentOf;  // by class of points
  std::map<std::uint32_t, std::vector<Triangle>> m_parts;
  std::map<std::uint32_t, const char*> m_reasons;
};

}  // namespace

RemainingDefects remainingDefects(const InspectedMesh& after, const RepairReport& report, Progress progress) {
  RemainingDefects left;
  const Defects& defects = *after.defects;
  const auto isAt = [&](const std::set<PointKey>& positions, Vertex v) {
    return positions.contains(positionKey(after.mesh.position(v)));
  };
  const std::set<PointKey> kept = cornersOf(after, report, {FillFailure::KeptOpen});
  for (const auto& [a, b] : defects.nearVertices)
    left.nearVertices.push_back(isAt(kept, a) || isAt(kept, b) ? kAtKeptBoundary : kCrowdsEdges);

  const std::set<PointKey> spared = cornersOf(after, report, {FillFailure::KeptOpen, FillFailure::TooLong});
  const auto unseparated = [&](std::initializer_list<Vertex> ends) {
    if (std::any_of(ends.begin(), ends.end(), [&](Vertex v) { return isAt(spared, v); })) return kAtKeptBoundary;
    return report.isSeparationIncomplete ? kTooManyToSeparate : kNotSeparable;
  };
  for (const auto& [a, b] : defects.nonManifoldEdges) left.nonManifoldEdges.push_back(unseparated({a, b}));
  for (const Vertex v : defects.nonManifoldVertices) left.nonManifoldVertices.push_back(unseparated({v}));

  if (defects.nonOrientableEdges.empty()) return left;
  const OneSidedParts parts(after, progress);
  if (progress.cancelled()) return {};
  for (const auto& [a, b] : defects.nonOrientableEdges) left.nonOrientableEdges.push_back(parts.reasonAt(a));
  return left;
}

}  // namespace handwheel
