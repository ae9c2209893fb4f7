// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/cell/CellBodies.h"
#include "window/kinds/RigidPartsUi.h"

namespace handwheel {

class RobotCellKind;

// The user interface of robot cells: joint sliders, dragging the robot and the bodies beside it.
class RobotCellUi : public RigidPartsUi {
  Q_OBJECT

 public:
  RobotCellUi(const WindowContext& window, RobotCellKind& kind);

  QString panelTitle() const override { return tr("Joints"); }
  QString panelIcon() const override { return QStringLiteral("kind-cell"); }
  QString menuTitle() const override { return tr("&Cell"); }
  QList<QAction*> menu() override { return m_bodies.all(); }
  void setDocument(DocumentTab* document) override;
  bool isListed(const Property& property) const override;
  std::vector<StartAction> startActions() const override;
  std::vector<ToolDescriptor> tools() override;
  NextStep nextStep() override;
  QString statistics() const override;
  QString openedText(const DocumentTab& document) const override;

 private:
  std::unique_ptr<Tool> handTool();
  bool isInPanel(const Property& property) const override;

  CellBodies m_bodies;
};

}  // namespace handwheel
