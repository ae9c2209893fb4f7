// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/repair/RepairLog.h"

#include "panels/LogModel.h"
#include "panels/defects/RepairSummary.h"
#include "text/NoteText.h"
#include "text/RepairText.h"
#include "window/mesh/MeshTab.h"
#include "window/mesh/repair/RepairJobs.h"

namespace handwheel {

ChangeSummary changeSummaryOf(const MeshTab& document, const MeshChange& done, const QString& text) {
  const QString name = document.document.name();
  const LengthUnit unit = document.document.displayUnit();
  const QString separator = QStringLiteral(", ");
  const bool isMeasured = done.distance && *done.distance;
  const QStringList defects = done.isFix ? defectSummary(document.defectList) : QStringList();
  ChangeSummary summary;
  summary.isPartly = done.sheets && done.sheets->leftCount() > 0;
  const bool isThickened = !summary.isPartly && done.sheets && done.sheets->thickened > 0;
  QStringList how;
  if (summary.isPartly) how << sheetsText(*done.sheets, unit);
  if (isMeasured)
    how << RepairJobs::tr("largest distance found between the surface before and after %1")
               .arg(lengthText(**done.distance, unit));
  summary.hasLostWalls = done.volume && done.volume->hasLostWalls;
  const bool hasNotes = done.volume && !done.volume->notes.empty();
  if (summary.hasLostWalls && !hasNotes)
    how << RepairJobs::tr("walls thinner than a voxel were lost: choose smaller voxels");
  if (hasNotes)
    for (const Note& note : done.volume->notes) how << noteText(note);
  how << defects;
  summary.line = RepairJobs::tr("%1: %2").arg(name, text);
  if (isThickened) {
    const QString thickness = thicknessText(done.sheets->thickness, unit);
    summary.line = (QStringList(RepairJobs::tr("%1: %2 by %3").arg(name, text, thickness)) + how).join(separator);
    how.prepend(thickness);
  } else if (!how.isEmpty()) {
    summary.line = RepairJobs::tr("%1: %2: %3").arg(name, text, how.join(separator));
  }
  summary.how = how.join(separator);
  summary.isWorthMessage = isMeasured || !defects.isEmpty() || (isThickened && done.sheets->thickness.thinVertices > 0);
  return summary;
}

QStringList patchWarningsOf(const RepairReport& report, const std::map<int, QString>& names) {
  QStringList warnings;
  for (const LoopResult& loop : report.loops) {
    const QString warning = loop.outcome == LoopOutcome::Filled ? patchWarning(loop.shape) : QString();
    if (loop.id >= 0 && !warning.isEmpty())
      warnings << RepairJobs::tr("Check the patch of %1: %2.").arg(names.at(loop.id), warning);
  }
  return warnings;
}

QStringList doneBesides(RepairReport report, const std::map<DefectKind, std::size_t>& before,
                        const std::map<DefectKind, std::size_t>& after, LengthUnit unit) {
  const auto leaveOut = [&](DefectKind kind, std::size_t& removed) {
    const auto were = before.find(kind), are = after.find(kind);
    if (were != before.end() && are != after.end() && were->second == are->second + removed) removed = 0;
  };
  leaveOut(DefectKind::Degenerate, report.removedDegenerate);
  leaveOut(DefectKind::Duplicate, report.removedDuplicates);
  return repairSummary(report, unit);
}

void logRepair(LogModel& log, const MeshTab& document, const RepairReport& report, const std::map<int, QString>& names,
               const QString& command) {
  const QStringList summary = defectSummary(document.defectList);
  const QString part = document.document.name();
  log.add(summary.isEmpty() ? RepairJobs::tr("Repaired %1: nothing was changed").arg(part)
                            : RepairJobs::tr("Repaired %1: %2").arg(part, summary.join(QStringLiteral(", "))),
          command);
  if (report.removed)
    log.add(removalWarning(*report.removed, document.document.displayUnit()), {}, LogEntry::Weight::Warning);
  for (const QString& warning : patchWarningsOf(report, names)) log.add(warning, {}, LogEntry::Weight::Warning);
  for (const LoopResult& loop : report.loops) {
    const QString name = loop.id >= 0 ? names.at(loop.id) : RepairJobs::tr("A hole opened by the repair");
    if (loop.outcome == LoopOutcome::Filled && loop.newFaces > 0 && loop.substitute != Substitute::None)
      log.add(RepairJobs::tr("%1: %2").arg(name, substituteText(loop.substitute, loop.method)));
    if (loop.outcome == LoopOutcome::Failed)
      log.add(RepairJobs::tr("%1 stays open: %2").arg(name, fillFailureReason(loop.reason)), {},
              LogEntry::Weight::Warning);
  }
}

}  // namespace handwheel
