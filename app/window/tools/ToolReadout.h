// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "document/Property.h"

#include <QLabel>

namespace handwheel {

// A label next to the cursor with the values that a drag changes. It shows their limits as well and takes no input.
class ToolReadout : public QLabel {
 public:
  explicit ToolReadout(QWidget* view);

  // Shows the read-only settings; hides when there is none.
  void show(const std::vector<Property>& settings, LengthUnit unit, const QPoint& cursor);

 protected:
  void hideEvent(QHideEvent* event) override;
};

}  // namespace handwheel
