// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/defects/RepairAccount.h"

#include "panels/defects/Inspection.h"
#include "text/RepairText.h"

#include <QCoreApplication>
#include <QLocale>

namespace handwheel {

namespace {

struct RepairAccountWords {
  Q_DECLARE_TR_FUNCTIONS(RepairAccount)
};

}  // namespace

QString defectPhrase(DefectKind kind, std::size_t count) {
  const int n = static_cast<int>(count);
  switch (kind) {
    case DefectKind::Hole:
      return RepairAccountWords::tr("%Ln hole(s)", nullptr, n);
    case DefectKind::KeptOpen:
      return RepairAccountWords::tr("%Ln outer boundary(ies) and kept hole(s)", nullptr, n);
    case DefectKind::NonManifoldEdge:
      return RepairAccountWords::tr("%Ln non-manifold edge(s)", nullptr, n);
    case DefectKind::NonManifoldVertex:
      return RepairAccountWords::tr("%Ln non-manifold vertex(ices)", nullptr, n);
    case DefectKind::OneSided:
      return RepairAccountWords::tr("%Ln one-sided edge(s)", nullptr, n);
    case DefectKind::InsideOut:
      return RepairAccountWords::tr("%Ln body(ies) inside out", nullptr, n);
    case DefectKind::Inconsistent:
      return RepairAccountWords::tr("%Ln inconsistent triangle(s)", nullptr, n);
    case DefectKind::NearVertex:
      return RepairAccountWords::tr("%Ln pair(s) of near vertices", nullptr, n);
    case DefectKind::Degenerate:
      return RepairAccountWords::tr("%Ln degenerate triangle(s)", nullptr, n);
    case DefectKind::Duplicate:
      return RepairAccountWords::tr("%Ln duplicate triangle(s)", nullptr, n);
    case DefectKind::SelfIntersection:
      return RepairAccountWords::tr("%Ln self-intersection(s)", nullptr, n);
    case DefectKind::Debris:
      return RepairAccountWords::tr("%Ln piece(s) of debris", nullptr, n);
    case DefectKind::Flipped:
      return RepairAccountWords::tr("%Ln reversed triangle(s)", nullptr, n);
  }
  return {};
}

QStringList repairAccount(const Inspection& inspection) {
  QStringList parts = outcomeTexts(inspection.loopOutcomes()), fresh;
  for (int i = 0; i < kDefectKinds; ++i) {
    const auto kind = static_cast<DefectKind>(i);
    const std::optional<std::size_t> before = inspection.countBefore(kind);
    if (!before || isLoopKind(kind) || kind == DefectKind::Flipped) continue;
    const std::size_t was = *before, is = inspection.count(kind);
    if (is > was) {
      fresh << defectPhrase(kind, is - was);
      continue;
    }
    const QString done = QLocale().toString(static_cast<int>(was - is)), all = defectPhrase(kind, was);
    const bool isTurned = kind == DefectKind::InsideOut || kind == DefectKind::Inconsistent;
    parts << (isTurned ? RepairAccountWords::tr("%1 of %2 corrected").arg(done, all)
                       : RepairAccountWords::tr("%1 of %2 removed").arg(done, all));
  }
  if (!fresh.isEmpty()) parts << RepairAccountWords::tr("new: %1").arg(fresh.join(QStringLiteral(", ")));
  return parts + inspection.doneBesides();
}

}  // namespace handwheel
