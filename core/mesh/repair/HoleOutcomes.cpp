// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/HoleOutcomes.h"

#include <algorithm>

namespace handwheel {

void HoleOutcomes::record(LoopResult result, const std::set<int>& owners) {
  if (owners.empty()) {
    m_laidOpen.push_back(result);
    return;
  }
  for (int id : owners) {
    result.id = id;
    result.edges = m_loops[static_cast<std::size_t>(id)].borderEdges;
    const auto [at, isNew] = m_results.emplace(id, result);
    if (isNew) continue;
    LoopResult& known = at->second;
    known.milliseconds += result.milliseconds;
    known.newFaces += result.newFaces;
    if (result.outcome > known.outcome) {
      known.outcome = result.outcome;
      known.reason = result.reason;
    }
  }
}

void HoleOutcomes::replace(const LoopResult& result, const std::set<int>& owners) {
  for (int id : owners) m_results.erase(id);
  record(result, owners);
}

void HoleOutcomes::recordOpen(const HalfEdgeMesh& mesh, const ReasonToLeave& reasonToLeave, Progress progress) {
  std::erase_if(m_laidOpen, [](const LoopResult& r) { return r.outcome != LoopOutcome::Filled; });
  m_left.clear();
  std::map<int, FillFailure> reasons;
  for (const auto& [id, result] : m_results) {
    if (result.outcome == LoopOutcome::Failed) reasons[id] = result.reason;
  }
  std::erase_if(m_results, [](const auto& entry) { return entry.second.outcome != LoopOutcome::Filled; });
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh, progress)) {
    const std::set<int> owners = ownersOf(mesh, loop);
    LoopResult result;
    result.edges = loop.borderEdges;
    result.reason = reasonToLeave(loop, owners);
    result.outcome = result.reason == FillFailure::None ? LoopOutcome::Failed : LoopOutcome::KeptOpen;
    if (result.outcome == LoopOutcome::Failed) {
      const auto known = owners.empty() ? reasons.end() : reasons.find(*owners.begin());
      result.reason = known == reasons.end() ? FillFailure::SelfIntersecting : known->second;
    }
    m_left.push_back({{keyOf(mesh, loop), result.outcome, result.reason}, owners});
    record(result, owners);
  }
}

std::vector<LoopResult> HoleOutcomes::conclude(const HalfEdgeMesh& mesh, const ReasonToLeave& reasonToLeave,
                                               Progress progress) {
  recordOpen(mesh, reasonToLeave, progress);
  std::vector<LoopResult> all;
  for (const BoundaryLoop& loop : m_loops) {
    const auto at = m_results.find(loop.id);
    if (at != m_results.end()) {
      all.push_back(at->second);
      continue;
    }
    LoopResult closed;
    closed.id = loop.id;
    closed.edges = loop.borderEdges;
    closed.outcome = LoopOutcome::Filled;
    const bool isGone = std::none_of(loop.halfEdges.begin(), loop.halfEdges.end(),
                                     [&](HalfEdge h) { return mesh.isLive(HalfEdgeMesh::face(h)); });
    closed.method = isGone ? FillMethod::Removed : FillMethod::Stitched;
    all.push_back(closed);
  }
  for (std::size_t i = 0; i < m_loops.size(); ++i) all[i].isSheetBoundary = m_loops[i].isSheetBoundary;
  all.insert(all.end(), m_laidOpen.begin(), m_laidOpen.end());
  return all;
}

}  // namespace handwheel
