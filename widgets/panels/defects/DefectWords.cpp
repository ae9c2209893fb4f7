// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/defects/DefectWords.h"

#include "base/Tolerance.h"

#include <QCoreApplication>

namespace handwheel {

namespace {

struct DefectWords {
  Q_DECLARE_TR_FUNCTIONS(DefectModel)
};

}  // namespace

QString defectKindName(DefectKind kind) {
  switch (kind) {
    case DefectKind::Hole:
      return DefectWords::tr("Holes");
    case DefectKind::KeptOpen:
      return DefectWords::tr("Boundaries kept open");
    case DefectKind::NonManifoldEdge:
      return DefectWords::tr("Non-manifold edges");
    case DefectKind::NonManifoldVertex:
      return DefectWords::tr("Non-manifold vertices");
    case DefectKind::OneSided:
      return DefectWords::tr("One-sided edges");
    case DefectKind::InsideOut:
      return DefectWords::tr("Inside out");
    case DefectKind::Inconsistent:
      return DefectWords::tr("Inconsistent triangles");
    case DefectKind::NearVertex:
      return DefectWords::tr("Near vertices");
    case DefectKind::Flipped:
      return DefectWords::tr("Reversed on opening");
    case DefectKind::Degenerate:
      return DefectWords::tr("Degenerate triangles");
    case DefectKind::Duplicate:
      return DefectWords::tr("Duplicate triangles");
    case DefectKind::SelfIntersection:
      return DefectWords::tr("Self-intersections");
    case DefectKind::Debris:
      return DefectWords::tr("Debris");
  }
  return {};
}

QString defectKindHint(DefectKind kind) {
  switch (kind) {
    case DefectKind::Hole:
      return DefectWords::tr("Places where the surface is missing. (A tunnel through the part is not a hole.)");
    case DefectKind::KeptOpen:
      return DefectWords::tr(
          "Outer boundaries of open sheets, and holes that you marked to keep open. “Repair all” does not close them.");
    case DefectKind::NonManifoldEdge:
      return DefectWords::tr("Edges at which more than two triangles meet.");
    case DefectKind::NonManifoldVertex:
      return DefectWords::tr("Vertices at which parts of the surface touch without sharing an edge.");
    case DefectKind::OneSided:
      return DefectWords::tr(
          "Edges at which inside becomes outside: like a Möbius strip, the surface has only one side.");
    case DefectKind::NearVertex:
      return DefectWords::tr("Vertices on open edges that differ only by rounding in the file. A repair merges them.");
    case DefectKind::InsideOut:
      return DefectWords::tr("Bodies whose triangles face inwards, so that inside and outside are swapped.");
    case DefectKind::Inconsistent:
      return DefectWords::tr(
          "Triangles with an orientation opposite to that of their neighbours. Opening a file reverses them, as the "
          "first step of the history; they are listed here where that step is undone.");
    case DefectKind::Flipped:
      return DefectWords::tr(
          "No longer a defect: triangles with an orientation opposite to that of their neighbours in the file were "
          "reversed on opening, as the first step of the history. If the neighbours were wrong, “Reverse faces” "
          "reverses the whole shell.");
    case DefectKind::Degenerate:
      return DefectWords::tr("Triangles without area.");
    case DefectKind::Duplicate:
      return DefectWords::tr("Triangles that lie exactly on another one.");
    case DefectKind::SelfIntersection:
      return DefectWords::tr(
          "Pairs of triangles that intersect. “Repair all” cuts them along each other and joins them so that none "
          "intersects another, where that leaves nothing else worse.");
    case DefectKind::Debris:
      return DefectWords::tr(
                 "Pieces apart from the largest one, with less than %1 % of its area and less than %2 % of its "
                 "triangles. “Remove debris” removes all, or only the piece selected here; any other piece is removed "
                 "with the tool “Select faces”.")
          .arg(100.0 * tolerance::kDebrisArea)
          .arg(100.0 * tolerance::kDebrisFaces);
  }
  return {};
}

}  // namespace handwheel
