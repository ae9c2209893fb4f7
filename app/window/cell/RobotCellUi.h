// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/kinds/RigidPartsUi.h"

namespace handwheel {

class RobotCellKind;

// The user interface of robot cells: joint sliders and dragging the robot.
class RobotCellUi : public RigidPartsUi {
  Q_OBJECT

 public:
  RobotCellUi(const WindowContext& window, RobotCellKind& kind);

  QString panelTitle() const override { return tr("Joints"); }
  QString panelIcon() const override { return QStringLiteral("kind-cell"); }
  QString menuTitle() const override { return tr("&Cell"); }
  std::vector<StartAction> startActions() const override;
  std::vector<ToolDescriptor> tools() override;
  NextStep nextStep() override;
  QString statistics() const override;
  QString openedText(const DocumentTab& document) const override;

 private:
  std::unique_ptr<Tool> jointTool();
};

}  // namespace handwheel
