// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/repair/RepairReasons.h"

#include "tools/mesh/repair/DefectFixChanges.h"
#include "tools/mesh/repair/DefectFixes.h"

#include <QCoreApplication>

namespace handwheel {

namespace {

constexpr const char* kNotTried =
    QT_TRANSLATE_NOOP("Tool", "“Repair all” leaves them as they are; they can be fixed here");

}  // namespace

std::map<Vertex, FillFailure> failuresOf(const RepairReport& report) {
  std::map<Vertex, FillFailure> failures;
  for (const OpenLoop& loop : report.openLoops)
    if (loop.outcome == LoopOutcome::Failed || loop.reason == FillFailure::WasSheetBoundary)
      failures[loop.key] = loop.reason;
  return failures;
}

DefectReasons reasonsOf(const RemainingDefects& left, const RepairReport& report, const RepairOptions& options) {
  const auto text = [](const char* reason) { return QCoreApplication::translate("Tool", reason); };
  DefectReasons reasons;
  const auto add = [&](DefectKind kind, const std::vector<const char*>& rows) {
    for (std::size_t row = 0; row < rows.size(); ++row) reasons.ofRow[{kind, static_cast<int>(row)}] = text(rows[row]);
  };
  add(DefectKind::NonManifoldEdge, left.nonManifoldEdges);
  add(DefectKind::NonManifoldVertex, left.nonManifoldVertices);
  add(DefectKind::OneSided, left.nonOrientableEdges);
  add(DefectKind::NearVertex, left.nearVertices);
  reasons.ofKind[DefectKind::Duplicate] = text(kPlateSides);
  reasons.ofKind[DefectKind::SelfIntersection] =
      text(report.isIntersectionRemovalIncomplete ? kTooLong : kNoCleanSeparation);
  if (!options.removeDebris) reasons.ofKind[DefectKind::Debris] = text(kNotTried);
  return reasons;
}

void noteReasons(DefectList& defectList, const MeshChange& change, std::optional<DefectRow> of, bool isSame) {
  if (change.sheets) defectList.setFailures(change.sheets->leftLoops);
  const char* const reason = reasonOf(change);
  if (reason && of && (isSame || of->row < 0))
    defectList.setReason(of->kind, of->row, QCoreApplication::translate("Tool", reason));
}

}  // namespace handwheel
