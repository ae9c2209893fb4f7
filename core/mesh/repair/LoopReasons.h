// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/repair/HoleOutcomes.h"

namespace handwheel {

// Why a repair leaves boundary loops open. By its options before, and by what was tried in vain afterwards. Loops are
// named by those of the input along which they run, their owners.
class LoopReasons {
 public:
  // Both outlive it.
  LoopReasons(const RepairOptions& options, const std::vector<BoundaryLoop>& inputLoops)
      : m_options(options), m_inputLoops(inputLoops) {}

  // None for a loop that is to be filled.
  FillFailure beforeTrying(const BoundaryLoop& loop, const std::set<int>& owners) const;
  // Whether a loop with that reason is to be closed, by a patch or by a back.
  bool mayClose(FillFailure beforeTrying) const;

  // What was tried is noted anew in each round.
  void forget();
  void noteCutShort(const std::set<int>& owners);
  void noteSheet(const std::set<int>& owners, FillFailure failure);

  // Reports all loops with their outcomes and reasons. mesh: the result. isSpent: no effort is left.
  void conclude(HoleOutcomes& outcomes, const HalfEdgeMesh& mesh, bool isSpent, RepairReport& report,
                Progress progress) const;

 private:
  FillFailure atLast(const BoundaryLoop& loop, const std::set<int>& owners) const;
  FillFailure ofFailure(int id, FillFailure known, bool isSpent) const;
  bool isSheetBoundaryToKeep(const BoundaryLoop& loop, const std::set<int>& owners) const;

  static constexpr int kLaidOpen = LoopResult().id;

  const RepairOptions& m_options;
  const std::vector<BoundaryLoop>& m_inputLoops;
  std::set<int> m_cutShort;  // loops of the input, or kLaidOpen for any other, of which a trial was cut short at last
  std::map<int, FillFailure> m_sheetFailures;  // of the same, the outer edges of sheets that were not thickened at last
};

}  // namespace handwheel
