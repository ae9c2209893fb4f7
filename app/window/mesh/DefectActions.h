// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "theme/DefectKind.h"
#include "tools/mesh/MeshServices.h"

#include <QAction>
#include <optional>

namespace handwheel {

class FidelityChoice;
class FixPreview;
class HolePreview;
class RepairJobs;
class LoopSelection;
struct FillOptions;
struct MeshTab;
struct DefectRow;
struct OfferedFix;

// The actions that repair selected defects other than holes. They apply to one defect, or to all of a kind, as selected
// in the list.
class DefectActions : public QObject {
  Q_OBJECT

 public:
  // shown: receives the offered fix to preview it.
  DefectActions(LoopSelection& selection, RepairJobs& jobs, const HolePreview& preview, FixPreview& shown,
                const FidelityChoice& fidelity, QObject* parent = nullptr);

  void setDocument(MeshTab* document);  // null: no mesh is in view
  // Sets the selection in the list: one row of a kind, or -1 for all rows.
  void choose(std::optional<DefectKind> kind, int row);
  // Sets the action whose button is under the pointer. The preview then shows the effect of this action, not the patch.
  void pointAt(const QAction* action, bool isPointed);

  // Returns the thickness that sheets will get, mm: the thickness that was set for this document, or else the default.
  // A mesh must be in view.
  double thickness() const;
  void setThickness(double thickness);

  QAction* fix() { return &m_fix; }                      // hidden if there is nothing to fix
  QAction* thickenSheet() { return &m_thickenSheet; }    // turns the selected sheet, or all sheets, into thin bodies
  QAction* cutAndClose() { return &m_cutAndClose; }      // hidden unless a patch would intersect the part
  QAction* reverseBodies() { return &m_reverseBodies; }  // reverses all bodies that are inside out
  QAction* resolveIntersections() { return &m_resolveIntersections; }  // resolves all intersections
  QAction* uniteBodies() { return &m_uniteBodies; }                    // unites all bodies that intersect
  QList<QAction*> all() {
    return {&m_fix, &m_thickenSheet, &m_cutAndClose, &m_reverseBodies, &m_resolveIntersections, &m_uniteBodies};
  }

 signals:
  // Emitted when the thickness that sheets will get may have changed.
  void thicknessChanged();

 private:
  void fixRow(const DefectRow& row);
  void follow();
  void followShown();
  void renewPreview();
  bool isFixable(DefectKind kind, int row) const;
  std::optional<MeshChange> change() const { return m_kind ? changeFor(*m_kind, m_row) : std::nullopt; }
  std::optional<MeshChange> changeFor(DefectKind kind, int row) const;  // -1: all rows
  MeshChange thickening() const;
  void nameThickening();
  MeshChange uniting() const;
  MeshChange cutting() const;
  std::optional<OfferedFix> offeredBy(const QAction* action) const;
  std::optional<OfferedFix> offered() const;
  int selectedLoop() const;         // -1: none
  std::vector<int> sheets() const;  // loop ids
  FillOptions options() const;

  MeshTab* m_document = nullptr;
  LoopSelection& m_selection;
  RepairJobs& m_jobs;
  const HolePreview& m_preview;
  FixPreview& m_shown;
  const FidelityChoice& m_fidelity;
  std::optional<DefectKind> m_kind;
  int m_row = -1;
  bool m_mayFix = false, m_mayCut = false;  // false if the preview shows that the action would change nothing
  const QAction* m_pointed = nullptr;       // action whose button has the pointer
  double m_thickness = 0.0;                 // mm; 0: the proposed one
  QAction m_fix;
  QAction m_thickenSheet;
  QAction m_cutAndClose;
  QAction m_reverseBodies;
  QAction m_resolveIntersections;
  QAction m_uniteBodies;
};

}  // namespace handwheel
