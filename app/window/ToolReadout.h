// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "document/Property.h"

#include <QLabel>

namespace handwheel {

// Beside the cursor, while one drags: the values that a tool moves, with their limits. It takes no input.
class ToolReadout : public QLabel {
 public:
  explicit ToolReadout(QWidget* view);

  // Those of the settings that are measured, and not for the user to set; hides when there is none.
  void show(const std::vector<Property>& settings, LengthUnit unit, const QPoint& cursor);
};

}  // namespace handwheel
