// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/repair/HoleOutcomes.h"

namespace handwheel {

// The reasons why a repair leaves boundary loops open. Before an attempt, they follow from the options of the repair;
// afterwards, from the failed attempts. Loops are identified by the input loops along which they run, their owners.
class LoopReasons {
 public:
  // options and inputLoops must outlive the object.
  LoopReasons(const RepairOptions& options, const std::vector<BoundaryLoop>& inputLoops)
      : m_options(options), m_inputLoops(inputLoops) {}

  // Returns the reason that is known before any attempt; None if the loop should be filled.
  FillFailure beforeTrying(const BoundaryLoop& loop, const std::set<int>& owners) const;
  // Returns true if a loop with this reason should be closed, by a patch or by thickening its sheet.
  bool mayClose(FillFailure beforeTrying) const;

  // Marks loops of islands that were joined to the hole around them: they are no longer sheet boundaries.
  void noteJoined(const std::set<int>& owners) { m_joined.insert(owners.begin(), owners.end()); }

  // Forgets the failed attempts, which are noted anew in each round.
  void forget();
  void noteCutShort(const std::set<int>& owners);
  void noteSheet(const std::set<int>& owners, FillFailure failure);

  // Reports all loops with their outcomes and reasons. mesh is the result; isSpent means that no effort is left.
  void conclude(HoleOutcomes& outcomes, const HalfEdgeMesh& mesh, bool isSpent, RepairReport& report,
                Progress progress) const;

 private:
  FillFailure atLast(const BoundaryLoop& loop, const std::set<int>& owners) const;
  FillFailure ofFailure(int id, FillFailure known, bool isSpent) const;
  bool isJoined(const std::set<int>& owners) const;
  bool isSheetBoundaryToKeep(const BoundaryLoop& loop, const std::set<int>& owners) const;

  static constexpr int kLaidOpen = LoopResult().id;

  const RepairOptions& m_options;
  const std::vector<BoundaryLoop>& m_inputLoops;
  std::set<int> m_joined;    // ids of the loops of joined islands
  std::set<int> m_cutShort;  // ids of the loops whose last trial was cut short; kLaidOpen if not in the input
  // Failures of outer edges of sheets that were not thickened in the last round, by the same ids as in m_cutShort.
  std::map<int, FillFailure> m_sheetFailures;
};

}  // namespace handwheel
