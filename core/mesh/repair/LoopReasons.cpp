// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/LoopReasons.h"

#include <algorithm>

namespace handwheel {

// Cuts and filled holes change the shape of a sheet, which may no longer look like one. Its former outer edge still
// counts as such.
bool LoopReasons::isJoined(const std::set<int>& owners) const {
  return std::any_of(owners.begin(), owners.end(), [&](int id) { return m_joined.contains(id); });
}

bool LoopReasons::isSheetBoundaryToKeep(const BoundaryLoop& loop, const std::set<int>& owners) const {
  const auto was = [&](int id) {
    return m_inputLoops[static_cast<std::size_t>(id)].isSheetBoundary && !m_joined.contains(id);
  };
  return loop.isSheetBoundary || std::any_of(owners.begin(), owners.end(), was);
}

FillFailure LoopReasons::beforeTrying(const BoundaryLoop& found, const std::set<int>& owners) const {
  // A hole with islands has a long boundary, like a frayed sheet.
  BoundaryLoop loop = found;
  loop.isSheetBoundary = loop.isSheetBoundary && !isJoined(owners);
  const auto kept = [&](int id) { return m_options.keepOpen.contains(id); };
  if (std::any_of(owners.begin(), owners.end(), kept)) return FillFailure::KeptOpen;
  if (m_options.sheets == SheetHandling::Keep && isSheetBoundaryToKeep(loop, owners))
    return loop.isSheetBoundary ? FillFailure::SheetBoundary : FillFailure::WasSheetBoundary;
  if (m_options.maxEdges > 0 && loop.borderEdges > m_options.maxEdges) return FillFailure::TooLong;
  return loop.isSheetBoundary && m_options.sheets == SheetHandling::Thicken ? FillFailure::SheetBoundary
                                                                            : FillFailure::None;
}

bool LoopReasons::mayClose(FillFailure beforeTrying) const {
  return beforeTrying == FillFailure::None ||
         (beforeTrying == FillFailure::SheetBoundary && m_options.sheets == SheetHandling::Thicken);
}

void LoopReasons::forget() {
  m_cutShort.clear();
  m_sheetFailures.clear();
}

void LoopReasons::noteCutShort(const std::set<int>& owners) {
  m_cutShort.insert(owners.begin(), owners.end());
  if (owners.empty()) m_cutShort.insert(kLaidOpen);
}

void LoopReasons::noteSheet(const std::set<int>& owners, FillFailure failure) {
  for (const int id : owners) m_sheetFailures[id] = failure;
  if (owners.empty()) m_sheetFailures[kLaidOpen] = failure;
}

// None for a loop that stays open although it was to be closed.
FillFailure LoopReasons::atLast(const BoundaryLoop& loop, const std::set<int>& owners) const {
  const FillFailure known = beforeTrying(loop, owners);
  if (known != FillFailure::SheetBoundary || m_options.sheets != SheetHandling::Thicken) return known;
  const auto isKept = [&](int id) {
    const auto failure = m_sheetFailures.find(id);
    return failure != m_sheetFailures.end() && failure->second == FillFailure::SheetKeptOpen;
  };
  return std::any_of(owners.begin(), owners.end(), isKept) ? FillFailure::SheetKeptOpen : FillFailure::None;
}

// Returns the reason why such a loop stays open. id is that of the input, or kLaidOpen for another loop. known is the
// failure of the last proposed patch.
FillFailure LoopReasons::ofFailure(int id, FillFailure known, bool isSpent) const {
  const auto sheet = m_sheetFailures.find(id);
  if (sheet != m_sheetFailures.end() && id != kLaidOpen) return sheet->second;
  return isSpent || m_cutShort.contains(id) ? FillFailure::TooMuchEffort : known;
}

void LoopReasons::conclude(HoleOutcomes& outcomes, const HalfEdgeMesh& mesh, bool isSpent, RepairReport& report,
                           Progress progress) const {
  const auto reason = [&](const BoundaryLoop& loop, const std::set<int>& owners) { return atLast(loop, owners); };
  report.loops = outcomes.conclude(mesh, reason, progress);
  for (LoopResult& loop : report.loops) {
    if (loop.outcome == LoopOutcome::Failed) loop.reason = ofFailure(loop.id, loop.reason, isSpent);
    if (loop.outcome == LoopOutcome::Filled && m_options.keepOpen.contains(loop.id))
      report.lostLoops.push_back(loop.id);
  }
  for (const HoleOutcomes::Left& left : outcomes.left()) {
    OpenLoop& loop = report.openLoops.emplace_back(left.loop);
    const int owner = left.owners.empty() ? kLaidOpen : *left.owners.begin();
    if (loop.outcome == LoopOutcome::Failed) loop.reason = ofFailure(owner, loop.reason, isSpent);
  }
}

}  // namespace handwheel
