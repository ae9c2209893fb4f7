// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/PartsUi.h"

namespace handwheel {

class CellKind;

// Robot cells in the window: the joints as sliders, and the robot to be dragged.
class CellUi : public PartsUi {
  Q_OBJECT

 public:
  CellUi(const WindowParts& window, CellKind& kind);

  QString panelTitle() const override { return tr("Joints"); }
  QString panelIcon() const override { return QStringLiteral("kind-cell"); }
  QString menuTitle() const override { return tr("&Cell"); }
  std::vector<Beginning> beginnings() const override;
  std::vector<ToolOffer> tools() override;
  NextStep nextStep() override;
  QString figures() const override;
  QString openedText(const OpenDocument& document) const override;

 private:
  std::unique_ptr<Tool> jointTool();
};

}  // namespace handwheel
