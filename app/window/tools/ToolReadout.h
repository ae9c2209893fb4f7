// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "document/Property.h"
#include "tools/Tool.h"

#include <QLabel>

namespace handwheel {

// A label in the view with the values and limits of a drag. It also shows the label of a tool. It takes no input.
class ToolReadout : public QLabel {
 public:
  explicit ToolReadout(QWidget* view);

  // Shows the read-only settings; hides if there are none.
  void show(const std::vector<Property>& settings, LengthUnit unit, const QPoint& cursor);
  // Shows the values of a tool at this position in the view, to a hundredth of a millimetre.
  void show(const ToolLabel& label, LengthUnit unit, const QPoint& position);

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  void showText(const QString& text, const QPoint& position);
};

}  // namespace handwheel
