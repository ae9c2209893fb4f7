// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/kinds/RigidPartsUi.h"

namespace handwheel {

// The user interface of volumes.
class VolumeUi : public RigidPartsUi {
  Q_OBJECT

 public:
  explicit VolumeUi(const WindowContext& window);

  QString panelTitle() const override { return tr("Volume"); }
  QString panelIcon() const override { return QStringLiteral("kind-volume"); }
  QString menuTitle() const override { return tr("&Volume"); }
  std::vector<ToolDescriptor> tools() override { return {measureParts()}; }
  NextStep nextStep() override;
  QString openedText(const DocumentTab& document) const override;
};

}  // namespace handwheel
