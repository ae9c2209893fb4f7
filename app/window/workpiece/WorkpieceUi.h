// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/kinds/RigidPartsUi.h"

namespace handwheel {

// The user interface of workpieces: the stock and its dimensions.
class WorkpieceUi : public RigidPartsUi {
  Q_OBJECT

 public:
  explicit WorkpieceUi(const WindowContext& parts);

  // A new document starts with the chord tolerance that the user chose; later changes are made by its own property.
  std::unique_ptr<OpenDocument> open(std::unique_ptr<Document> document) override;
  std::vector<StartAction> startActions() const override;
  QString panelTitle() const override { return tr("Stock"); }
  QString panelIcon() const override { return QStringLiteral("kind-workpiece"); }
  QString menuTitle() const override { return tr("&Workpiece"); }
  std::vector<ToolDescriptor> tools() override { return {measureParts()}; }
  NextStep nextStep() override;
  QString statistics() const override;
  QString openedText(const OpenDocument& document) const override;
};

}  // namespace handwheel
