// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/section/TurnedSection.h"

namespace handwheel {

// The difference of boundary loops and a cutter. If the removal is empty, there are no loops: nothing has changed.
struct SectionDifference {
  static constexpr double kSnap = 2e-8;  // mm; points nearer than this are one vertex

  std::vector<SharedLoop> loops;
  std::size_t unchanged = 0;  // number of leading loops that the cutter does not meet
  SectionRemoval removal;
};

// Returns the loops without the area of a cutter. The new segments keep the marks of the cutter. Only runs
// that meet the box of the cutter are changed; the others are shared. Returns nothing if the pieces do not close to
// loops, because curves nearly coincide; a cutter that is larger by a few kSnap then gives a result. Method: both
// boundaries are split where they meet, each piece is kept or dropped by the side on which its middle lies, and the
// kept pieces are chained (after Weiler & Atherton 1977).
std::optional<SectionDifference> differenceOf(const std::vector<SharedLoop>& loops, const SectionLoop& cutter);

// Returns true if a point is inside of the area that loops enclose. A point on the boundary may be either. O(runs + k)
// for the k segments of the runs that a ray from the point meets.
bool isInside(std::span<const SharedLoop> loops, const ProfilePoint& p);

}  // namespace handwheel
