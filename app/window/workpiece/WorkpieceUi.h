// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/PartsUi.h"

namespace handwheel {

// Workpieces in the window: the stock and its sizes.
class WorkpieceUi : public PartsUi {
  Q_OBJECT

 public:
  explicit WorkpieceUi(const WindowParts& parts);

  // A new one starts with the chord tolerance that the user chose; from then on its own property holds.
  std::unique_ptr<OpenDocument> open(std::unique_ptr<Document> document) override;
  std::vector<Beginning> beginnings() const override;
  QString panelTitle() const override { return tr("Stock"); }
  QString panelIcon() const override { return QStringLiteral("kind-workpiece"); }
  QString menuTitle() const override { return tr("&Workpiece"); }
  std::vector<ToolOffer> tools() override { return {measureParts()}; }
  NextStep nextStep() override;
  QString figures() const override;
  QString openedText(const OpenDocument& document) const override;
};

}  // namespace handwheel
