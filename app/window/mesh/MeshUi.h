// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/kinds/KindUi.h"
#include "window/mesh/DefectActions.h"
#include "window/mesh/HolePreview.h"
#include "window/mesh/LoopSelection.h"
#include "window/mesh/MeshHapticsProvider.h"
#include "window/mesh/MeshTools.h"
#include "window/mesh/ScriptExport.h"
#include "window/mesh/SectionView.h"
#include "window/mesh/SelfIntersectionSearch.h"
#include "window/mesh/ShellActions.h"
#include "window/mesh/demo/RepairDemo.h"
#include "window/mesh/deviation/DeviationView.h"
#include "window/mesh/repair/FixPreview.h"
#include "window/mesh/repair/RepairActions.h"
#include "window/mesh/repair/RepairJobs.h"

#include <QPointer>

class QStackedWidget;

namespace handwheel {

class DefectsPanel;
class DefectScene;
class MeshKind;
class MeshLayer;
class VolumeLayer;
struct ClayState;

// The user interface of meshes: the defects in panel and viewport, and the repair actions.
class MeshUi : public KindUi {
  Q_OBJECT

 public:
  // The kind must outlive this object.
  MeshUi(const WindowContext& parts, MeshKind& kind);
  ~MeshUi() override;

  std::unique_ptr<DocumentTab> open(std::unique_ptr<Document> document) override;
  void opened(DocumentTab& document) override;
  void setDocument(DocumentTab* document) override;
  void refreshVisibility() override;
  void showPreview(const ToolPreview& preview) override;
  QString panelTitle() const override { return m_deviation.isShown() ? tr("Deviation") : tr("Defects"); }
  QString panelIcon() const override { return QStringLiteral("defects"); }
  QWidget* panel() override;
  QString menuTitle() const override { return tr("&Repair"); }
  QList<QAction*> menu() override {
    return m_actions.all() + m_defectActions.all() + m_shells.all() << m_deviation.action() << m_scriptExport.action();
  }
  QList<QAction*> help() override { return {m_show.action()}; }
  QList<QAction*> toolBar() override;
  std::vector<StartAction> startActions() const override;
  std::vector<ToolDescriptor> tools() override;
  std::vector<Hint> hints() override;
  Suggestion suggestion() override;
  std::vector<Property> sectionMeasurements() const override { return m_section.statistics(); }
  QString statistics() const override;
  QString openedText(const DocumentTab& document) const override;
  QString saveCommand(const DocumentTab& document, const QString& path) const override;
  QString suggestedName(const DocumentTab& document) const override;
  bool isSettled() const override;

 private:
  void connectSelection();
  void followFidelity();
  void compareMethods();
  void logMark(const MeshTab& open);
  void showFix();
  void selectFaces();
  void offerVolume(MeshTab* tab, const char* reason);

  WindowContext m_parts;
  MeshKind& m_kind;
  std::shared_ptr<MeshLayer> m_layer;
  std::shared_ptr<VolumeLayer> m_voxelLayer;  // voxels of a tool
  std::shared_ptr<const ClayState> m_voxels;  // contents of the voxel layer; null: the layer is empty
  LoopSelection m_selection;
  HolePreview m_preview;
  SelfIntersectionSearch m_search;
  RepairJobs m_jobs;
  RepairActions m_actions;
  FixPreview m_fixPreview;
  DefectActions m_defectActions;
  ShellActions m_shells;
  ScriptExport m_scriptExport;
  QPointer<DefectsPanel> m_panel;
  DeviationView m_deviation;
  SectionView m_section;
  QPointer<QStackedWidget> m_panels;  // shows the defects panel or the deviation panel
  DefectScene* m_scene;
  MeshTools m_tools;
  MeshHapticsProvider m_touch;
  RepairDemo m_show;
  MeshTab* m_document = nullptr;
  FaceSelection m_selectedInTool;
};

}  // namespace handwheel
