// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/repair/Repair.h"

#include <optional>

namespace handwheel {

// The numbers of boundary loops of a mesh by their outcomes after a change. The loop counts before and after the change
// do not show these numbers, because closing one loop may split another or join two.
struct OutcomeCounts {
  std::size_t all = 0;      // number before the change
  std::size_t closed = 0;   // closed by a patch, by stitching, or by thickening their sheet
  std::size_t removed = 0;  // removed with the faces around them
  std::size_t kept = 0;     // left open on purpose
  std::size_t joined = 0;   // left open as part of a former outer boundary of an open sheet
  std::size_t failed = 0;   // could not be closed

  bool operator==(const OutcomeCounts&) const = default;
};

struct LoopCounts {
  OutcomeCounts holes;
  OutcomeCounts sheetBoundaries;  // outer edges of open sheets
  std::size_t newOpenings = 0;    // openings that the change made and left open
  // The number of remaining loops that should have been closed, if it differs from the number of failed loops because
  // some were split or joined.
  std::optional<std::size_t> pieces;

  bool operator==(const LoopCounts&) const = default;
};

// Returns the counts of a repair.
LoopCounts countOutcomes(const RepairReport& report);

// Returns the counts of any other change, where no loop counts as kept or failed. Faces must keep their numbers from
// one mesh to the other. The counts are zero if cancelled. O(n log n) in border edges, O(n) in faces.
LoopCounts countClosed(const HalfEdgeMesh& before, const HalfEdgeMesh& after, Progress progress = {});

}  // namespace handwheel
