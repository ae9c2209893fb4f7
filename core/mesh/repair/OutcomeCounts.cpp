// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/OutcomeCounts.h"

#include "mesh/repair/HoleOutcomes.h"

#include <algorithm>

namespace handwheel {
namespace {

void count(const LoopResult& loop, LoopCounts& counts) {
  const bool isClosed = loop.outcome == LoopOutcome::Filled;
  if (loop.id < 0) {  // opened by the change itself
    counts.newOpenings += !isClosed;
    return;
  }
  OutcomeCounts& of = loop.isSheetBoundary ? counts.sheetBoundaries : counts.holes;
  ++of.all;
  if (isClosed) {
    ++(loop.method == FillMethod::Removed ? of.removed : of.closed);
  } else if (loop.outcome == LoopOutcome::KeptOpen) {
    ++(loop.reason == FillFailure::WasSheetBoundary && !loop.isSheetBoundary ? of.joined : of.kept);
  } else {
    ++of.failed;
  }
}

}  // namespace

LoopCounts countOutcomes(const RepairReport& report) {
  LoopCounts counts;
  for (const LoopResult& loop : report.loops) count(loop, counts);
  const auto isFailed = [](const auto& loop) { return loop.outcome == LoopOutcome::Failed; };
  const auto failed = std::count_if(report.loops.begin(), report.loops.end(), isFailed);
  const auto pieces = std::count_if(report.openLoops.begin(), report.openLoops.end(), isFailed);
  if (pieces != failed) counts.pieces = static_cast<std::size_t>(pieces);
  return counts;
}

LoopCounts countClosed(const HalfEdgeMesh& before, const HalfEdgeMesh& after, Progress progress) {
  HoleOutcomes outcomes(before, progress.part(0.0, 0.5));
  if (progress.cancelled()) return {};
  const auto leave = [](const BoundaryLoop&, const std::set<int>&) { return FillFailure::KeptOpen; };
  const std::vector<LoopResult> loops = outcomes.conclude(after, leave, progress.part(0.5, 1.0));
  if (progress.cancelled()) return {};
  LoopCounts counts;
  for (const LoopResult& loop : loops) count(loop, counts);
  counts.holes.kept = counts.sheetBoundaries.kept = 0;
  return counts;
}

}  // namespace handwheel
