// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryOwners.h"
#include "mesh/repair/Repair.h"

#include <functional>
#include <map>

namespace handwheel {

// Tracks the outcome of a repair for each boundary loop of the input. A repair changes, cuts and closes what was one
// loop at first; a loop in several pieces has the worst outcome of them.
class HoleOutcomes {
 public:
  explicit HoleOutcomes(const HalfEdgeMesh& input, Progress progress = {})
      : m_loops(findBoundaryLoops(input, progress)), m_owners(input, m_loops) {}

  const std::vector<BoundaryLoop>& inputLoops() const { return m_loops; }
  // The input loops along which a loop of the current mesh runs; none for one that the repair opened.
  std::set<int> ownersOf(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) const { return m_owners.of(mesh, loop); }

  void record(LoopResult result, const std::set<int>& owners);
  // Records loops as closed, whatever was recorded before.
  void replace(const LoopResult& result, const std::set<int>& owners);

  // Why a loop is left open; None for one that ought to be closed.
  using ReasonToLeave = std::function<FillFailure(const BoundaryLoop&, const std::set<int>& owners)>;
  // The results of all loops, by id, then of those that the repair opened; what is open in the mesh counts as open,
  // whatever was tried before.
  std::vector<LoopResult> conclude(const HalfEdgeMesh& mesh, const ReasonToLeave& reasonToLeave, Progress progress);
  // The loops of that mesh, with the input loops along which they run.
  struct Left {
    OpenLoop loop;
    std::set<int> owners;
  };
  const std::vector<Left>& left() const { return m_left; }

 private:
  void recordOpen(const HalfEdgeMesh& mesh, const ReasonToLeave& reasonToLeave, Progress progress);

  std::vector<BoundaryLoop> m_loops;
  BoundaryOwners m_owners;
  std::map<int, LoopResult> m_results;
  std::vector<LoopResult> m_laidOpen;
  std::vector<Left> m_left;
};

}  // namespace handwheel
