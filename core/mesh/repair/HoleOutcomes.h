// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryOwners.h"
#include "mesh/repair/Repair.h"

#include <functional>
#include <map>

namespace handwheel {

// Tracks the outcome of a repair for each boundary loop of the input. A repair may change, divide and close a loop; a
// loop that is left in several pieces has the worst of their outcomes.
class HoleOutcomes {
 public:
  explicit HoleOutcomes(const HalfEdgeMesh& input, Progress progress = {})
      : m_loops(findBoundaryLoops(input, progress)), m_owners(input, m_loops) {}

  const std::vector<BoundaryLoop>& inputLoops() const { return m_loops; }
  // Returns the input loops along which a loop of the current mesh runs. The set is empty if the repair opened the
  // loop.
  std::set<int> ownersOf(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) const { return m_owners.of(mesh, loop); }

  void record(LoopResult result, const std::set<int>& owners);
  // Records loops as closed and overrides their recorded outcomes.
  void replace(const LoopResult& result, const std::set<int>& owners);

  // A function that returns the reason why a loop is left open, or None for a loop that should be closed.
  using ReasonToLeave = std::function<FillFailure(const BoundaryLoop&, const std::set<int>& owners)>;
  // Returns the results of all input loops, by id, followed by the results of the loops that the repair opened. A loop
  // that is open in the mesh counts as open, regardless of recorded outcomes.
  std::vector<LoopResult> conclude(const HalfEdgeMesh& mesh, const ReasonToLeave& reasonToLeave, Progress progress);
  // An open loop of the mesh that was passed to conclude(), with the input loops along which it runs.
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
