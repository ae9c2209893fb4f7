// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/LoopOwners.h"
#include "mesh/Repair.h"

#include <functional>
#include <map>

namespace handwheel {

// What became of each loop of the input while a repair changes, cuts and closes what was one loop at first. A loop in
// several pieces has the worst outcome of them.
class LoopResults {
 public:
  explicit LoopResults(const HalfEdgeMesh& input, Progress progress = {})
      : m_loops(findBoundaryLoops(input, progress)), m_owners(input, m_loops) {}

  const std::vector<BoundaryLoop>& inputLoops() const { return m_loops; }
  // Those of the input that a loop of the mesh as it is now runs along; none for one that the repair laid open.
  std::set<int> ownersOf(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) const { return m_owners.of(mesh, loop); }

  void record(LoopResult result, const std::set<int>& owners);
  // Closed after all, whatever was recorded before.
  void replace(const LoopResult& result, const std::set<int>& owners);

  // Why a loop is left open; None for one that ought to be closed.
  using ReasonToLeave = std::function<FillFailure(const BoundaryLoop&, const std::set<int>& owners)>;
  // All loops, by id, then those laid open; what is open in the mesh counts as open, whatever was tried before.
  std::vector<LoopResult> conclude(const HalfEdgeMesh& mesh, const ReasonToLeave& reasonToLeave, Progress progress);

 private:
  void recordOpen(const HalfEdgeMesh& mesh, const ReasonToLeave& reasonToLeave, Progress progress);

  std::vector<BoundaryLoop> m_loops;
  LoopOwners m_owners;
  std::map<int, LoopResult> m_results;
  std::vector<LoopResult> m_laidOpen;
};

}  // namespace handwheel
