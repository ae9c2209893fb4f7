// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/demo/DemoHole.h"

#include "mesh/search/FaceLocator.h"
#include "panels/defects/DefectList.h"
#include "window/mesh/UnobstructedView.h"

#include <algorithm>
#include <vector>

namespace handwheel {

namespace {

constexpr double kNarrow = 1.0 / 3;     // smallest fraction of the points of a hole on either side of a waist
constexpr std::size_t kMostTried = 30;  // waists

}  // namespace

bool DemoHole::take(const HalfEdgeMesh& mesh, const DefectList& defectList) {
  const BoundaryLoop* longest = nullptr;
  for (const int id : defectList.holes()) {
    if (!longest || defectList.loop(id).length > longest->length) longest = &defectList.loop(id);
  }
  if (!longest) return false;
  m_region = longest->box;
  m_outward.setZero();
  for (const HalfEdge h : longest->halfEdges) {
    m_rim.insert(mesh.from(h));
    const TrianglePoints p = mesh.points(HalfEdgeMesh::face(h));
    m_outward += (p[1] - p[0]).cross(p[2] - p[0]);
  }
  m_outward = unobstructedDirection(mesh, m_region, m_outward);
  return true;
}

bool DemoHole::holds(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) const {
  return std::any_of(loop.halfEdges.begin(), loop.halfEdges.end(),
                     [&](HalfEdge h) { return m_rim.count(mesh.from(h)) != 0; });
}

const BoundaryLoop* DemoHole::nextPart(const HalfEdgeMesh& mesh, const DefectList& defectList) const {
  const BoundaryLoop* shortest = nullptr;
  for (const int id : defectList.holes()) {
    const BoundaryLoop& loop = defectList.loop(id);
    if (holds(mesh, loop) && (!shortest || loop.length < shortest->length)) shortest = &loop;
  }
  return shortest;
}

std::optional<BoundaryPair> DemoHole::waist(const HalfEdgeMesh& mesh, const BoundaryLoop& part) {
  const auto& rim = part.halfEdges;
  const auto least = static_cast<std::size_t>(kNarrow * static_cast<double>(rim.size()));
  std::vector<std::pair<double, BoundaryPair>> pairs;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    for (std::size_t j = i + least; j < rim.size() && j - i <= rim.size() - least; ++j) {
      pairs.push_back({(mesh.position(mesh.from(rim[i])) - mesh.position(mesh.from(rim[j]))).norm(), {rim[i], rim[j]}});
    }
  }
  const std::size_t tried = std::min(kMostTried, pairs.size());
  std::partial_sort(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(tried), pairs.end(),
                    [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < tried; ++i) {
    const BoundaryPair& ends = pairs[i].second;
    if (findBridge(FaceLocator(mesh, reachOf(mesh, ends)), ends).problem == JoinProblem::None) return ends;
  }
  return std::nullopt;
}

}  // namespace handwheel
