// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/defects/RepairSummary.h"

#include "panels/defects/DefectList.h"
#include "text/RepairText.h"

#include <QCoreApplication>
#include <QLocale>

namespace handwheel {

namespace {

struct RepairSummaryWords {
  Q_DECLARE_TR_FUNCTIONS(RepairSummary)
};

}  // namespace

QString defectPhrase(DefectKind kind, std::size_t count) {
  const int n = static_cast<int>(count);
  switch (kind) {
    case DefectKind::Hole:
      return RepairSummaryWords::tr("%Ln hole(s)", nullptr, n);
    case DefectKind::KeptOpen:
      return RepairSummaryWords::tr("%Ln outer boundary(ies) and kept hole(s)", nullptr, n);
    case DefectKind::NonManifoldEdge:
      return RepairSummaryWords::tr("%Ln non-manifold edge(s)", nullptr, n);
    case DefectKind::NonManifoldVertex:
      return RepairSummaryWords::tr("%Ln non-manifold vertex(ices)", nullptr, n);
    case DefectKind::OneSided:
      return RepairSummaryWords::tr("%Ln one-sided edge(s)", nullptr, n);
    case DefectKind::InsideOut:
      return RepairSummaryWords::tr("%Ln body(ies) inside out", nullptr, n);
    case DefectKind::Inconsistent:
      return RepairSummaryWords::tr("%Ln inconsistent triangle(s)", nullptr, n);
    case DefectKind::NearVertex:
      return RepairSummaryWords::tr("%Ln pair(s) of near vertices", nullptr, n);
    case DefectKind::Degenerate:
      return RepairSummaryWords::tr("%Ln degenerate triangle(s)", nullptr, n);
    case DefectKind::Duplicate:
      return RepairSummaryWords::tr("%Ln duplicate triangle(s)", nullptr, n);
    case DefectKind::SelfIntersection:
      return RepairSummaryWords::tr("%Ln self-intersection(s)", nullptr, n);
    case DefectKind::Debris:
      return RepairSummaryWords::tr("%Ln piece(s) of debris", nullptr, n);
    case DefectKind::Flipped:
      return RepairSummaryWords::tr("%Ln reversed triangle(s)", nullptr, n);
  }
  return {};
}

QStringList defectSummary(const DefectList& defectList) {
  QStringList parts = outcomeTexts(defectList.loopOutcomes()), fresh;
  for (int i = 0; i < kDefectKinds; ++i) {
    const auto kind = static_cast<DefectKind>(i);
    const std::optional<std::size_t> before = defectList.countBefore(kind);
    if (!before || isLoopKind(kind) || kind == DefectKind::Flipped) continue;
    const std::size_t was = *before, is = defectList.count(kind);
    if (is > was) {
      fresh << defectPhrase(kind, is - was);
      continue;
    }
    const QString done = QLocale().toString(static_cast<int>(was - is)), all = defectPhrase(kind, was);
    const bool isTurned = kind == DefectKind::InsideOut || kind == DefectKind::Inconsistent;
    parts << (isTurned ? RepairSummaryWords::tr("%1 of %2 corrected").arg(done, all)
                       : RepairSummaryWords::tr("%1 of %2 removed").arg(done, all));
  }
  if (!fresh.isEmpty()) parts << RepairSummaryWords::tr("new: %1").arg(fresh.join(QStringLiteral(", ")));
  return parts + defectList.doneBesides();
}

}  // namespace handwheel
