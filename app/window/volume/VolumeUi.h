// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/haptics/ClayTouch.h"
#include "window/kinds/RigidPartsUi.h"

namespace handwheel {

class ClayLayersView;
class ClayTool;
class DrillView;
class RemeshAction;
class ReshapeActions;
class Segmentation;
class VolumeKind;
class StampAction;
class VolumeLayer;
class VoxelizeQuestion;
struct VolumeSnapshot;

// The user interface of volumes: their layer, the clay tool and the haptics of volumes.
class VolumeUi : public RigidPartsUi {
  Q_OBJECT

 public:
  VolumeUi(const WindowContext& window, VolumeKind& kind);
  ~VolumeUi() override;

  void setDocument(DocumentTab* document) override;
  void refreshVisibility() override;
  void forget(DocumentTab* document) override;
  void showPreview(const ToolPreview& preview) override;
  QString panelTitle() const override { return tr("Volume"); }
  QString panelIcon() const override { return QStringLiteral("kind-volume"); }
  QString menuTitle() const override { return tr("&Volume"); }
  QList<QAction*> menu() override;
  bool isSettled() const override;
  bool askToCopy(const Document& from, std::function<void(MakeOfSurface)> start) override;
  std::vector<StartAction> startActions() const override;
  void begin(const QString& startAction) override;
  std::vector<ToolDescriptor> tools() override;
  Suggestion suggestion() override;
  QString statistics() const override;
  QString openedText(const DocumentTab& document) const override;

 protected:
  DisplayModel displayed(const Document& document) const override;

 private:
  const VolumeSnapshot& volume() const;
  void showVolume();
  void offerStill();
  void followTool();
  void followFidelity();
  void refuseStroke();

  VolumeKind& m_kind;
  std::shared_ptr<VolumeLayer> m_volumeLayer;
  Segmentation* m_segmentation;
  std::shared_ptr<const void> m_drawn;  // volume shown in the layer: that of the document or of a tool
  ClayLayersView* m_layers;
  DrillView* m_drillView;
  ReshapeActions* m_reshape;
  RemeshAction* m_remesh;
  StampAction* m_stamp;
  VoxelizeQuestion* m_voxelize;
  std::shared_ptr<const ClayState> m_live;  // current result of a tool; null: none
  std::shared_ptr<ClayChannel> m_still;     // state of the document while no tool is active
  ClayTouch m_touch;
  // The planned path and forbidden region of the document's drilling exercise as displayed, and the JSON of the
  // exercise from which they were made.
  mutable std::shared_ptr<const nlohmann::json> m_plannedBy;
  mutable DisplayModel m_planned;
};

}  // namespace handwheel
