// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "document/Property.h"
#include "tools/Tool.h"

#include <QLabel>

namespace handwheel {

// A label in the view with the values and limits of a drag. Or with the label of a tool. Takes no input.
class ToolReadout : public QLabel {
 public:
  explicit ToolReadout(QWidget* view);

  // Shows the read-only settings; hides when there is none.
  void show(const std::vector<Property>& settings, LengthUnit unit, const QPoint& cursor);
  // Shows the figures of a tool beside its place in the view, to a hundredth of a millimetre.
  void show(const ToolLabel& label, LengthUnit unit, const QPoint& place);

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  void showText(const QString& text, const QPoint& place);
};

}  // namespace handwheel
