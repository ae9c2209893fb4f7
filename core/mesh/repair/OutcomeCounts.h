// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/repair/Repair.h"

#include <optional>

namespace handwheel {

// How many boundary loops of a mesh a change has closed, by their outcomes. Numbers of loops before and after tell
// nothing of that: closing one loop may split another or join two.
struct OutcomeCounts {
  std::size_t all = 0;      // that there were
  std::size_t closed = 0;   // by a patch, by stitching, or by thickening their sheet
  std::size_t removed = 0;  // gone with the faces around them
  std::size_t kept = 0;     // left open on purpose
  std::size_t joined = 0;   // left open, as part of what was the outer boundary of an open sheet
  std::size_t failed = 0;   // tried in vain

  bool operator==(const OutcomeCounts&) const = default;
};

struct LoopCounts {
  OutcomeCounts holes;
  OutcomeCounts sheetBoundaries;  // outer edges of open sheets
  std::size_t newOpenings = 0;    // that the change itself made and left
  // The loops at last that were to be closed, where they are not as many as failed: some were split or joined.
  std::optional<std::size_t> pieces;

  bool operator==(const LoopCounts&) const = default;
};

// The counts of a repair.
LoopCounts countOutcomes(const RepairReport& report);

// The counts of any other change: nobody tried to close what it leaves, so nothing counts as kept or failed. Faces keep
// their numbers from one mesh to the other. Zeros if cancelled. O(n log n) in border edges, O(n) in faces.
LoopCounts countClosed(const HalfEdgeMesh& before, const HalfEdgeMesh& after, Progress progress = {});

}  // namespace handwheel
